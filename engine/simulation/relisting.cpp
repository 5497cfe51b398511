// SPDX-License-Identifier: Apache-2.0
// Single parcels that leave their margins while the near lists are good for all others.
#include <algorithm>

#include "engine/base/parallel.hpp"
#include "engine/simulation/simulation.hpp"

namespace pulvis {

/// How fast a parcel and what is near it now are against its crowd, m/s.
double Simulation::speed_around(std::uint32_t parcel) const {
  const auto speed_of = [&](std::uint32_t i) {
    return norm(state_.parcels.body[i].velocity - drift_velocity_[crowd_[parcel]]);
  };
  double speed = speed_of(parcel);
  for (std::uint32_t k = pairs_.begin[parcel]; k < pairs_.begin[parcel + 1]; ++k)
    speed = greatest(speed, speed_of(pairs_.partner(pairs_.entry[k])));
  return speed;
}

/// Gives those that left their margins new ones, from where they are now, and lists what is near them. False where all lists
/// must be made anew, or that is cheaper.
bool Simulation::relist_those_that_left() {
  // Each looks at all others that were looked from.
  const std::size_t count = state_.parcels.size(), most = 100 + std::min<std::size_t>(count / 150, 4000);
  if (model_.domain.shear.any() || late_search_.looked() >= most) return false;
  std::vector<std::uint32_t> left;
  std::vector<std::vector<std::uint32_t>> of_thread(static_cast<std::size_t>(threads()));
  const std::size_t begin = notice_.left_from;
  parallel_shares(notice_.left_to - begin, threads(), [&](std::size_t from, std::size_t to, int thread) {
    for (std::size_t i = begin + from; i < begin + to; ++i) {
      const Vec3 since = state_.parcels.body[i].position - reference_[i] - drift_[crowd_[i]];
      if (dot(since, since) > margin_[i] * margin_[i])
        of_thread[static_cast<std::size_t>(thread)].push_back(static_cast<std::uint32_t>(i));
    }
  });
  for (const auto& some : of_thread) left.insert(left.end(), some.begin(), some.end());
  if (late_search_.looked() + left.size() > most) return false;
  for (const std::uint32_t i : left) {
    crowd_[i] = nearer_crowd(state_.parcels.body[i].velocity);
    reference_[i] = state_.parcels.body[i].position - drift_[crowd_[i]];
    margin_[i] = margin_for(speed_around(i), state_.parcels.body[i].radius);
    WallSearch wanted = wall_search();
    wanted.between_crowds = between_crowds_left();
    if (walls_.would_miss(i, wanted)) return false;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> near;
  const Leeway own = leeway();
  const ListedAt lists{state_.parcels,
                       own,
                       drift_,
                       reach_,
                       between_crowds_,
                       between_crowds_left(),
                       1.0001 * (1.0 + widest_margin()) * model_.largest_radius,
                       model_.domain};
  for (const std::uint32_t i : left) late_search_.look_from(i, lists, near);
  if (!pairs_.has_room_for(near.size())) return false;
  pairs_.add(std::move(near), state_.parcels);
  relisted_ += left.size();
  times_.book(Task::near_lists);
  return true;
}

}  // namespace pulvis
