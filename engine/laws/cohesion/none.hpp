// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::cohesion {

/// No attraction besides that of the normal law.
struct None {
  static constexpr const char* name = "none";
  static constexpr bool acts = false, reaches = false, needs_sizes = false, is_viscous = false,
                        has_pull_off = false;
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {};
  static constexpr std::array<Parameter, 0> parameters{};

  static Pair mix(const MaterialPair&, const Choices&) { return {}; }
  static double longest_gap(double, const Pair&) { return 0.0; }
  static bool acts_on_approach(const Pair&) { return false; }
  PULVIS_INLINE static double separation_gap(const Touch&, const Pair&) { return 0.0; }
  PULVIS_INLINE static double formation_gap(const Touch&, const Pair&) { return 0.0; }
  PULVIS_INLINE static Attraction attraction(const Touch&, const Pair&) { return {}; }
  static constexpr bool states_energy = true;
  PULVIS_INLINE static double stored(const Touch&, const Pair&) { return 0.0; }
};

}  // namespace pulvis::laws::cohesion
