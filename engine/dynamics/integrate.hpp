// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/contacts/evaluate.hpp"
#include "engine/contacts/near_pairs.hpp"
#include "engine/contacts/near_walls.hpp"
#include "engine/dynamics/body_force.hpp"
#include "engine/kernels/parcel_block.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

using kernels::Drift;
using kernels::Leeway;
using kernels::StepNotice;

/// What a step of a sheared box needs besides; of others, what it is by default.
struct ShearedStep {
  Slide slide{};        ///< at the end of the step
  double strain = 0.0;  ///< shear strain since the lists were made, to the end of the step
  double reach = 0.0;   ///< m, by which the lists reach beyond margins
};

/// What the first half of a step is made with.
struct StepBeginning {
  StepBeginning(const Box& domain, const ForceField& at_beginning, double step, const Drift& way,
                const ShearedStep& sheared)
      : box(domain),
        any_periodic(domain.periodic[0] || domain.periodic[1] || domain.periodic[2]),
        field(at_beginning),
        dt(step),
        drift(way),
        shear(sheared) {}
  const Box& box;
  bool any_periodic;
  ForceField field;
  double dt;    ///< s
  Drift drift;  ///< since the lists were made, to the end of the step
  ShearedStep shear;
};

/// First half of velocity Verlet: v += (F/m) dt/2, omega += (T/I) dt/2, x += v dt; wraps periodic axes.
/// Velocities then are those of the middle of the step, in step with the displacement they made (synchronised
/// velocities, D. R. Vyas et al., Comput. Phys. Commun. 310 (2025) 109524). References wrap along.
///
/// In a sheared box the references drift with the shear flow, margins are measured against them, and a parcel that
/// leaves through a face of the gradient axis comes back where its image is, as fast as that.
StepNotice begin_step(Parcels& parcels, const StepBeginning& beginning, const Leeway& leeway, int threads);

/// What a sweep goes over.
struct SweptThings {
  Parcels& parcels;
  NearPairs& pairs;
  const NearWalls& walls;  ///< evaluated
  ContactEvaluator& evaluator;
  const ContactClasses& classes;
  Images images;  ///< at the end of the step
  Leeway leeway;
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
