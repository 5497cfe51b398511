// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set; PULVIS_ISA is that set's name. Everything called from the loops is
// forced inline, so no code for a newer processor can leak into shared functions.
#include <array>
#include <cstddef>

#include "engine/kernels/contact_block.hpp"
#include "engine/laws/catalogue.hpp"
#include "engine/parcels/domain.hpp"

namespace pulvis::kernels {
namespace PULVIS_ISA {

void add_exchange(ContactKernel& kernel);  // engine/kernels/exchange_kernels.cpp

static bool any_in_reach(const ContactBlock& b, double approach) {
  const int count = b.count;
  double any = 0.0;
#pragma omp simd reduction(+ : any)
  for (int k = 0; k < count; ++k) any += select((b.overlap[k] > -approach) | (b.touching[k] > 0.5), 1.0, 0.0);
  return any != 0.0;
}

// --- one contact in its lane ------------------------------------------------------------------------------
//
// The bodies of the loops are functions of their own: inside an `omp simd` loop every local variable with
// an address would become an array, and the loop would not be vectorised.

/// Geometry of two spheres from their staged states.
PULVIS_INLINE void derive_geometry(ContactBlock& b, int k, double dt) {
  const Vec3 offset = NearestImage{b.period}(load(b.offset, k));
  const Vec3 half_offset = offset + (0.5 * dt) * load(b.velocity, k);  // where they were dt/2 ago
  const double distance = norm(offset);
  store(b.normal, k, (1.0 / distance) * offset);
  const double half_distance = norm(half_offset);
  store(b.half_normal, k, (1.0 / half_distance) * half_offset);
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
  touch.shared_spin = b.shared_spin[k];
  touch.radius_first = b.radius_first[k];
  touch.radius_second = b.radius_second[k];
  touch.mass_first = b.mass_first[k];
  touch.mass_second = b.mass_second[k];
}

PULVIS_INLINE void put_wall_sizes(ContactBlock& b, int k) {
  b.radius_first[k] = b.radius[k];
  b.radius_second[k] = 0.0;
  b.mass_first[k] = b.mass[k];
  b.mass_second[k] = 0.0;
}

template <class Part>
PULVIS_INLINE void evaluate_reach(ContactBlock& b, int k, const typename Part::Pair& pair) {
  laws::Touch touch;
  look(b, k, 0.0, touch);
  b.in_reach[k] = laws::touches(touch.overlap, touch.was_touching, Part::formation_gap(touch, pair),
                                Part::separation_gap(touch, pair));
}

// A loop with a long chain of operations leaves the processor waiting, since it has no room for many contacts at a time. So some
// parts say what can be had beforehand, and get a loop for that and another for the rest.
/// A normal law that solves an equation in a few steps, after it has made a factor of R*.
template <class Part>
concept SolvesAnEquation = requires(const laws::Touch& touch, double x, const typename Part::Pair& pair) {
  Part::size_factor(x);
  Part::first_guess(Part::equation(x, x, x, pair));
  Part::improved(x, x);
  Part::normal(touch, x, x, pair);
};
/// What a spring would be without its limit.
template <class Part>
concept SlidesInTwoSteps = requires(const laws::Touch& touch, const Vec3& v) {
  Part::trial(touch, v, v);
};
template <class Part>
concept RollsInTwoSteps = requires(const laws::Touch& touch, const Vec3& v, const typename Part::Pair& pair) {
  Part::trial(touch, 0.0, pair, v);
};

PULVIS_INLINE void put_normal(ContactBlock& b, int k, double touching, const laws::Normal& n) {
  b.touching[k] = touching;
  b.elastic[k] = n.elastic;
  b.contact_size[k] = n.contact_size;
  b.damping_size[k] = n.damping_size;
  b.limit_shift[k] = n.limit_shift;
}

template <class Part>
PULVIS_INLINE void evaluate_normal(ContactBlock& b, int k, const typename Part::Pair& pair) {
  laws::Touch touch;
  look(b, k, 0.0, touch);
  const double gap = Part::separation_gap(touch.radius, pair);
  const double touching = laws::touches(touch.overlap, touch.was_touching, 0.0, gap);
  double plastic = 0.0, adhesion = 0.0;
  if constexpr (Part::remembers) plastic = b.memory->plastic[k], adhesion = b.memory->adhesion[k];
  put_normal(b, k, touching, Part::normal(touch, pair, plastic, adhesion));
  if constexpr (Part::remembers)
    b.memory->plastic[k] = touching * plastic, b.memory->adhesion[k] = touching * adhesion;
}

/// What a law has found of each contact that solves an equation.
struct Solving {
  alignas(64) Lane factor, equation, solution;
};
template <SolvesAnEquation Part>
PULVIS_INLINE void evaluate_normal(ContactBlock& b, int k, const Solving& of,
                                   const typename Part::Pair& pair) {
  laws::Touch touch;
  look(b, k, 0.0, touch);
  const double gap = Part::separation_gap(touch.radius, of.factor[k], pair);
  put_normal(b, k, laws::touches(touch.overlap, touch.was_touching, 0.0, gap),
             Part::normal(touch, of.factor[k], of.solution[k], pair));
}

template <class Part>
PULVIS_INLINE void evaluate_damping(ContactBlock& b, int k, const typename Part::Pair& pair,
                                    const laws::Whole& whole, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const laws::Normal n{b.elastic[k], b.contact_size[k], b.damping_size[k], b.limit_shift[k]};
  const laws::Dashpots c = Part::coefficients(n, touch.mass, pair);
  const double closing = laws::closing_speed(touch);
  b.closing[k] = closing;
  b.shared_spin[k] = 0.5 * dot(load(b.spin_first, k) + load(b.spin_second, k), touch.half_normal);
  store(b.slip, k, laws::slip_velocity(touch, closing));
  const double dashpot = laws::dashpot_force(c.normal, closing, touch);
  b.normal_force[k] = n.elastic + dashpot;
  b.limiting_force[k] = laws::limiting_force(n, dashpot, whole);
  b.tangential_damping[k] = c.tangential;
}

template <class Part>
PULVIS_INLINE void evaluate_cohesion(ContactBlock& b, int k, const typename Part::Pair& pair,
                                     const laws::Whole& whole) {
  laws::Touch touch;
  look(b, k, 0.0, touch);
  if constexpr (Part::reaches) b.touching[k] = greatest(touch.was_touching, b.in_reach[k]);
  const laws::Attraction a = Part::attraction(touch, pair);
  b.normal_force[k] = b.normal_force[k] - a.pull + a.viscous_normal * b.closing[k];
  b.limiting_force[k] = laws::limiting_force(b.limiting_force[k], b.contact_size[k], a, whole);
  if constexpr (Part::is_viscous) b.drag[k] = a.viscous_tangential;
}

template <class Part>
PULVIS_INLINE void try_sliding(ContactBlock& b, int k, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  store(b.springs->slide, k, Part::trial(touch, load(b.slip, k), load(b.springs->slide, k)));
}

/// Also puts the forces together, and the torques they exert about the centres.
template <class Part>
PULVIS_INLINE void evaluate_sliding(ContactBlock& b, int k, const typename Part::Pair& pair, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  Vec3 spring = load(b.springs->slide, k), tangential;
  double grip = 0.0;
  if constexpr (Part::remembers_grip) grip = b.memory->grip[k];
  const double size = b.contact_size[k], limit = magnitude(b.limiting_force[k]);
  if constexpr (SlidesInTwoSteps<Part>)
    tangential = Part::limited(touch, load(b.slip, k), size, limit, b.tangential_damping[k], pair, spring);
  else
    tangential =
        Part::slide(touch, load(b.slip, k), size, limit, b.tangential_damping[k], pair, spring, grip);
  const double touching = b.touching[k], held = select(size > 0.0, touching, 0.0);
  store(b.springs->slide, k, held * spring);
  if constexpr (Part::remembers_grip) b.memory->grip[k] = held * grip;
  store(b.force, k, touching * (tangential - b.normal_force[k] * touch.normal));
  const Vec3 moment = cross(touch.normal, touching * tangential);
  store(b.torque_first, k, b.arm_first[k] * moment);
  store(b.torque_second, k, b.arm_second[k] * moment);
}

template <class Rolling>
PULVIS_INLINE void try_rolling(ContactBlock& b, int k, const typename Rolling::Pair& rolling, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  store(b.springs->roll, k, Rolling::trial(touch, b.contact_size[k], rolling, load(b.springs->roll, k)));
}

template <class Rolling>
PULVIS_INLINE void limit_rolling(ContactBlock& b, int k, const typename Rolling::Pair& rolling, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const double limit = magnitude(b.limiting_force[k]);
  const double held = select(b.contact_size[k] > 0.0, touch.was_touching, 0.0);
  const Vec3 acting = held * Rolling::limited(touch, limit, rolling, load(b.springs->roll, k));
  store(b.springs->roll, k, acting);
  store(b.torque_first, k, load(b.torque_first, k) + acting);
  store(b.torque_second, k, load(b.torque_second, k) - acting);
}

template <class Rolling, class Twisting>
PULVIS_INLINE void evaluate_rolling(ContactBlock& b, int k, const typename Rolling::Pair& rolling,
                                    const typename Twisting::Pair& twisting, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const double size = b.contact_size[k], limit = magnitude(b.limiting_force[k]);
  const double held = select(size > 0.0, touch.was_touching, 0.0);
  Vec3 spring = load(b.springs->roll, k);
  double twist = 0.0, twisted = 0.0;  // torque, and the part of it that is remembered
  if constexpr (Twisting::acts) {
    const Vec3 before = laws::normal_before(touch.normal, touch.half_normal);
    twisted = dot(spring, before);
    spring = spring - twisted * before;
    twist = Twisting::twist(touch, size, limit, b.tangential_damping[k], twisting, twisted);
  }
  Vec3 torque = Rolling::roll(touch, size, limit, rolling, spring);
  if constexpr (Twisting::acts) {
    torque = torque + twist * touch.normal;
    spring = spring + twisted * touch.normal;
  }
  const Vec3 acting = held * torque;
  store(b.springs->roll, k, held * spring);
  store(b.torque_first, k, load(b.torque_first, k) + acting);
  store(b.torque_second, k, load(b.torque_second, k) - acting);
}

PULVIS_INLINE void evaluate_drag(ContactBlock& b, int k) {
  const Vec3 normal = load(b.normal, k);
  const Vec3 drag = b.touching[k] * laws::drag_force(load(b.slip, k), normal, b.drag[k]);
  const Vec3 moment = cross(normal, drag);
  store(b.force, k, load(b.force, k) + drag);
  store(b.torque_first, k, load(b.torque_first, k) + b.arm_first[k] * moment);
  store(b.torque_second, k, load(b.torque_second, k) + b.arm_second[k] * moment);
}

// --- the stages: loops over the block ---------------------------------------------------------------------

static double* along(Lanes3& lanes, int axis) { return axis == 0 ? lanes.x : axis == 1 ? lanes.y : lanes.z; }

/// Only where the domain is sheared. Where the image was dt/2 ago follows from its velocity.
static void images_stage(ContactBlock& b, const double*, double) {
  const int count = b.count;
  const double height = b.slide.height, shift = b.slide.shift, jump = b.slide.jump;
  double *across = along(b.offset, b.slide.gradient), *offset = along(b.offset, b.slide.flow),
         *velocity = along(b.velocity, b.slide.flow);
#pragma omp simd
  for (int k = 0; k < count; ++k) {
    const double crossed = Slide::crossed(across[k], height);
    across[k] -= crossed * height;
    offset[k] -= crossed * shift;
    velocity[k] += crossed * jump;
  }
}

static void geometry_stage(ContactBlock& b, const double*, double dt) {
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) derive_geometry(b, k, dt);
}

static void wall_sizes_stage(ContactBlock& b, const double*, double) {
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) put_wall_sizes(b, k);
}

