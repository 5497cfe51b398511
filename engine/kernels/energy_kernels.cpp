// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as contact_kernels.cpp and by the same rules. The law is gone through once more,
// from what the contacts remembered before the step, and each part's share of their energy is written into lanes. The
// hot loops know nothing of it.
#include <array>

#include "engine/kernels/energy_block.hpp"
#include "engine/laws/catalogue.hpp"
#include "engine/laws/stored_energy.hpp"
#include "engine/parcels/domain.hpp"

namespace pulvis::kernels {
namespace PULVIS_ISA {
namespace {

using laws::in_plane;

PULVIS_INLINE double& term(EnergyBlock& b, EnergyTerm which, int k) {
  return b.term[static_cast<std::size_t>(which)][k];
}

// --- one contact in its lane ------------------------------------------------------------------------------

PULVIS_INLINE void derive_geometry(EnergyBlock& b, int k, double dt) {
  const NearestImage nearest{b.period};
  const Vec3 offset = nearest(load(b.offset, k)), linear = load(b.linear, k);
  const Vec3 half_offset = offset + (0.5 * dt) * linear, offset_before = offset + dt * linear;
  const double distance = norm(offset), half_distance = norm(half_offset);
  const Vec3 normal = (1.0 / distance) * offset, half_normal = (1.0 / half_distance) * half_offset;
  const double r1 = b.radius_first[k], r2 = b.radius_second[k];
  const double m1 = b.mass_first[k], m2 = b.mass_second[k];
  const double overlap = (r1 + r2) - distance, half_overlap = (r1 + r2) - half_distance;
  const Vec3 spin_first = load(b.spin_first, k), spin_second = load(b.spin_second, k);
  const Vec3 end_first = load(b.end_spin_first, k), end_second = load(b.end_spin_second, k);
  const Vec3 surface = (r1 - 0.5 * half_overlap) * spin_first + (r2 - 0.5 * half_overlap) * spin_second;
  const Vec3 end_surface = (r1 - 0.5 * overlap) * end_first + (r2 - 0.5 * overlap) * end_second;
  store(b.normal, k, normal);
  store(b.half_normal, k, half_normal);
  store(b.velocity, k, linear + cross(surface, half_normal));
  store(b.end_velocity, k, load(b.end_linear, k) + cross(end_surface, normal));
  store(b.spin, k, spin_first - spin_second);
  store(b.end_spin, k, end_first - end_second);
  b.overlap[k] = overlap;
  b.overlap_before[k] = (r1 + r2) - norm(offset_before);
  b.radius[k] = r1 * r2 / (r1 + r2);
  b.mass[k] = m1 * m2 / (m1 + m2);
  b.shared_spin[k] = 0.5 * dot(spin_first + spin_second, half_normal);
}

PULVIS_INLINE void look(const EnergyBlock& b, int k, double dt, laws::Touch& touch) {
  touch.overlap = b.overlap[k];
  touch.radius = b.radius[k];
  touch.mass = b.mass[k];
  touch.was_touching = b.touching_before[k];
  touch.normal = load(b.normal, k);
  touch.half_normal = load(b.half_normal, k);
  touch.velocity = load(b.velocity, k);
  touch.spin = load(b.spin, k);
  touch.dt = dt;
  touch.shared_spin = b.shared_spin[k];
  touch.radius_first = b.radius_first[k];
  touch.radius_second = b.radius_second[k];
  touch.mass_first = b.mass_first[k];
  touch.mass_second = b.mass_second[k];
}

/// Energy of a contact that began or ended otherwise than by its law: inserted in overlap, handed over from one
/// surface to the next. `before`: what it stored, or would have stored, before the step.
PULVIS_INLINE double change(double began, double ended, double before) { return (began - ended) * before; }

template <class Part>
PULVIS_INLINE void account_normal(EnergyBlock& b, int k, const typename Part::Pair& pair, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  double plastic = 0.0, adhesion = 0.0;
  if constexpr (Part::remembers) plastic = b.memory_before.plastic[k], adhesion = b.memory_before.adhesion[k];
  double plastic_before = plastic, adhesion_before = adhesion;
  laws::Touch touch_before = touch;
  touch_before.overlap = b.overlap_before[k];
  const laws::Normal before = Part::normal(touch_before, pair, plastic_before, adhesion_before);
  const laws::Normal n = Part::normal(touch, pair, plastic, adhesion);
  const double is = b.touching[k], was = b.touching_before[k];
  b.size[k] = n.contact_size;
  b.size_before[k] = before.contact_size;
  b.elastic[k] = n.elastic;
  b.damping_size[k] = n.damping_size;
  b.limit_shift[k] = n.limit_shift;
  if constexpr (Part::states_energy) {
    const laws::Stored now = Part::stored(touch, pair, n), old = Part::stored(touch_before, pair, before);
    term(b, EnergyTerm::elastic, k) = is * now.elastic;
    term(b, EnergyTerm::cohesive, k) = is * now.cohesive;
    const double began = is * (1.0 - was), ended = was * (1.0 - is);
    const double in_touch = select(touch_before.overlap > 0.0, 1.0, 0.0);
    const double opened = select(touch.overlap <= -Part::separation_gap(touch.radius, pair), 1.0, 0.0);
    term(b, EnergyTerm::touch, k) = -(began * (1.0 - in_touch)) * Part::stored_at_touch(touch.radius, pair);
    term(b, EnergyTerm::separation, k) = ended * opened * Part::stored_at_separation(touch.radius, pair);
    term(b, EnergyTerm::changed_contacts, k) =
        change(began * in_touch, ended * (1.0 - opened), old.elastic + old.cohesive);
  } else {
    const double closing = dot(load(b.end_velocity, k), touch.normal);
    term(b, EnergyTerm::unsplit_normal, k) = is * n.elastic * closing * dt;
  }
}

template <class Part>
PULVIS_INLINE void account_damping(EnergyBlock& b, int k, const typename Part::Pair& pair,
                                   const laws::Whole& whole, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const laws::Normal n{b.elastic[k], b.size[k], b.damping_size[k], b.limit_shift[k]};
  const laws::Dashpots c = Part::coefficients(n, touch.mass, pair);
  const double closing = laws::closing_speed(touch);
  const double dashpot = laws::dashpot_force(c.normal, closing, touch);
  b.closing[k] = closing;
  store(b.slip, k, laws::slip_velocity(touch, closing));
  b.limiting_force[k] = laws::limiting_force(n, dashpot, whole);
  b.tangential_damping[k] = c.tangential;
  const double end_closing = dot(load(b.end_velocity, k), touch.normal);
  term(b, EnergyTerm::normal_dashpot, k) = b.touching[k] * dashpot * end_closing * dt;
}

template <class Part>
PULVIS_INLINE void account_cohesion(EnergyBlock& b, int k, const typename Part::Pair& pair,
                                    const laws::Whole& whole, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const laws::Attraction a = Part::attraction(touch, pair);
  b.limiting_force[k] = laws::limiting_force(b.limiting_force[k], b.size[k], a, whole);
  const double is = b.touching[k], was = b.touching_before[k];
  const double end_closing = dot(load(b.end_velocity, k), touch.normal);
  if constexpr (Part::is_viscous) {
    const Vec3 drag = laws::drag_force(load(b.slip, k), touch.normal, a.viscous_tangential);
    const double along = a.viscous_normal * b.closing[k] * end_closing;
    term(b, EnergyTerm::liquid, k) = is * (along - dot(drag, load(b.end_velocity, k))) * dt;
  }
  if constexpr (Part::states_energy) {
    laws::Touch touch_before = touch;
    touch_before.overlap = b.overlap_before[k];
    const double began = is * (1.0 - was), ended = was * (1.0 - is);
    const double opened = select(touch.overlap <= -Part::separation_gap(touch, pair), 1.0, 0.0);
    term(b, EnergyTerm::cohesive, k) += is * Part::stored(touch, pair);
    term(b, EnergyTerm::changed_contacts, k) +=
        change(began, ended * (1.0 - opened), Part::stored(touch_before, pair));
  } else {
    term(b, EnergyTerm::unsplit_cohesion, k) = -is * a.pull * end_closing * dt;
  }
}

/// The spring of the step before as forces in the present plane: what acted, and what it is in the present stiffness.
template <laws::SpringKind kind>
PULVIS_INLINE double acted(double stiffness_before) {
  return kind == laws::SpringKind::displacement ? stiffness_before : 1.0;
}
template <laws::SpringKind kind>
PULVIS_INLINE double in_present_stiffness(double stiffness, double size, double size_before) {
  if (kind == laws::SpringKind::displacement) return stiffness;
  if (kind == laws::SpringKind::shrinking)
    return select(size < size_before, size / greatest(size_before, 1e-300), 1.0);
  return 1.0;
}

template <class Part>
PULVIS_INLINE void account_sliding(EnergyBlock& b, int k, const typename Part::Pair& pair, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const double size = b.size[k], size_before = b.size_before[k];
  const Vec3 old = load(b.before.slide, k), slip = load(b.slip, k);
  Vec3 spring = old;
  double grip = 0.0;
  if constexpr (Part::remembers_grip) grip = b.memory_before.grip[k];
  const Vec3 force = Part::slide(touch, slip, size, magnitude(b.limiting_force[k]), b.tangential_damping[k],
                                 pair, spring, grip);
  const double is = b.touching[k], held = select(size > 0.0, is, 0.0);
  const Vec3 end_velocity = load(b.end_velocity, k);
  if constexpr (Part::spring == laws::SpringKind::none) {
    term(b, EnergyTerm::unsplit_friction, k) = -is * dot(force, end_velocity) * dt;
  } else {
    const double stiffness = Part::spring_stiffness(size, pair);
    const double stiffness_before = Part::spring_stiffness(size_before, pair);
    const double as_force = Part::spring == laws::SpringKind::displacement ? stiffness : 1.0;
    // In the sense of a displacement, whose force on the first is the opposite.
    const double sense = Part::spring == laws::SpringKind::displacement ? 1.0 : -1.0;
    const double acting = sense * acted<Part::spring>(stiffness_before);
    const double keeping = sense * in_present_stiffness<Part::spring>(stiffness, size, size_before);
    const Vec3 carried = in_plane(laws::carried_to_middle(old, touch), touch.normal);
    const Vec3 moved = (stiffness * dt) * in_plane(slip, touch.normal);
    const Vec3 now = (sense * as_force) * spring;
    const laws::SpringStep step = laws::spring_step(
        acting * carried, keeping * carried, keeping * carried + moved, now, stiffness_before, stiffness);
    const double half_before = laws::half_compliance(stiffness_before);
    term(b, EnergyTerm::sliding_spring, k) = held * step.stored;
    term(b, EnergyTerm::sliding, k) = held * step.slipped;
    term(b, EnergyTerm::sliding_stiffness, k) = held * step.stiffened;
    term(b, EnergyTerm::forgotten_springs, k) = (1.0 - held) * half_before * square(acting) * dot(old, old);
    term(b, EnergyTerm::tangential_dashpot, k) = -is * dot(force + now, end_velocity) * dt;
  }
}

template <class Rolling, class Twisting>
PULVIS_INLINE void account_rolling(EnergyBlock& b, int k, const typename Rolling::Pair& rolling,
                                   const typename Twisting::Pair& twisting, double dt) {
  laws::Touch touch;
  look(b, k, dt, touch);
  const double size = b.size[k], size_before = b.size_before[k];
  const double limit = magnitude(b.limiting_force[k]);
  const double held = select(size > 0.0, b.touching[k], 0.0);
  const Vec3 end_spin = load(b.end_spin, k);
  Vec3 old = load(b.before.roll, k);
  double forgotten = 0.0, stiffened = 0.0;
  if constexpr (Twisting::acts) {
    const Vec3 before = laws::normal_before(touch.normal, touch.half_normal);
    const double twisted = dot(old, before);
    old = old - twisted * before;
    double spring = twisted;
    const double twist = Twisting::twist(touch, size, limit, b.tangential_damping[k], twisting, spring);
    const double stiffness = Twisting::spring_stiffness(size, touch.radius, twisting);
    const double stiffness_before = Twisting::spring_stiffness(size_before, touch.radius, twisting);
    const double turned = dot(touch.spin, touch.half_normal);
    const Vec3 acted{-twisted, 0.0, 0.0}, trial{(stiffness * dt) * turned - twisted, 0.0, 0.0};
    const laws::SpringStep step =
        laws::spring_step(acted, acted, trial, {-spring, 0.0, 0.0}, stiffness_before, stiffness);
    term(b, EnergyTerm::twisting_spring, k) = held * step.stored;
    term(b, EnergyTerm::twisting, k) = held * step.slipped;
    term(b, EnergyTerm::twisting_dashpot, k) = -held * (twist - spring) * dot(end_spin, touch.normal) * dt;
    stiffened = step.stiffened;
    forgotten = laws::half_compliance(stiffness_before) * twisted * twisted;
  }
  Vec3 spring = old;
  const Vec3 torque = Rolling::roll(touch, size, limit, rolling, spring);
  if constexpr (Rolling::spring == laws::SpringKind::none) {
    term(b, EnergyTerm::rolling, k) = -held * dot(torque, end_spin) * dt;
  } else {
    const double stiffness = Rolling::spring_stiffness(size, touch.radius, rolling);
    const double stiffness_before = Rolling::spring_stiffness(size_before, touch.radius, rolling);
    const Vec3 acted = -in_plane(laws::carried_to_middle(old, touch), touch.normal);
    const Vec3 turned = in_plane(in_plane(touch.spin, touch.half_normal), touch.normal);
    const laws::SpringStep step = laws::spring_step(acted, acted, acted + (stiffness * dt) * turned, -spring,
                                                    stiffness_before, stiffness);
    term(b, EnergyTerm::rolling_spring, k) = held * step.stored;
    term(b, EnergyTerm::rolling, k) = held * step.slipped;
    term(b, EnergyTerm::rolling_dashpot, k) = -held * dot(torque - spring, end_spin) * dt;
    stiffened = stiffened + step.stiffened;
    forgotten = forgotten + laws::half_compliance(stiffness_before) * dot(old, old);
  }
  term(b, EnergyTerm::rolling_stiffness, k) = held * stiffened;
  term(b, EnergyTerm::forgotten_springs, k) += (1.0 - held) * forgotten;
}

// --- the stages: loops over the block ---------------------------------------------------------------------

void geometry_stage(EnergyBlock& b, const double*, double dt) {
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) derive_geometry(b, k, dt);
}

template <class Part>
void normal_stage(EnergyBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::normal);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) account_normal<Part>(b, k, pair, dt);
}

