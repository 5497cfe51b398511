// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set; PULVIS_ISA is that set's name. Everything called from the loops is
// forced inline, so no code for a newer processor can leak into shared functions.
#include <cstring>

#include "engine/kernels/contact_block.hpp"
#include "engine/laws/catalogue.hpp"

namespace pulvis::kernels {
namespace PULVIS_ISA {

PULVIS_INLINE Vec3 load(const Lanes3& lanes, int k) { return {lanes.x[k], lanes.y[k], lanes.z[k]}; }
PULVIS_INLINE void store(Lanes3& lanes, int k, const Vec3& value) {
  lanes.x[k] = value.x;
  lanes.y[k] = value.y;
  lanes.z[k] = value.z;
}

// The bodies of the loops are functions of their own: inside an `omp simd` loop every local variable with
// an address would become an array, and the loop would not be vectorised.

/// Geometry of two spheres from their staged states.
PULVIS_INLINE void derive_geometry(ContactBlock& b, int k, double dt) {
  const Vec3 offset = load(b.offset, k);
  const Vec3 half_offset = offset + (0.5 * dt) * load(b.velocity, k);  // where they were dt/2 ago
  const double distance = norm(offset);
  store(b.normal, k, offset / distance);
  const double half_distance = norm(half_offset);
  store(b.half_normal, k, half_offset / half_distance);
  const double r1 = b.radius_first[k], r2 = b.radius_second[k];
  const double m1 = b.mass_first[k], m2 = b.mass_second[k];
  const double overlap = (r1 + r2) - distance;
  b.overlap[k] = overlap;
  b.radius[k] = r1 * r2 / (r1 + r2);
  b.mass[k] = m1 * m2 / (m1 + m2);
  b.arm_first[k] = r1 - 0.5 * overlap;
  b.arm_second[k] = r2 - 0.5 * overlap;
  const double half_overlap = (r1 + r2) - half_distance;
  b.half_arm_first[k] = r1 - 0.5 * half_overlap;
  b.half_arm_second[k] = r2 - 0.5 * half_overlap;
}

template <class Law>
PULVIS_INLINE void evaluate(ContactBlock& b, int k, const typename Law::Pair& pair, double dt) {
  const Vec3 normal = load(b.normal, k), half_normal = load(b.half_normal, k);
  const Vec3 spin_first = load(b.spin_first, k), spin_second = load(b.spin_second, k);
  const double arm_first = b.arm_first[k], arm_second = b.arm_second[k];
  const Vec3 surface = b.half_arm_first[k] * spin_first + b.half_arm_second[k] * spin_second;
  const laws::Touch touch{b.overlap[k],
                          b.radius[k],
                          b.mass[k],
                          b.touching[k],
                          normal,
                          half_normal,
                          load(b.velocity, k) + cross(surface, half_normal),
                          spin_first - spin_second,
                          dt};
  const laws::History old{load(b.slide, k), load(b.roll, k)};

  const laws::Response r = Law::evaluate(touch, old, pair);

  const Vec3 moment = cross(normal, r.tangential);
  b.touching[k] = r.touching;
  store(b.force, k, r.force);
  store(b.torque_first, k, arm_first * moment + r.roll_torque);
  store(b.torque_second, k, arm_second * moment - r.roll_torque);
  store(b.slide, k, r.history.slide);
  store(b.roll, k, r.history.roll);
}

template <class Law>
static void apply(ContactBlock& b, const double* pair_constants, double dt) {
  typename Law::Pair pair;
  std::memcpy(static_cast<void*>(&pair), pair_constants, sizeof pair);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate<Law>(b, k, pair, dt);
}

template <class Law>
static void apply_to_parcels(ContactBlock& b, const double* pair_constants, double dt) {
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) derive_geometry(b, k, dt);
  apply<Law>(b, pair_constants, dt);
}

ContactKernel contact_kernel(std::size_t law) {
  ContactKernel kernel[laws::law_count];
  std::size_t k = 0;
  laws::for_each_law([&]<class Law>() { kernel[k++] = {apply_to_parcels<Law>, apply<Law>}; });
  return kernel[law];
}

}  // namespace PULVIS_ISA
}  // namespace pulvis::kernels