template <class Part>
static void reach_stage(ContactBlock& b, const double* constants, double) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::cohesion);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_reach<Part>(b, k, pair);
}

template <SolvesAnEquation Part>
static void solve(ContactBlock& b, Solving& of, const typename Part::Pair& pair) {
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) of.factor[k] = Part::size_factor(b.radius[k]);
#pragma omp simd
  for (int k = 0; k < count; ++k) {
    of.equation[k] = Part::equation(b.overlap[k], b.radius[k], of.factor[k], pair);
    of.solution[k] = Part::first_guess(of.equation[k]);
  }
  for (int step = 0; step < Part::improvements; ++step)
#pragma omp simd
    for (int k = 0; k < count; ++k) of.solution[k] = Part::improved(of.solution[k], of.equation[k]);
}

template <class Part>
static void normal_stage(ContactBlock& b, const double* constants, double) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::normal);
  const int count = b.count;
  if constexpr (SolvesAnEquation<Part>) {
    Solving of;
    solve<Part>(b, of, pair);
#pragma omp simd
    for (int k = 0; k < count; ++k) evaluate_normal<Part>(b, k, of, pair);
  } else {
#pragma omp simd
    for (int k = 0; k < count; ++k) evaluate_normal<Part>(b, k, pair);
  }
}

