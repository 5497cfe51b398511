// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// One simulated sphere. What a contact reads of its two parcels lies together, so that a random access
/// costs two cache lines. SI; id and species never change.
struct Parcel {
  Vec3 position;
  double radius = 0.0;
  Vec3 velocity;
  double mass = 0.0;
  Vec3 spin;
  std::uint32_t id = 0;       ///< permanent, below 2^31, in order of insertion
  std::uint32_t species = 0;  ///< row of the table of contact classes
};
static_assert(sizeof(Parcel) == 96);

/// Sum of what acts on a parcel, about its centre: N and N m.
struct Load {
  Vec3 force, torque;
};

/// The store: two arrays in the same, arbitrary order (sorted along space now and then).
struct Parcels {
  std::vector<Parcel> body;
  std::vector<Load> load;

  std::size_t size() const { return body.size(); }
};

/// Moment of inertia of a solid sphere, kg m^2: (2/5) m r^2.
PULVIS_INLINE double inertia(const Parcel& p) { return 0.4 * p.mass * (p.radius * p.radius); }

inline double sphere_volume(double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; }

}  // namespace pulvis