template <class Part>
void damping_stage(EnergyBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::damping);
  const auto whole = laws::unpack<laws::Whole>(constants, laws::Place::whole);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) account_damping<Part>(b, k, pair, whole, dt);
}

template <class Part>
void cohesion_stage(EnergyBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::cohesion);
  const auto whole = laws::unpack<laws::Whole>(constants, laws::Place::whole);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) account_cohesion<Part>(b, k, pair, whole, dt);
}

template <class Part>
void sliding_stage(EnergyBlock& b, const double* constants, double dt) {
  const auto pair = laws::unpack<typename Part::Pair>(constants, laws::Place::sliding);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) account_sliding<Part>(b, k, pair, dt);
}

template <class Rolling, class Twisting>
void rolling_stage(EnergyBlock& b, const double* constants, double dt) {
  const auto rolling = laws::unpack<typename Rolling::Pair>(constants, laws::Place::rolling);
  const auto twisting = laws::unpack<typename Twisting::Pair>(constants, laws::Place::twisting);
  const int count = b.count;
#pragma omp simd
  for (int k = 0; k < count; ++k) account_rolling<Rolling, Twisting>(b, k, rolling, twisting, dt);
}

/// Terms that several parts write to, or that not every law's parts write at all.
void clear_stage(EnergyBlock& b, const double*, double) {
  for (const EnergyTerm t :
       {EnergyTerm::cohesive, EnergyTerm::changed_contacts, EnergyTerm::forgotten_springs})
    for (int k = 0; k < b.count; ++k) term(b, t, k) = 0.0;
}