template <class Part>
static void damping_stage(ContactBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::damping);
  const auto whole = laws::unpack<laws::Whole>(constants, laws::Place::whole);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_damping<Part>(b, k, pair, whole, dt);
}

template <class Part>
static void cohesion_stage(ContactBlock& b, const double* constants, double) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::cohesion);
  const auto whole = laws::unpack<laws::Whole>(constants, laws::Place::whole);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_cohesion<Part>(b, k, pair, whole);
}

template <class Part>
static void sliding_stage(ContactBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::sliding);
  const int count = b.count;
  if constexpr (SlidesInTwoSteps<Part>) {
#pragma omp simd
    for (int k = 0; k < count; ++k) try_sliding<Part>(b, k, dt);
  }
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_sliding<Part>(b, k, pair, dt);
}

template <class Rolling, class Twisting>
static void rolling_stage(ContactBlock& b, const double* constants, double dt) {
  const auto rolling = laws::unpack<typename Rolling::Pair>(constants, laws::Place::rolling);
  const auto twisting = laws::unpack<typename Twisting::Pair>(constants, laws::Place::twisting);
  const int count = b.count;
  if constexpr (RollsInTwoSteps<Rolling> && !Twisting::acts) {
#pragma omp simd
    for (int k = 0; k < count; ++k) try_rolling<Rolling>(b, k, rolling, dt);
#pragma omp simd
    for (int k = 0; k < count; ++k) limit_rolling<Rolling>(b, k, rolling, dt);
    return;
  }
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_rolling<Rolling, Twisting>(b, k, rolling, twisting, dt);
}

