// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/similarity.hpp"

namespace pulvis::laws {

/// Material properties of a pair, mixed once per pair of species. SI. Each part of a law names those it needs,
/// with their ranges, in its `parameters`.
struct MaterialPair {
  double effective_modulus = 0.0;        ///< E*, Pa: 1/E* = (1-nu_i^2)/E_i + (1-nu_j^2)/E_j
  double effective_shear_modulus = 0.0;  ///< G*, Pa: 1/G* = 2(2-nu_i)(1+nu_i)/E_i + 2(2-nu_j)(1+nu_j)/E_j
  double work_of_adhesion = 0.0;         ///< W, J/m^2
  double restitution = 1.0;              ///< e, -
  double friction = 0.0;                 ///< mu, -
  double rolling_friction = 0.0;         ///< mu_r, -
  double rolling_viscosity = 0.0;        ///< eta_r, -: share of critical damping against rolling
  double twisting_friction = 0.0;        ///< mu_w, -

  // Linear laws.
  double normal_stiffness = 0.0;      ///< k_n, N/m; 0: from the characteristic speed
  double characteristic_speed = 0.0;  ///< V, m/s
  double tangential_ratio = 1.0;      ///< k_t/k_n, -

  // Elasto-plastic laws.
  double plastic_ratio = 0.0;     ///< k_p/k_1, - (Luding)
  double adhesion_ratio = 0.0;    ///< k_c/k_1, - (Luding)
  double plasticity_depth = 0.0;  ///< phi_F, - (Luding)
  double unloading_ratio = 0.0;   ///< k_2/k_1, - (Edinburgh)
  double constant_pull = 0.0;     ///< f_0, N, negative (Edinburgh)

  // Cohesion.
  double cohesion_energy_density = 0.0;  ///< k_c, J/m^3
  double surface_tension = 0.0;          ///< sigma, N/m
  double contact_angle = 0.0;            ///< theta, rad
  double liquid_content = 0.0;           ///< volume of a bridge over that of the two bodies, -
  double liquid_viscosity = 0.0;         ///< eta, Pa s
  double shortest_bridge_gap = 0.01;     ///< smallest gap over R* in the viscous part, -
  double hamaker_constant = 0.0;         ///< A_H, J
  double shortest_gap = 0.0;             ///< h_c, m
  double longest_gap = 0.0;              ///< h_max, m
};

/// A property that a part of a law needs, the values it may have, ends included, and how it follows the size of
/// parcels. SI. A part cannot state it without its unit and what it has to do with the pull-off force.
struct Parameter {
  const char* name;
  double MaterialPair::*value;
  double lowest, highest;
  const char* unit;
  PullOff pull_off;
  double stress_power = size_power(unit);

  /// Power of alpha by which it grows; under bond similarity only if `pull_off` has a rule.
  constexpr double growth(Similarity similarity) const {
    return similarity == Similarity::none     ? 0.0
           : similarity == Similarity::stress ? stress_power
                                              : pull_off.bond_power(stress_power);
  }
};

/// Parameters of more than one part.
namespace needs {
inline constexpr Parameter coulomb_friction{"friction", &MaterialPair::friction, 0.0, 10.0,
                                            "-",        PullOff::apart()};
inline constexpr Parameter rolling_friction{
    "rolling_friction", &MaterialPair::rolling_friction, 0.0, 10.0, "-", PullOff::apart()};
inline constexpr Parameter work_of_adhesion{
    "work_of_adhesion", &MaterialPair::work_of_adhesion, 0.0, 100.0, "J/m^2", PullOff::grows_with(1, 1)};
inline constexpr Parameter effective_modulus{
    "effective_modulus", &MaterialPair::effective_modulus, 1.0, 1e13, "Pa", PullOff::apart()};
inline constexpr Parameter cohesion_energy_density{
    "cohesion_energy_density", &MaterialPair::cohesion_energy_density, 0.0, 1e12, "J/m^3",
    PullOff::grows_with(3, 2)};

}  // namespace needs

/// What becomes of cohesion in the normal force that limits friction and rolling.
enum class CohesionLimit {
  standard,  ///< each law's own, which its file names
  without,   ///< the force as if there were no cohesion
  with,      ///< the whole force
  shifted    ///< the whole force plus twice the pull-off force (Thornton)
};

/// Named choices of a law that change a formula, not the set of parts.
struct Choices {
  bool limit_includes_dashpot = false;  ///< friction_limit = "total" instead of "elastic"
  bool damping_on_jkr_radius = false;   ///< damping_radius = "jkr_radius" instead of "hertz"
  bool tangential_damping = true;       ///< whether sliding laws have a dashpot
  CohesionLimit cohesion_limit = CohesionLimit::standard;
  bool bridges_form_on_approach = false;  ///< at the rupture distance instead of on touch
  bool linear_loading = false;            ///< Edinburgh: n = 1 instead of 3/2
  double adhesion_exponent = 1.5;         ///< Edinburgh: chi, 1, 1.5 or 2
};

}  // namespace pulvis::laws