void sum(const EnergyBlock& b, std::uint32_t terms, const SumGrid& grid, EnergySums& sums) {
  const int count = b.count;
  for (std::size_t t = 0; t < energy_terms; ++t) {
    if (!(terms >> t & 1u)) continue;
    const double* x = b.term[t];
    double high = 0.0, low = 0.0;
#pragma omp simd reduction(+ : high, low)
    for (int k = 0; k < count; ++k) {
      const double h = grid.high(x[k]);
      high += h;
      low += grid.low(x[k], h);
    }
    sums.of[t] += grid.count(high, low);
  }
}

// --- the stages of a law ----------------------------------------------------------------------------------

using Stage = EnergyKernel::Stage;

template <class... Parts>
Stage normal_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{normal_stage<Parts>...}[index];
}
template <class... Parts>
Stage damping_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{damping_stage<Parts>...}[index];
}
template <class... Parts>
Stage cohesion_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{cohesion_stage<Parts>...}[index];
}
template <class... Parts>
Stage sliding_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{sliding_stage<Parts>...}[index];
}
template <class Twisting, class... Parts>
Stage rolling_stage_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{rolling_stage<Parts, Twisting>...}[index];
}

template <class... Parts>
bool normal_states(laws::PartList<Parts...>, std::size_t index) {
  return std::array{Parts::states_energy...}[index];
}
template <class... Parts>
laws::SpringKind spring_of(laws::PartList<Parts...>, std::size_t index) {
  return std::array{Parts::spring...}[index];
}

