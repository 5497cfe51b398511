// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "validation/scene.hpp"

// Scenes for any law of the catalogue: materials that have what each of them needs.
namespace pulvis::scenes {

/// Soft, rough, sticky and wet: every property that any law asks for, such that no force dwarfs the others on
/// spheres of a millimetre.
inline laws::MaterialPair with_every_property(const Stuff& a, const Stuff& b) {
  laws::MaterialPair m = material_pair(a, b);
  m.rolling_viscosity = 0.3;
  m.twisting_friction = 0.1;
  m.characteristic_speed = 0.2;
  m.tangential_ratio = 0.8;
  m.plastic_ratio = 5.0;
  m.adhesion_ratio = 0.3;
  m.plasticity_depth = 0.05;
  m.unloading_ratio = 4.0;
  m.constant_pull = -1e-6;
  m.cohesion_energy_density = 2e4;
  m.surface_tension = 0.072;
  m.contact_angle = 0.2;
  m.liquid_content = 1e-3;
  m.liquid_viscosity = 1e-3;
  m.hamaker_constant = 1e-11;  // strong and far, to be felt by spheres of this size
  m.shortest_gap = 1e-6;
  m.longest_gap = 1e-4;
  return m;
}

inline LawParts parts_of(const laws::Law& law, const laws::Choices& choices = {}) {
  return {std::string(law.normal->name),
          std::string(law.damping->name),
          std::string(law.sliding->name),
          std::string(law.rolling->name),
          choices,
          std::string(law.cohesion->name),
          std::string(law.twisting->name)};
}

}  // namespace pulvis::scenes
