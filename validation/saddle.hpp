// SPDX-License-Identifier: Apache-2.0
#pragma once

// A small sphere on the saddle between two large ones that touch each other and do not move: the test of friction at
// large size ratios of D. R. Vyas, J. M. Ottino, R. M. Lueptow, P. B. Umbanhowar, Comput. Phys. Commun. 310 (2025)
// 109524, doi:10.1016/j.cpc.2025.109524 (arXiv 2410.14798), with the numbers of their example for LAMMPS (sphere
// of 0.5 mm, 2500 kg/m^3, springs of 10,000 N/m, dt = 1 us, friction 0.5, released 1 degree off the top). There the
// size ratio is 20.
//
// The large spheres (radius R) stand side by side along x. The small one (radius r, mass m) touches both and can
// move on a circle of radius
//   rho = sqrt(r^2 + 2 R r)                                             [m]  (1)
// about x, at the angle phi from the top. Each contact normal has the share
//   c = rho/(R + r)                                                     [-]  (2)
// along the radius of that circle, so at rest the normal forces are
//   N = m g cos(phi)/(2 c)                                              [N]  (3)
// Both contacts lie on a line along x at the distance r c from the centre.
//
// Statics. (a) Forces in the contacts have no moment about the line through both, the weight has m g r c sin(phi):
// without resistance to rolling it never rests, whatever the friction. (b) If it cannot roll, friction along the
// circle must carry m g sin(phi) <= 2 mu N, so it stays where
//   mu >= c tan(phi)                                                    [-]  (4)
// (c) Rolling resistance gives each contact up to mu_r R* N in its plane, of which the share c acts about x:
// m g r c sin(phi) <= 2 c mu_r R* N, so with enough friction it stays where
//   mu_r >= c tan(phi) r/R* = c tan(phi) (R + r)/R                      [-]  (5)
// While it rolls, the speed along the circle follows from energy, with 2/(5 c^2) for the spin:
//   v^2 (1 + 2/(5 c^2)) = 2 g rho (cos(start) - cos(phi))                (6)
// Where it leaves is no closed form: as the load falls the contacts spring back and rub across the circle too.
// (3) takes friction across the circle as none, as it is for a sphere set down with its normal forces balanced.
namespace pulvis::validation {

struct Saddle {
  static constexpr double radius = 0.25e-3;     ///< r, m
  static constexpr double density = 2500.0;     ///< kg/m^3
  static constexpr double stiffness = 1e4;      ///< N/m, normal
  static constexpr double tangential = 0.8235;  ///< of the normal stiffness
  static constexpr double restitution = 0.5, gravity = 9.81;

  double ratio = 1.0;     ///< R/r
  double friction = 0.5;  ///< mu
  double start = 0.0;     ///< phi at release, rad

  double large() const { return ratio * radius; }  ///< R, m
  double circle() const;                           ///< (1)
  double share() const;                            ///< (2)
  double mass() const;                             ///< kg
  double overlap() const;                          ///< m, that carries (3) at release
  double least_friction() const;                   ///< (4)
  double least_rolling_friction() const;           ///< (5)
  double rolling_speed(double phi) const;          ///< (6), m/s
};

/// At which instant the contact plane is taken in which sliding is measured.
enum class Plane {
  middle,  ///< of the step, where the velocity is known: synchronised
  end      ///< of the step, half a step after the velocity: as common codes do
};

/// The angle, rad, at which a sphere integrated in a few lines of its own (velocity Verlet, linear springs) leaves
/// both others, or nothing that is a number if it has not within `seconds`. Springs turn with the mean of both spins
/// about the normal; where they do not, friction across the circle never goes, and since mu > c the saddle then
/// clamps a sphere for good from a size ratio of about 100 on. It shares no law with the engine.
double leaving_angle(const Saddle& saddle, Plane plane, double dt, double seconds);

}  // namespace pulvis::validation