void use_terms(const laws::Law& law, EnergyKernel& kernel) {
  using enum EnergyTerm;
  const auto use = [&](bool has, std::initializer_list<EnergyTerm> list) {
    if (has)
      for (const EnergyTerm t : list) kernel.use(t);
  };
  const bool stored = normal_states(laws::NormalParts{}, law.normal->index);
  use(stored, {elastic, cohesive, touch, separation, changed_contacts});
  use(!stored, {unsplit_normal});
  use(law.damping->name != laws::damping::None::name, {normal_dashpot});
  const bool pull = law.cohesion->acts,
             pull_stored = normal_states(laws::CohesionParts{}, law.cohesion->index);
  use(pull && pull_stored, {cohesive, changed_contacts});
  use(pull && !pull_stored, {unsplit_cohesion});
  use(pull && law.cohesion->is_viscous, {liquid});
  const bool slides = spring_of(laws::SlidingParts{}, law.sliding->index) != laws::SpringKind::none;
  use(slides, {sliding_spring, sliding, sliding_stiffness, tangential_dashpot, forgotten_springs});
  use(!slides && law.sliding->name != laws::sliding::None::name, {unsplit_friction});
  const bool rolls = spring_of(laws::RollingParts{}, law.rolling->index) != laws::SpringKind::none;
  use(rolls, {rolling_spring, rolling_stiffness, rolling_dashpot, forgotten_springs});
  use(law.rolling->name != laws::rolling::None::name, {rolling});
  use(law.twisting->acts,
      {twisting_spring, twisting, twisting_dashpot, rolling_stiffness, forgotten_springs});
}

}  // namespace

EnergyKernel energy_kernel(const laws::Law& law) {
  EnergyKernel kernel;
  kernel.geometry = geometry_stage;
  kernel.sum = sum;
  kernel.append(clear_stage);
  kernel.append(normal_stage_of(laws::NormalParts{}, law.normal->index));
  kernel.append(damping_stage_of(laws::DampingParts{}, law.damping->index));
  if (law.cohesion->acts) kernel.append(cohesion_stage_of(laws::CohesionParts{}, law.cohesion->index));
  kernel.append(sliding_stage_of(laws::SlidingParts{}, law.sliding->index));
  kernel.append(
      law.twisting->acts
          ? rolling_stage_of<laws::twisting::ElasticPlastic>(laws::RollingParts{}, law.rolling->index)
          : rolling_stage_of<laws::twisting::None>(laws::RollingParts{}, law.rolling->index));
  use_terms(law, kernel);
  return kernel;
}

}  // namespace PULVIS_ISA
}  // namespace pulvis::kernels
