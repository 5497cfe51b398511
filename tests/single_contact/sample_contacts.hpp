// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "engine/laws/estimates.hpp"
#include "single_contact/contact.hpp"

namespace pulvis::testing {

/// Two molybdenum grains of 4.6 um, softened, with a number for every law of the catalogue.
constexpr double radius = 2.3e-6, density = 10200.0, young = 1e7, poisson = 0.3, work = 2e-4;
inline const double mass = density * 4.0 / 3.0 * M_PI * radius * radius * radius;
inline const double reduced_radius = 0.5 * radius, reduced_mass = 0.5 * mass;
inline const double effective = laws::effective_modulus(young, poisson, young, poisson);
inline const single_contact::Bodies grains{radius, radius, mass, mass}, grain_at_wall{radius, 0, mass, 0};

inline laws::MaterialPair sample_material() {
  laws::MaterialPair m;
  m.effective_modulus = effective;
  m.effective_shear_modulus = laws::effective_shear_modulus(young, poisson, young, poisson);
  m.work_of_adhesion = work;
  m.restitution = 0.5;
  m.characteristic_speed = 0.05;
  m.plastic_ratio = 5.0;
  m.adhesion_ratio = 0.2;
  m.plasticity_depth = 0.05;
  m.unloading_ratio = 4.0;
  m.constant_pull = -1e-11;
  m.cohesion_energy_density = 2e4;
  m.surface_tension = 2e-5;
  m.contact_angle = 0.2;
  m.liquid_content = 1e-3;
  m.liquid_viscosity = 1e-6;
  m.hamaker_constant = 1e-20;
  m.shortest_gap = 4e-10;
  m.longest_gap = 4e-8;
  return m;
}

inline single_contact::Contact contact_of(const std::string& normal, const std::string& cohesion = "none",
                                          const laws::MaterialPair& material = sample_material(),
                                          const laws::Choices& choices = {},
                                          const single_contact::Bodies& bodies = grains) {
  return {laws::find_law(normal, "restitution", "none", "none", cohesion), material, choices, bodies};
}

struct Named {
  std::string name;
  single_contact::Contact contact;
};

/// Every normal law, and every law of cohesion on Hertz and on Hooke where that holds, on a grain and on a wall.
inline std::vector<Named> all_contacts() {
  std::vector<Named> list;
  const auto add = [&](const std::string& normal, const std::string& cohesion) {
    if (!laws::find_law(normal, "restitution", "none", "none", cohesion)
             .problems(sample_material(), {})
             .empty())
      return;
    for (const bool approach : {false, true}) {
      laws::Choices choices;
      choices.bridges_form_on_approach = approach;
      if (approach && !cohesion.starts_with("capillary")) continue;
      for (const auto& bodies : {grains, grain_at_wall})
        list.push_back({normal + " " + cohesion + (approach ? " on approach" : "") +
                            (bodies.radius_second > 0.0 ? "" : " at a wall"),
                        contact_of(normal, cohesion, sample_material(), choices, bodies)});
    }
  };
  for (const auto& normal : laws::catalogue().normal)
    for (const auto& cohesion : laws::catalogue().cohesion)
      add(std::string(normal.name), std::string(cohesion.name));
  return list;
}

}  // namespace pulvis::testing
