// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set; PULVIS_ISA is that set's name. Everything called from the loops is
// forced inline, so no code for a newer processor can leak into shared functions.
#include <array>

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

/// A contact as the parts of a law see it. Fields that a part does not ask for are never loaded.
PULVIS_INLINE void look(const ContactBlock& b, int k, double dt, laws::Touch& touch) {
  const Vec3 spin_first = load(b.spin_first, k), spin_second = load(b.spin_second, k);
  const Vec3 surface = b.half_arm_first[k] * spin_first + b.half_arm_second[k] * spin_second;
  touch.overlap = b.overlap[k];
  touch.radius = b.radius[k];
  touch.mass = b.mass[k];
  touch.was_touching = b.touching[k];
  touch.normal = load(b.normal, k);
  touch.half_normal = load(b.half_normal, k);
  touch.velocity = load(b.velocity, k) + cross(surface, touch.half_normal);
  touch.spin = spin_first - spin_second;
  touch.dt = dt;
}

template <class Part>
PULVIS_INLINE void evaluate_normal(ContactBlock& b, int k, const typename Part::Pair& pair) {
  const double overlap = b.overlap[k], radius = b.radius[k];
  b.touching[k] = laws::touches(overlap, b.touching[k], Part::separation_gap(radius, pair));
  const laws::Normal n = Part::normal(overlap, radius, pair);
  b.elastic[k] = n.elastic;
  b.contact_size[k] = n.contact_size;
  b.damping_size[k] = n.damping_size;
  b.limit_shift[k] = n.limit_shift;
}

template <class Part>
PULVIS_INLINE void evaluate_damping(ContactBlock& b, int k, const typename Part::Pair& pair,
                                    const laws::Whole& whole) {
  laws::Touch touch;
  look(b, k, 0.0, touch);
  const laws::Normal n{b.elastic[k], b.contact_size[k], b.damping_size[k], b.limit_shift[k]};
  const laws::Dashpots c = Part::coefficients(n, touch.mass, pair);
  const double closing = laws::closing_speed(touch);
  store(b.slip, k, laws::slip_velocity(touch, closing));
  const double dashpot = c.normal * closing;
  b.normal_force[k] = n.elastic + dashpot;
  b.limiting_force[k] = laws::limiting_force(n, dashpot, whole);
  b.tangential_damping[k] = c.tangential;
}

/// Also puts the forces together, and the torques they exert about the centres.
template <class Part>
PULVIS_INLINE void evaluate_sliding(ContactBlock& b, int k, const typename Part::Pair& pair, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  Vec3 spring = load(b.slide, k);
  const Vec3 tangential = Part::slide(touch, load(b.slip, k), b.contact_size[k], b.limiting_force[k],
                                      b.tangential_damping[k], pair, spring);
  const double touching = b.touching[k];
  store(b.slide, k, touching * spring);
  store(b.force, k, touching * (tangential - b.normal_force[k] * touch.normal));
  const Vec3 moment = cross(touch.normal, touching * tangential);
  store(b.torque_first, k, b.arm_first[k] * moment);
  store(b.torque_second, k, b.arm_second[k] * moment);
}

template <class Part>
PULVIS_INLINE void evaluate_rolling(ContactBlock& b, int k, const typename Part::Pair& pair, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const Vec3 torque =
      touch.was_touching * Part::roll(touch, b.contact_size[k], b.limiting_force[k], load(b.roll, k), pair);
  store(b.roll, k, torque);
  store(b.torque_first, k, load(b.torque_first, k) + torque);
  store(b.torque_second, k, load(b.torque_second, k) - torque);
}

// --- the stages: loops over the block ---------------------------------------------------------------------

static void geometry_stage(ContactBlock& b, const double*, double dt) {
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) derive_geometry(b, k, dt);
}

template <class Part>
static void normal_stage(ContactBlock& b, const double* constants, double) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::normal);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_normal<Part>(b, k, pair);
}

template <class Part>
static void damping_stage(ContactBlock& b, const double* constants, double) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::damping);
  const auto whole = laws::unpack<laws::Whole>(constants, laws::Place::whole);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_damping<Part>(b, k, pair, whole);
}

template <class Part>
static void sliding_stage(ContactBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::sliding);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_sliding<Part>(b, k, pair, dt);
}

template <class Part>
static void rolling_stage(ContactBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::rolling);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_rolling<Part>(b, k, pair, dt);
}

template <class... Parts>
static ContactKernel::Stage normal_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{normal_stage<Parts>...}[index];
}
template <class... Parts>
static ContactKernel::Stage damping_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{damping_stage<Parts>...}[index];
}
template <class... Parts>
static ContactKernel::Stage sliding_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{sliding_stage<Parts>...}[index];
}
template <class... Parts>
static ContactKernel::Stage rolling_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{rolling_stage<Parts>...}[index];
}

ContactKernel contact_kernel(const laws::Law& law) {
  return {geometry_stage, normal_stage_of(laws::NormalParts{}, law.normal->index),
          damping_stage_of(laws::DampingParts{}, law.damping->index),
          sliding_stage_of(laws::SlidingParts{}, law.sliding->index),
          rolling_stage_of(laws::RollingParts{}, law.rolling->index)};
}

}  // namespace PULVIS_ISA
}  // namespace pulvis::kernels
