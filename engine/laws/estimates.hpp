// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"
#include "engine/math/functions.hpp"

// Closed forms about materials and single contacts: what mixing, the time step and `pulvis check` need. SI.
namespace pulvis::laws {

/// E*, Pa:  1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
/// Source  K. L. Johnson, Contact Mechanics (1985), doi:10.1017/CBO9781139171731, section 4.2.
inline double effective_modulus(double e1, double nu1, double e2, double nu2) {
  return 1.0 / ((1.0 - nu1 * nu1) / e1 + (1.0 - nu2 * nu2) / e2);
}

/// G*, Pa:  1/G* = 2 (2 - nu_1)(1 + nu_1)/E_1 + 2 (2 - nu_2)(1 + nu_2)/E_2, i.e. (2 - nu)/G summed.
/// Source  Johnson (1985), section 7.2 (Mindlin's compliance 1/(8 a G*)).
inline double effective_shear_modulus(double e1, double nu1, double e2, double nu2) {
  return 1.0 / (2.0 * (2.0 - nu1) * (1.0 + nu1) / e1 + 2.0 * (2.0 - nu2) * (1.0 + nu2) / e2);
}

/// Time a Rayleigh wave takes around half a sphere, s:  pi R sqrt(rho/G)/(0.1631 nu + 0.8766).
/// The denominator fits the root of the Rayleigh equation to 0.3 %.
/// Source  Y. Li, Y. Xu, C. Thornton, Powder Technol. 160 (2005) 219-228, doi:10.1016/j.powtec.2005.09.002.
inline double rayleigh_time(double radius, double density, double young_modulus, double poisson_ratio) {
  const double shear_modulus = young_modulus / (2.0 * (1.0 + poisson_ratio));
  return pi * radius * root(density / shear_modulus) / (0.1631 * poisson_ratio + 0.8766);
}

/// Duration of an elastic Hertz impact at closing speed v, s:  2.8683 (m*^2/(R* E*^2 v))^(1/5).
/// Source  Johnson (1985), eq. 11.24, with the exact constant: 2.9432 (15/16)^(2/5).
inline double hertz_contact_time(double mass, double radius, double modulus, double speed) {
  return 2.8683 * power(mass * mass / (radius * modulus * modulus * speed), 0.2);
}

/// Largest overlap of an elastic Hertz impact, m:  (15 m* v^2/(16 E* sqrt(R*)))^(2/5), where the work of Hertz's
/// force has used up m* v^2/2.  Johnson (1985), section 11.4.
inline double hertz_largest_overlap(double mass, double radius, double modulus, double speed) {
  const double ratio = 15.0 * mass * speed * speed / (16.0 * modulus * root(radius));
  return ratio > 0.0 ? power(ratio, 0.4) : 0.0;
}

/// Stiffness of a linear spring with that largest overlap, N/m:  m* v^2/delta_max^2 (normal/hooke.hpp, eq. 2).
inline double linear_stiffness(double mass, double radius, double modulus, double speed) {
  return mass * square(speed / hertz_largest_overlap(mass, radius, modulus, speed));
}

/// Static Hertz overlap under a force, m:  (3 F/(4 E* sqrt(R*)))^(2/3).  Johnson (1985), eq. 4.23.
inline double hertz_overlap_under(double force, double radius, double modulus) {
  return square(cube_root(0.75 * force / (modulus * root(radius))));
}

// JKR (see normal/jkr.hpp for sources).

/// F_po = (3/2) pi W R*, N.
inline double jkr_pull_off(double radius, double work) { return 1.5 * pi * work * radius; }

/// delta_c = (3/4) (pi^2 W^2 R*/E*^2)^(1/3), m.
inline double jkr_stretch(double radius, double modulus, double work) {
  const double ratio = pi * work / modulus;
  return 0.75 * cube_root(ratio * ratio * radius);
}

/// Overlap without external force, m: y^3 = 6 in eq. (6) of jkr.hpp, 1.2114137 delta_c.
inline double jkr_zero_force_overlap(double radius, double modulus, double work) {
  return cube_root(6.0) * (2.0 / 3.0) * jkr_stretch(radius, modulus, work);
}

/// Overlap that carries an external force F >= 0 besides the adhesion, m. From eq. (7) of jkr.hpp:
/// y^3 = 3 + 3 sqrt(1 + F/F_po).
inline double jkr_overlap_under(double force, double radius, double modulus, double work) {
  const double y = cube_root(3.0 + 3.0 * root(1.0 + force / jkr_pull_off(radius, work)));
  return jkr_stretch(radius, modulus, work) * (y * y * y - 4.0) * y / 3.0;
}

/// Stiffness dF/d(delta) at zero overlap, N/m: F_po/(2 delta_c) y^2 (y^3 - 3)/(y^3 - 1) with y^3 = 4.
inline double jkr_stiffness_at_touch(double radius, double modulus, double work) {
  const double y = cube_root(4.0);
  return jkr_pull_off(radius, work) / (2.0 * jkr_stretch(radius, modulus, work)) * y * y / 3.0;
}

/// Energy lost by one touch and separation, J:  W_s = 7.0922 (W^5 R*^4/E*^2)^(1/3).
/// Source  C. Thornton, Z. Ning, Powder Technol. 99 (1998) 154-162, doi:10.1016/S0032-5910(98)00099-0, eq. 52
///         (there 7.09).
inline double jkr_separation_work(double radius, double modulus, double work) {
  const double w2 = work * work, r2 = radius * radius;
  return 7.0922 * work * cube_root(w2 * r2 * r2 / (modulus * modulus));
}

/// Speed below which an elastic JKR collision sticks, m/s: m* v_s^2/2 = W_s (Thornton and Ning, eq. 54).
inline double jkr_sticking_speed(double mass, double radius, double modulus, double work) {
  return root(2.0 * jkr_separation_work(radius, modulus, work) / mass);
}

}  // namespace pulvis::laws
