// SPDX-License-Identifier: Apache-2.0
// Most of the powder moves in one or two crowds, a bed and the rain on it: who goes with which.
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "engine/simulation/simulation.hpp"

namespace pulvis {
namespace {

constexpr double crowds_differ_by = 0.1;   // radii between two rebuilds
constexpr double steps_of_crowds = 100.0;  // that two crowds go before lists are made again,
constexpr double farthest_apart = 3.0;  // up to so many radii: more pairs would be listed than are worth it

/// Of each component the median.
Vec3 median(std::vector<Vec3> some) {
  Vec3 middle;
  const auto at = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
  for (int axis = 0; axis < 3 && !some.empty(); ++axis) {
    std::nth_element(some.begin(), at, some.end(),
                     [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    middle[axis] = (*at)[axis];
  }
  return middle;
}

}  // namespace

std::uint8_t Simulation::nearer_crowd(const Vec3& velocity) const {
  const Vec3 from_first = velocity - drift_velocity_[0], from_second = velocity - drift_velocity_[1];
  return between_crowds_ > 0.0 && dot(from_second, from_second) < dot(from_first, from_first);
}

/// The velocities of the two crowds: what most of the powder has, by each component, and what most of the others have. Where
/// those are few, the second is how a body moves that most of the powder does not move with. False if there is but one.
bool Simulation::find_two_crowds(double far) {
  constexpr std::size_t enough = 255;
  const std::size_t count = state_.parcels.size();
  std::vector<Vec3> sample, others;
  for (std::size_t i = 0; i < count; i += 1 + count / enough)
    sample.push_back(state_.parcels.body[i].velocity);
  const Vec3 first = median(sample);
  std::copy_if(sample.begin(), sample.end(), std::back_inserter(others),
               [&](const Vec3& v) { return norm(v - first) > far; });
  drift_velocity_ = {first, first};
  if (others.size() > sample.size() / 20) {
    drift_velocity_[1] = median(others);
  } else {
    double fastest = 0.0;
    for (std::size_t b = 0; b < poses_.size(); ++b) {
      if (poses_[b].absent) continue;
      Vec3 middle;
      for (const Vec3& corner : body_corners_[b]) middle += 0.125 * corner;
      const Vec3 velocity = poses_[b].velocity(middle, model_.dt);
      if (norm(velocity - first) <= fastest) continue;
      fastest = norm(velocity - first);
      drift_velocity_[1] = velocity;
    }
  }
  if (norm(drift_velocity_[1] - first) > far) return true;
  drift_velocity_[1] = first;
  return false;
}

/// Finds the crowds and who belongs to which. What is dense is the first: the second looks for it from far.
void Simulation::choose_crowds(std::span<const std::uint32_t> old_index) {
  const std::size_t count = state_.parcels.size();
  drift_ = {};
  drift_velocity_ = {};
  between_crowds_ = 0.0;
  crowd_.assign(count, 0);
  body_crowd_.assign(poses_.size(), 0);
  if (model_.domain.shear.any()) return;
  const double far = crowds_differ_by * model_.smallest_radius / (model_.dt * steps_between_rebuilds);
  if (!find_two_crowds(far)) return;
  between_crowds_ = least(norm(drift_velocity_[1] - drift_velocity_[0]) * model_.dt * steps_of_crowds,
                          farthest_apart * model_.largest_radius);
  // By the lists as they were.
  const std::size_t old_count = pairs_.begin.empty() ? 0 : pairs_.begin.size() - 1;
  std::array<double, kernels::crowds> parcels{1.0, 1.0}, entries{};
  for (std::size_t i = 0; i < count; ++i) {
    if (old_index[i] >= old_count) continue;
    const std::uint8_t own = nearer_crowd(state_.parcels.body[i].velocity);
    parcels[own] += 1.0;
    entries[own] += pairs_.begin[old_index[i] + 1] - pairs_.begin[old_index[i]];
  }
  if (entries[1] / parcels[1] > entries[0] / parcels[0]) std::swap(drift_velocity_[0], drift_velocity_[1]);
  for (std::size_t i = 0; i < count; ++i) crowd_[i] = nearer_crowd(state_.parcels.body[i].velocity);
  for (std::size_t b = 0; b < poses_.size(); ++b)
    body_crowd_[b] = speed_against(drift_velocity_[1], b) < speed_against(drift_velocity_[0], b);
}

}  // namespace pulvis
