// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "measures/tensor.hpp"

namespace pulvis::measures {

/// A contact between two parcels as stress sees it: places in the list of parcels.
struct PairForce {
  std::uint32_t first = 0, second = 0;
  Vec3 force{};   ///< N; the whole force on the first
  Vec3 branch{};  ///< m; centre of the first less that of the second (across a periodic face: the short way)
};

/// A contact between a parcel and a wall.
struct WallForce {
  std::uint32_t parcel = 0;
  Vec3 force{};   ///< N; the whole force on the parcel
  Vec3 branch{};  ///< m; centre of the parcel less the point of contact
};

/// Where a parcel is and how it moves.
struct Particle {
  Vec3 position{};      ///< m
  Vec3 velocity{};      ///< m/s
  double mass = 0.0;    ///< kg
  double radius = 0.0;  ///< m
};

/// Mean stress in a volume, Pa, compressive positive: pressing gives a positive diagonal. Row: component of
/// the force or of the velocity; column: direction of the branch. In coordinates of the vectors given.
struct Stress {
  double volume = 0.0;   ///< m^3
  Tensor contact{};      ///< Pa; what contacts carry
  Tensor kinetic{};      ///< Pa; what the parcels' velocities about their mean carry
  Vec3 mean_velocity{};  ///< m/s; mass-weighted mean of the parcels that count

  Tensor total() const { return contact + kinetic; }
  double pressure() const { return total().trace() / 3.0; }          ///< Pa
  double kinetic_pressure() const { return kinetic.trace() / 3.0; }  ///< Pa
};

/// Throws std::out_of_range if a force names a parcel that is not among `parcels` many.
void check_forces(std::span<const PairForce> pairs, std::span<const WallForce> walls, std::size_t parcels);

/// Stress of the parcels with a non-zero `counted`, which fill the volume V (m^3, pores included):
///   sigma_ij = (1/V) [ sum_c s_c f_i l_j + sum_p m v'_i v'_j ]
/// f: force on the first of contact c, l: its branch, from the second's centre to the first's; both point the
/// same way where the contact pushes. s_c = 1 if both parcels count, 1/2 if one does: half a branch belongs to
/// each parcel. A wall's contact counts whole for its parcel, with the branch from the contact point to the
/// centre. v' = v less the mass-weighted mean velocity of the parcels that count.
///
/// Source of the contact part: Love's and Weber's mean stress, as in J. Christoffersen, M. M. Mehrabadi,
/// S. Nemat-Nasser, Journal of Applied Mechanics 48 (1981) 339-344; of both parts, with the opposite sign:
/// I. Goldhirsch, Granular Matter 12 (2010) 239-252, doi:10.1007/s10035-010-0181-z. Valid as a mean over many
/// parcels; the halving of branches at the region's edge errs by some parcels' layer over its width. Balance
/// of torque makes the sum over a body at rest symmetric; that over a region need not be.
///
/// Throws std::out_of_range for a parcel that does not exist, std::invalid_argument if V is not above zero.
Stress stress(std::span<const Particle> parcels, std::span<const std::uint8_t> counted,
              std::span<const PairForce> pairs, std::span<const WallForce> walls, double volume);

}  // namespace pulvis::measures
