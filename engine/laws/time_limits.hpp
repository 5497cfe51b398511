// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/laws/catalogue.hpp"
#include "engine/laws/estimates.hpp"

namespace pulvis::laws {

/// One limit on the time step.
struct TimeLimit {
  const char* kind;
  double time;  ///< s
};

/// Limits on the time step that a pair of bodies with reduced mass `m` (kg) and reduced radius `r` (m) sets when
/// it meets at `speed` (m/s):
///   hertz                hertz_contact_time
///   cohesive stiffness   sqrt(m*/k), k the JKR stiffness at zero overlap
///   cohesive speed       delta_c/(10 v_s), v_s the sticking speed of JKR
///   linear spring        sqrt(m*/k), k the largest stiffness of hooke, luding: half of where steps become unstable
///   unloading            edinburgh: the hertz limit over sqrt(k_2/k_1); with the exponent 1 sqrt(m*/k_2)
///   liquid               m*/c, c the largest damping of a bridge
///   van der Waals        sqrt(m*/k), k the slope of the pull at the shortest gap
inline std::vector<TimeLimit> time_limits(const Law& law, const MaterialPair& pair, const Choices& choices,
                                          double m, double r, double speed) {
  const auto normal = law.normal->name;
  const double e = pair.effective_modulus, w = pair.work_of_adhesion;
  const double hertz = hertz_contact_time(m, r, e, speed);
  std::vector<TimeLimit> limits{{"hertz", hertz}};
  if (normal == "hooke" || normal == "luding") {
    const double k = pair.normal_stiffness > 0.0 ? pair.normal_stiffness
                                                 : linear_stiffness(m, r, e, pair.characteristic_speed);
    limits.push_back({"linear spring", root(m / (k * greatest(pair.plastic_ratio, 1.0)))});
  }
  if (normal == "edinburgh")
    limits.push_back({"unloading", choices.linear_loading ? root(m / (2.0 * e * r * pair.unloading_ratio))
                                                          : hertz / root(pair.unloading_ratio)});
  if (law.cohesion->is_viscous && pair.liquid_viscosity > 0.0)
    limits.push_back({"liquid", m * pair.shortest_bridge_gap / (6.0 * pi * pair.liquid_viscosity * r)});
  if (law.cohesion->name == "hamaker")
    limits.push_back({"van der Waals", root(3.0 * m * pair.shortest_gap * square(pair.shortest_gap) /
                                            (pair.hamaker_constant * r))});
  if (normal == "jkr" && w > 0.0) {
    limits.push_back({"cohesive stiffness", root(m / jkr_stiffness_at_touch(r, e, w))});
    limits.push_back({"cohesive speed", jkr_stretch(r, e, w) / (10.0 * jkr_sticking_speed(m, r, e, w))});
  }
  return limits;
}

}  // namespace pulvis::laws
