// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/contacts/evaluate.hpp"
#include "engine/contacts/near_pairs.hpp"
#include "engine/contacts/near_walls.hpp"
#include "engine/dynamics/body_force.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

/// What the first half of a step noticed.
struct StepNotice {
  bool outside = false;   ///< a position is outside the box, or it or a spin is not a finite number
  bool too_fast = false;  ///< a parcel moved more than half its radius in one step
  bool stale = false;     ///< a parcel left the margin the lists were made for
  bool wrapped = false;   ///< a parcel came back at the other end of a periodic axis
};

/// What the first half of a step is made with.
struct StepBeginning {
  StepBeginning(const Box& domain, const ForceField& at_beginning, double step, const Vec3& way)
      : box(domain),
        any_periodic(domain.periodic[0] || domain.periodic[1] || domain.periodic[2]),
        field(at_beginning),
        dt(step),
        drift(way) {}
  const Box& box;
  bool any_periodic;
  ForceField field;
  double dt;   ///< s
  Vec3 drift;  ///< m, which the margins do not count: how far all have drifted since the lists were made
};

/// First half of velocity Verlet: v += (F/m) dt/2, omega += (T/I) dt/2, x += v dt; wraps periodic axes.
/// Velocities then are those of the middle of the step, in step with the displacement they made (synchronised
/// velocities, D. R. Vyas et al., Comput. Phys. Commun. 310 (2025) 109524). `reference` are the positions the
/// lists were made at; they wrap along.
StepNotice begin_step(Parcels& parcels, const StepBeginning& beginning, std::span<Vec3> reference,
                      std::span<const double> margin, int threads);

/// What a sweep goes over.
struct SweptThings {
  Parcels& parcels;
  NearPairs& pairs;
  const NearWalls& walls;  ///< evaluated
  ContactEvaluator& evaluator;
  const ContactClasses& classes;
  NearestImage nearest;
  std::span<Vec3> reference;  ///< per parcel, as in begin_step
  std::span<const double> margin;
};

struct SweepFields {
  ForceField end;  ///< body forces at the end of the step
  double dt;       ///< s
};

/// Evaluates all pairs, sums each parcel's loads in a fixed order (pair contacts by the partner's id, walls by
/// surface, body forces) and makes the second half of velocity Verlet; all in one pass over memory, since it is
/// memory that large beds wait for. With `next`, parcels go on with the first half of the step after it while they
/// are at hand: then their loads are not kept, and what begin_step would have noticed is returned.
///
/// In a rotating frame the accelerations -2 Omega x v - dOmega/dt x r (and, for the spin seen from the frame,
/// -Omega x omega - dOmega/dt) take the velocity before the first half kick and after the second, which is the
/// trapezoidal rule: second order.
StepNotice sweep(SweptThings things, const SweepFields& fields, const StepBeginning* next);

}  // namespace pulvis
