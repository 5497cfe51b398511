// SPDX-License-Identifier: Apache-2.0
// When the near lists are made anew, and how: margins, the order of the store, contacts carried over.
#include <fmt/format.h>

#include <algorithm>

#include "engine/base/failure.hpp"
#include "engine/base/parallel.hpp"
#include "engine/simulation/simulation.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t steps_between_sorts = 2000;
constexpr double least_margin = 0.02;  // radii, with a skin of 1

}  // namespace

/// How fast each parcel is against its crowd, m/s, or the fastest of what it could meet before the lists are made anew, each
/// against its own: it may take that speed over when they collide. Those are in the lists as they were. What another crowd
/// does to it is left to relisting.
std::vector<double> Simulation::expected_speeds(std::span<const std::uint32_t> old_index) const {
  const std::size_t count = state_.parcels.size(),
                    old_count = pairs_.begin.empty() ? 0 : pairs_.begin.size() - 1;
  std::vector<double> speed(count), old_speed(old_count, 0.0);
  parallel_shares(count, threads(), [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i) {
      const Parcel& p = state_.parcels.body[i];
      const Vec3 own = p.velocity - drift_velocity_[crowd_[i]] - model_.domain.flow_velocity(p.position);
      speed[i] = norm(own) + 0.5 * magnitude(model_.domain.shear.rate) * p.radius;
      if (old_index[i] < old_count) old_speed[old_index[i]] = speed[i];
    }
  });
  std::vector<double> of_body(poses_.size());
  for (std::size_t b = 0; b < of_body.size(); ++b)
    of_body[b] = speed_against(drift_velocity_[body_crowd_[b]], b);
  parallel_shares(count, threads(), [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i) {
      const std::uint32_t old = old_index[i];
      if (old >= old_count) continue;
      for (std::uint32_t k = pairs_.begin[old]; k < pairs_.begin[old + 1]; ++k)
        speed[i] = greatest(speed[i], old_speed[pairs_.partner(pairs_.entry[k])]);
      for (std::uint32_t slot = walls_.begin[old]; slot < walls_.begin[old + 1]; ++slot)
        speed[i] = greatest(speed[i], of_body[model_.walls.surfaces[walls_.surface[slot]].body]);
    }
  });
  return speed;
}

/// Fast parcels get wide margins and slow ones narrow ones: in a filling die the dense bed is slow and the fast rain is
/// dilute, so lists stay short where there are many parcels.
/// No margin is less than the way of the next step (up to 0.5 radius): contacts must end by their law only.
double Simulation::margin_for(double speed, double radius) const {
  const double wish = speed * model_.dt * steps_between_rebuilds / radius;
  return radius *
         std::clamp(1.2 * wish + least_margin * model_.skin, least_margin * model_.skin, widest_margin());
}

void Simulation::choose_margins(std::span<const std::uint32_t> old_index) {
  choose_crowds(old_index);
  margin_.resize(state_.parcels.size());
  const std::vector<double> speed = expected_speeds(old_index);
  parallel_shares(margin_.size(), threads(), [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i) margin_[i] = margin_for(speed[i], state_.parcels.body[i].radius);
  });
  body_margin_.resize(poses_.size());
  for (std::size_t b = 0; b < poses_.size(); ++b)
    body_margin_[b] =
        least_margin * model_.skin * model_.smallest_radius +
        1.2 * speed_against(drift_velocity_[body_crowd_[b]], b) * model_.dt * steps_between_rebuilds;
}

double Simulation::speed_against(const Vec3& velocity, std::size_t body) const {
  double speed = 0.0;
  for (const Vec3& corner : body_corners_[body])
    speed = greatest(speed, norm(poses_[body].velocity(corner, model_.dt) - velocity));
  return speed;
}

void Simulation::find_body_corners() {
  for (std::uint32_t b = 0; b < poses_.size(); ++b) {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    bool bounded = true;
    for (const Surface& s : model_.walls.surfaces)
      if (s.body == b && s.kind != Surface::Kind::patch) bounded = include(s, low, high) && bounded;
    for (const FacetedWall& mesh : model_.walls.meshes)
      if (model_.walls.surfaces[mesh.first_surface].body == b) mesh.include(low, high);
    if (!bounded) {  // what lies in the domain now may have come from beyond it
      low = model_.domain.min - model_.domain.extent();
      high = model_.domain.max + model_.domain.extent();
    }
    std::array<Vec3, 8> corners;
    for (unsigned k = 0; k < 8; ++k)
      corners[k] = {k & 1u ? high.x : low.x, k & 2u ? high.y : low.y, k & 4u ? high.z : low.z};
    body_corners_.push_back(corners);
  }
}

