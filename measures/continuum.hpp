// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <span>
#include <vector>

#include "measures/container.hpp"
#include "measures/stress.hpp"

namespace pulvis::measures {

/// Continuum fields at points, in their order.
struct ContinuumFields {
  std::vector<double> density;         ///< kg/m^3
  std::vector<Vec3> velocity;          ///< m/s; momentum over density, 0 where there is no mass
  std::vector<Tensor> contact_stress;  ///< Pa, compressive positive
  std::vector<Tensor> kinetic_stress;  ///< Pa, compressive positive
};

/// Usual support of the kernel in mean parcel diameters.
constexpr double support_diameters = 3.0;

/// Density, velocity and stress smoothed by Lucy's polynomial W of support c (m; LucyKernel):
///   density(r) = sum_p m_p W(r - x_p),   velocity(r) = sum_p m_p v_p W(r - x_p) / density(r),
///   contact stress_ij(r) = sum_c f_i l_j (integral of W(r - y) along the contact's branch)/(its length),
///   kinetic stress_ij(r) = sum_p m_p v'_i v'_j W(r - x_p),   v' = v_p - velocity(r).
/// f and l as in stress(): rows are the force's components, columns the branch's. The branch of a pair runs
/// from centre to centre, that of a wall's contact from the centre to the point of contact. The fields meet
/// the balances of mass and momentum exactly at any c; at rest d stress_ij/dx_j = density g_i farther than c
/// from contacts with walls (nearer the wall's force, smoothed by W at the contact point, comes in).
///
/// Source: I. Goldhirsch, Granular Matter 12 (2010) 239-252, doi:10.1007/s10035-010-0181-z (stress there has
/// the opposite sign); walls: T. Weinhart, A. R. Thornton, S. Luding, O. Bokhove, Granular Matter 14 (2012)
/// 289-294, doi:10.1007/s10035-012-0317-4. Line integrals are exact but for rounding. Within c of a wall the
/// kernel reaches beyond it: the density there falls to half of the bed's. No images of periodic faces are
/// made: within c of one, what lies beyond is missing.
///
/// Throws std::invalid_argument for c <= 0 and std::out_of_range for a parcel that does not exist. Same bits
/// for any number of threads.
ContinuumFields continuum_fields(std::span<const Vec3> points, std::span<const Particle> parcels,
                                 std::span<const PairForce> pairs, std::span<const WallForce> walls,
                                 double support);

/// Middles of the cells of a grid of `cells` over the die, in the coordinates of the container; index =
/// first + cells[0] * (second + cells[1] * third).
std::vector<Vec3> grid_points(const Container& container, const std::array<std::size_t, 3>& cells);

}  // namespace pulvis::measures
