// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/simulation/simulation.hpp"
#include "measures/energies.hpp"
#include "measures/shapes.hpp"
#include "measures/stress.hpp"

namespace pulvis {

/// A state in the form the measures take: parcels in order of their ids, contacts in that of the first's id and
/// then of the second's or the surface.
struct Sight {
  std::vector<measures::Sphere> spheres;
  std::vector<double> masses;
  std::vector<measures::Body> bodies;
  std::vector<std::uint32_t> index;                      ///< place in the store
  std::vector<measures::Contact> contacts;               ///< of parcels, stretched ones included
  std::vector<std::uint32_t> wall_contacts;              ///< the sphere, once for each wall it touches
  std::vector<std::uint32_t> contact_slots, wall_slots;  ///< of these contacts in the near lists
};
Sight look_at(const Simulation& simulation);

/// Contacts with other parcels, of each parcel.
std::vector<std::int32_t> contacts_of(const Sight& sight);

/// What contacts carry, in the order of the contacts of a sight of the same moment.
struct ForceSight {
  std::vector<measures::PairForce> pairs;
  std::vector<measures::WallForce> walls;
};
ForceSight forces_in(const Simulation& simulation, const Sight& sight);

/// F_n of a contact between parcels, N, positive pushing apart.
inline double normal_force(const measures::PairForce& pair) {
  return dot(pair.force, pair.branch) / norm(pair.branch);
}

}  // namespace pulvis