static void drag_stage(ContactBlock& b, const double*, double) {
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) evaluate_drag(b, k);
}

// --- the stages of a law ----------------------------------------------------------------------------------

using Stage = ContactKernel::Stage;

template <class... Parts>
static Stage normal_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{normal_stage<Parts>...}[index];
}
template <class... Parts>
static Stage damping_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{damping_stage<Parts>...}[index];
}
template <class... Parts>
static Stage sliding_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{sliding_stage<Parts>...}[index];
}
template <class Twisting, class... Parts>
static Stage rolling_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{rolling_stage<Parts, Twisting>...}[index];
}

/// Not every part of cohesion has each stage; those that are not there are null.
template <class Part>
static constexpr Stage reach_stage_if_any() {
  if constexpr (Part::reaches) return reach_stage<Part>;
  return nullptr;
}
template <class Part>
static constexpr Stage cohesion_stage_if_any() {
  if constexpr (Part::acts) return cohesion_stage<Part>;
  return nullptr;
}
template <class... Parts>
static Stage reach_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array<Stage, sizeof...(Parts)>{reach_stage_if_any<Parts>()...}[index];
}
template <class... Parts>
static Stage cohesion_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array<Stage, sizeof...(Parts)>{cohesion_stage_if_any<Parts>()...}[index];
}

ContactKernel contact_kernel(const laws::Law& law) {
  ContactKernel kernel;
  add_exchange(kernel);
  kernel.any_in_reach = any_in_reach;
  kernel.images = images_stage;
  kernel.geometry = geometry_stage;
  if (law.cohesion->needs_sizes || law.rolling->needs_sizes) kernel.wall_sizes = wall_sizes_stage;
  if (law.cohesion->reaches) kernel.append(reach_stage_of(laws::CohesionParts{}, law.cohesion->index));
  kernel.append(normal_stage_of(laws::NormalParts{}, law.normal->index));
  kernel.append(damping_stage_of(laws::DampingParts{}, law.damping->index));
  if (law.cohesion->acts) kernel.append(cohesion_stage_of(laws::CohesionParts{}, law.cohesion->index));
  kernel.append(sliding_stage_of(laws::SlidingParts{}, law.sliding->index));
  kernel.append(
      law.twisting->acts
          ? rolling_stage_of<laws::twisting::ElasticPlastic>(laws::RollingParts{}, law.rolling->index)
          : rolling_stage_of<laws::twisting::None>(laws::RollingParts{}, law.rolling->index));
  if (law.cohesion->is_viscous) kernel.append(drag_stage);
  return kernel;
}

}  // namespace PULVIS_ISA
}  // namespace pulvis::kernels