bool Simulation::a_body_left_its_margin() const {
  // A displacement is linear in the point, so its largest size lies at a corner.
  for (std::size_t b = 0; b < poses_.size(); ++b)
    for (const Vec3& corner : body_corners_[b])
      if (norm(poses_[b].now(corner) - body_reference_[b](corner) - drift_[body_crowd_[b]]) > body_margin_[b])
        return true;
  return false;
}

void Simulation::sort_along_space(std::vector<std::uint32_t>& old_index) {
  // Slice by slice along the longest axis of the powder, row by row in a slice: what is not yet done with while a step
  // goes through the store is a slice or two, and two threads share one cut. Along a periodic axis it is twice as much, since
  // the first slice meets the last.
  const std::size_t count = state_.parcels.size();
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Parcel& p : state_.parcels.body)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = least(low[axis], p.position[axis]);
      high[axis] = greatest(high[axis], p.position[axis]);
    }
  int axes[3] = {0, 1, 2};
  const auto length = [&](int axis) {
    return (high[axis] - low[axis]) * (model_.domain.periodic[axis] ? 0.5 : 1.0);
  };
  std::sort(axes, axes + 3, [&](int a, int b) { return length(a) > length(b); });
  const double edge = 4.0 * model_.largest_radius;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> key(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 d = (state_.parcels.body[i].position - low) / edge;
    const auto at = [&](int axis) { return static_cast<std::uint64_t>(least(d[axes[axis]], 2e6)); };
    key[i] = {at(0) << 42 | at(1) << 21 | at(2), static_cast<std::uint32_t>(i)};
  }
  std::sort(key.begin(), key.end());
  Parcels sorted;
  sorted.body.resize(count);
  sorted.load.resize(count);
  std::vector<std::uint32_t> index(count);
  for (std::size_t k = 0; k < count; ++k) {
    sorted.body[k] = state_.parcels.body[key[k].second];
    sorted.load[k] = state_.parcels.load[key[k].second];
    index[k] = old_index[key[k].second];
  }
  state_.parcels = std::move(sorted);
  old_index = std::move(index);
}

void Simulation::rebuild() {
  pairs_.settle_late(state_.parcels);
  const TouchingList old_pairs = pairs_.pack(state_.parcels, threads()), old_walls = walls_.pack();
  rebuild(old_pairs, old_walls, same_order(state_.parcels.size()));
}

std::vector<std::uint32_t> Simulation::rebuild(const TouchingList& old_pairs, const TouchingList& old_walls,
                                               std::vector<std::uint32_t> old_index) {
  if (rebuilds_++ == 0 || state_.step - sorted_at_ >= steps_between_sorts) {
    sort_along_space(old_index);
    sorted_at_ = state_.step;
  }
  choose_margins(old_index);
  const std::size_t count = state_.parcels.size();
  reference_.resize(count);
  parallel_shares(count, threads(), [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i) reference_[i] = state_.parcels.body[i].position;
  });
  body_reference_.resize(poses_.size());
  for (std::size_t b = 0; b < poses_.size(); ++b) body_reference_[b] = poses_[b].now;

  pairs_.rebuild({state_.parcels, model_.classes, margin_, reach_, model_.domain, images_.slide, crowd_,
                  between_crowds_},
                 threads());
  rebuilt_at_ = state_.step;
  late_search_.forget();
  notice_.forget_left();
  walls_.rebuild(wall_search(), threads());
  const std::size_t pairs_found = pairs_.restore(old_pairs, old_index, state_.parcels, threads());
  const std::size_t walls_found = walls_.restore(old_walls, old_index);
  const std::size_t found = pairs_found + (walls_may_be_left_ ? old_walls.size() : walls_found);

  sort_wall_slots();

  // Contacts may end only by separation or with a parcel that was taken out.
  if (old_pairs.begin.size() == count + 1 && found != old_pairs.size() + old_walls.size())
    throw Failure(Exit::internal_check,
                  fmt::format("a rebuild of the neighbour lists kept {} of {} contacts at t = {:.6g} s",
                              found, old_pairs.size() + old_walls.size(), time()));
  times_.book(Task::near_lists);
  return old_index;
}

void Simulation::sort_wall_slots() {
  wall_slots_by_id_ = same_order(walls_.slots());
  std::stable_sort(wall_slots_by_id_.begin(), wall_slots_by_id_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return state_.parcels.body[walls_.parcel[a]].id < state_.parcels.body[walls_.parcel[b]].id;
  });
}

}  // namespace pulvis
