// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

/// Parcels of a dump and the ids they have there.
struct Bed {
  std::vector<Parcel> parcels;
  std::vector<std::uint64_t> ids;
};

/// Reads the last frame of a LIGGGHTS or LAMMPS text dump (`ITEM: ...`) as parcels of one species, in order
/// of the dump's ids. Needs the columns id x y z radius (or diameter); takes vx vy vz and omegax omegay
/// omegaz if there; SI units. Parcels beyond the end of a periodic axis are brought back by one length. Throws
/// Failure(bad_input) with file, line and remedy for a file that is missing, truncated, not such a dump, of
/// several types of atoms, or has parcels outside the domain.
Bed read_bed(const std::string& path, double density, std::uint32_t species, const Box& domain);

}  // namespace pulvis
