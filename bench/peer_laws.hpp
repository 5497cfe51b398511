// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "validation/scene.hpp"

// The laws of the yardstick as LIGGGHTS and LAMMPS have them, for bench/peers.
namespace pulvis::peers {

struct PeerLaw {
  scenes::Stuff stuff;
  scenes::LawParts parts;
};

/// hertz, sjkr or jkr. Friction is limited by what limits it in the peers: with hertz and sjkr the normal force
/// with its dashpot, with jkr (LAMMPS) the elastic force and twice the pull-off force.
inline std::optional<PeerLaw> peer_law(const std::string& name) {
  PeerLaw law;
  if (name == "hertz" || name == "sjkr") {
    law.parts.choices.limit_includes_dashpot = true;
    if (name == "sjkr") law.parts.cohesion = "sjkr", law.stuff.cohesion_energy_density = 1e4;
  } else if (name == "jkr") {
    law.parts.normal = "jkr";
    law.parts.choices.damping_on_jkr_radius = true;
    law.stuff.work_of_adhesion = 0.1;  // LAMMPS is given the energy of one surface, 0.05 J/m^2
  } else {
    return std::nullopt;
  }
  return law;
}

}  // namespace pulvis::peers
