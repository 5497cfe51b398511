// SPDX-License-Identifier: Apache-2.0
#include "measures/flow.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace pulvis::measures {
namespace {

void check_list(std::span<const std::uint32_t> ids, std::size_t places) {
  if (ids.size() != places) throw std::invalid_argument("FlowMeter: there must be one place for each parcel");
  if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) != ids.end())
    throw std::invalid_argument("FlowMeter: ids must ascend");
}

}  // namespace

FlowMeter::FlowMeter(const FlowSurface& surface, const Vec3& period) : surface_(surface), period_(period) {
  const bool flat = surface.shape == FlowSurface::Shape::parallelogram;
  normal_ = flat ? cross(surface.edge_one, surface.edge_two) : surface.normal;
  const double length = norm(normal_);
  const bool has_area = surface.shape != FlowSurface::Shape::disc || surface.radius > 0.0;
  if (!(length > 0.0 && std::isfinite(length) && has_area))
    throw std::invalid_argument("FlowMeter: the surface has no normal or no area");
  normal_ = normal_ / length;
}

void FlowMeter::restore(State state) {
  check_list(state.ids, state.places.size());
  state_ = std::move(state);
}

Flow FlowMeter::look(std::span<const std::uint32_t> ids, std::span<const Vec3> places,
                     std::span<const double> masses) {
  check_list(ids, places.size());
  if (masses.size() != ids.size())
    throw std::invalid_argument("FlowMeter: there must be one mass for each parcel");
  Flow now;
  std::size_t before = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    while (before < state_.ids.size() && state_.ids[before] < ids[i]) ++before;
    if (before == state_.ids.size()) break;
    if (state_.ids[before] != ids[i]) continue;
    const int direction = crossing(state_.places[before], places[i]);
    if (direction > 0) {
      now.forward_mass += masses[i];
      ++now.forward_count;
    } else if (direction < 0) {
      now.backward_mass += masses[i];
      ++now.backward_count;
    }
  }
  state_.flow.forward_mass += now.forward_mass;
  state_.flow.backward_mass += now.backward_mass;
  state_.flow.forward_count += now.forward_count;
  state_.flow.backward_count += now.backward_count;
  state_.ids.assign(ids.begin(), ids.end());
  state_.places.assign(places.begin(), places.end());
  return now;
}

Vec3 FlowMeter::shortest(const Vec3& way) const {
  Vec3 result = way;
  for (int axis = 0; axis < 3; ++axis)
    if (period_[axis] > 0.0) result[axis] -= period_[axis] * std::round(way[axis] / period_[axis]);
  return result;
}

/// 1: forwards, -1: backwards, 0: not at all.
int FlowMeter::crossing(const Vec3& from, const Vec3& to) const {
  const auto crosses = [&](const Vec3& begin, const Vec3& end) {
    const double was = dot(begin - surface_.point, normal_), is = dot(end - surface_.point, normal_);
    if ((was >= 0.0) == (is >= 0.0)) return 0;
    const double share = was / (was - is);
    if (!holds(begin + share * (end - begin))) return 0;
    return is >= 0.0 ? 1 : -1;
  };
  const Vec3 way = to - from, short_way = shortest(way);
  const int straight = crosses(to - short_way, to);
  if (straight != 0 || short_way == way) return straight;
  // Across a periodic face the same way lies on both sides of the space; the surface may be on either.
  return crosses(from, from + short_way);
}

bool FlowMeter::holds(const Vec3& on_plane) const {
  const Vec3 from_point = on_plane - surface_.point;
  if (surface_.shape == FlowSurface::Shape::plane) return true;
  if (surface_.shape == FlowSurface::Shape::disc)
    return dot(from_point, from_point) <= surface_.radius * surface_.radius;
  // Its share of each edge, from the areas it makes with the other.
  const Vec3 &one = surface_.edge_one, &two = surface_.edge_two;
  const double area = dot(cross(one, two), normal_);
  const double along_one = dot(cross(from_point, two), normal_) / area;
  const double along_two = dot(cross(one, from_point), normal_) / area;
  return 0.0 <= along_one && along_one < 1.0 && 0.0 <= along_two && along_two < 1.0;
}

}  // namespace pulvis::measures
