// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/contacts/contact_classes.hpp"
#include "engine/dynamics/body_force.hpp"
#include "engine/insertion/source.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/walls/bodies.hpp"
#include "engine/walls/motions/motion.hpp"

namespace pulvis {

/// Everything about a run that never changes while it runs. SI.
struct Model {
  Box domain;
  BodyForce body_force;
  double dt = 0.0;  ///< s
  ContactClasses classes;
  Walls walls;
  std::vector<motions::Motion> motions;
  std::vector<SourceModel> sources;
  std::uint64_t seed = 1;
  bool energy_ledger = false;  ///< whether energies are added up; changes no other bit of the state
  double smallest_radius = 0.0, largest_radius = 0.0;  ///< m, of all parcels that can appear
  /// Overlap of two parcels over the smaller radius at which a run stops.
  double largest_overlap = 0.5;
  /// Scales the margin of the neighbour lists; changes speed, never a bit of the result.
  double skin = 1.0;
  /// A thread is worth waking for this many parcels: below, waiting for each other costs more than it saves.
  /// Changes speed only.
  std::size_t parcels_per_thread = 5000;
};

}  // namespace pulvis
