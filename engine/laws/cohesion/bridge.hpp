// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"
#include "engine/math/functions.hpp"
#include "engine/math/loop_functions.hpp"

// What all laws of capillary bridges share: volume, formation, rupture, viscous part.
//
//   R = 2 R*                                                       [m]    (1)
//   V = least of (4/3) pi content (R_i^3 + R_j^3) and 0.1 R^3      [m^3]  (2)
//   h_r = (1 + theta/2) (V^(1/3) + 0.1 V^(2/3)/R)                  [m]    (3)
//   F_v = 6 pi eta R* v_n/q, q = greatest of floor and h/R*        [N]    (4)
//   T_v = 6 pi eta R* v_t (8/15 ln(1/q) + 0.9588), at least 0      [N]    (5)
//
// (1) is the radius of equal spheres that Derjaguin's approximation puts in the place of unequal ones; at a wall
// it is twice the parcel's. (2): each bridge takes the share `content` of the volume of both bodies (at a wall
// of the parcel), however many neighbours there are; the fits end at V = 0.1 R^3, and a small grain at a large
// one cannot hold more. (3) C. D. Willett et al., Langmuir 16 (2000) 9396-9405, doi:10.1021/la000657y, eq. 15.
// (4) and (5) S. T. Nase et al., Powder Technol. 116 (2001) 214-223, doi:10.1016/S0032-5910(00)00398-3, as
// quoted by D. Shi, J. J. McCarthy, Powder Technol. 184 (2008) 64-75, eq. 40 and 41; (5) is the drag of a sphere
// that slides along a plane without turning, with R* in the place of its radius. Both oppose the motion and
// dissipate. q is the gap over R*, and its floor stands for roughness: about 0.01. With overlap the gap counts as
// zero.
//
// What the laws say of their accuracy is against our solution of the Young-Laplace equation for equal spheres,
// at gaps of 1 to 80 % of h_r. (3) itself is within 4 % of the gap at which that solution ends, for V/R^3 of
// 0.001 to 0.1 and theta up to 40 degrees (at theta = 0 within 0.5 %).
namespace pulvis::laws::cohesion {

struct BridgePair {
  double tension;      ///< sigma, N/m
  double content;      ///< (4/3) pi content, -
  double rupture;      ///< 1 + theta/2
  double on_approach;  ///< 1: a bridge forms at h_r on approach, 0: when the solids touch
  double viscous;      ///< 6 pi eta, Pa s
  double floor;        ///< smallest q
};

inline constexpr std::array bridge_parameters{
    Parameter{"surface_tension", &MaterialPair::surface_tension, 1e-6, 10.0, "N/m",
              PullOff::grows_with(1, 1)},
    Parameter{"contact_angle", &MaterialPair::contact_angle, 0.0, 0.8727, "rad", PullOff::apart()},
    Parameter{"liquid_content", &MaterialPair::liquid_content, 1e-7, 0.5, "-", PullOff::apart()},
    Parameter{"liquid_viscosity", &MaterialPair::liquid_viscosity, 0.0, 1e4, "Pa s", PullOff::apart()},
    Parameter{"shortest_bridge_gap", &MaterialPair::shortest_bridge_gap, 1e-6, 1.0, "-", PullOff::apart()}};

inline BridgePair mix_bridge(const MaterialPair& pair, const Choices& choices) {
  return {pair.surface_tension,
          (4.0 / 3.0) * pi * pair.liquid_content,
          1.0 + 0.5 * pair.contact_angle,
          choices.bridges_form_on_approach ? 1.0 : 0.0,
          6.0 * pi * pair.liquid_viscosity,
          pair.shortest_bridge_gap};
}

/// (1), m.
PULVIS_INLINE double bridge_radius(const Touch& touch) { return 2.0 * touch.radius; }

/// (2), m^3.
PULVIS_INLINE double bridge_volume(const Touch& touch, const BridgePair& pair) {
  const double r1 = touch.radius_first, r2 = touch.radius_second, r = bridge_radius(touch);
  return least(pair.content * (r1 * r1 * r1 + r2 * r2 * r2), 0.1 * r * r * r);
}

/// (3), m.
PULVIS_INLINE double bridge_rupture(double volume, double radius, const BridgePair& pair) {
  const double third = cube_root(volume);
  return pair.rupture * (third + 0.1 * third * third / radius);
}

/// Gap of the surfaces, m; zero with overlap.
PULVIS_INLINE double bridge_gap(const Touch& touch) { return greatest(-touch.overlap, 0.0); }

/// Upper bound of (3) for all pairs of spheres up to this radius and for walls, m: V^(1/3) is at most 0.464 R.
inline double longest_bridge(double radius, const BridgePair& pair) {
  return pair.rupture * 1.05 * cube_root(2.0 * pair.content * radius * radius * radius);
}

/// (4) and (5) as coefficients, kg/s.
PULVIS_INLINE Attraction bridge_attraction(const Touch& touch, const BridgePair& pair, double pull,
                                           double pull_at_contact) {
  const double q = greatest(pair.floor, bridge_gap(touch) / touch.radius);
  const double drag = pair.viscous * touch.radius;
  const double shear = (-8.0 / 15.0) * loop_logarithm(q) + 0.9588;
  return {pull, pull_at_contact, drag / q, drag * greatest(shear, 0.0)};
}

}  // namespace pulvis::laws::cohesion
