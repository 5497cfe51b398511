// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "engine/simulation/simulation.hpp"

// What tests read off a simulation.
namespace pulvis::scenes {

inline const Parcel& parcel_with_id(const Simulation& s, std::uint32_t id) {
  const auto& body = s.state().parcels.body;
  const auto at = std::find_if(body.begin(), body.end(), [&](const Parcel& p) { return p.id == id; });
  if (at == body.end()) throw std::out_of_range("parcel " + std::to_string(id) + " is not there any more");
  return *at;
}

inline Vec3 momentum(const Parcels& parcels) {
  Vec3 sum;
  for (const Parcel& p : parcels.body) sum += p.mass * p.velocity;
  return sum;
}

inline Vec3 angular_momentum(const Parcels& parcels) {
  Vec3 sum;
  for (const Parcel& p : parcels.body) sum += p.mass * cross(p.position, p.velocity) + inertia(p) * p.spin;
  return sum;
}

inline double kinetic_energy(const Parcels& parcels) {
  double sum = 0.0;
  for (const Parcel& p : parcels.body)
    sum += 0.5 * p.mass * dot(p.velocity, p.velocity) + 0.5 * inertia(p) * dot(p.spin, p.spin);
  return sum;
}

template <class Near>
std::size_t touching(const Near& near) {
  return static_cast<std::size_t>(std::count(near.touching.begin(), near.touching.end(), 1));
}

}  // namespace pulvis::scenes
