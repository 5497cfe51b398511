// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "validation/draw.hpp"
#include "validation/scene.hpp"

// A small scene with everything in it that could make a result depend on what it must not depend on: sticky
// parcels of many sizes, some of which wait and some of which rain, a box, and a floor that shakes.
namespace pulvis::scenes {

inline constexpr std::uint64_t sticky_steps = 4000;

inline Model sticky_model(double skin = 1.0) {
  Stuff stuff;
  stuff.young_modulus = 1e6;
  stuff.work_of_adhesion = 0.05;
  LawParts parts;
  parts.normal = "jkr";
  Model m = one_material(stuff, parts, {0, 0, -0.002}, {0.008, 0.008, 0.04}, 2e-5, 0.3e-3, 0.5e-3);
  m.domain.periodic[1] = true;
  m.walls.bodies = {{"box", {}}, {"floor", {0}}};
  Region box;
  box.min = {0, -1, -0.01};
  box.max = {0.008, 1, 0.05};
  m.walls.surfaces = box_surfaces("box", box, {"-y", "+y", "-z", "+z"});
  m.walls.surfaces.push_back(plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  m.walls.surfaces.back().body = 1;
  m.motions = {{motions::Sine{{2e-4, 50.0, -0.25}, {0, 0, 1}}}};
  SourceModel rain;
  rain.name = "rain";
  rain.kind = SourceModel::Kind::rain;
  rain.density = 2500.0;
  SizeLaw law;
  law.kind = SizeKind::uniform;
  law.smallest = 0.6e-3;
  law.largest = 1.0e-3;
  rain.sizes.emplace(law);
  rain.region.min = {0, 0, 0.025};
  rain.region.max = {0.008, 0.008, 0.03};
  rain.velocity = {0, 0, -0.4};
  rain.rate = 3e-3;
  rain.target_count = 200;
  m.sources = {rain};
  m.skin = skin;
  return m;
}

/// Its material for laws that remember more than springs, pull across gaps or are wet.
inline laws::MaterialPair remembering_pair() {
  Stuff stuff;
  stuff.young_modulus = 1e6;
  laws::MaterialPair pair = material_pair(stuff, stuff);
  pair.work_of_adhesion = 0.05;
  pair.unloading_ratio = 4.0;
  pair.surface_tension = 0.05;
  pair.liquid_content = 1e-3;
  pair.liquid_viscosity = 1e-3;
  return pair;
}

inline std::vector<Parcel> sticky_parcels() {
  std::vector<Parcel> list;
  for (std::uint32_t k = 0; k < 400; ++k) {
    pulvis::validation::Draw draw(k, 31);
    const double radius = draw.between(0.3e-3, 0.5e-3);
    const Vec3 at{(0.55 + 1.1 * (k % 7)) * 1e-3, (0.55 + 1.1 * (k / 7 % 7)) * 1e-3,
                  (0.8 + 1.05 * (k / 49)) * 1e-3};
    list.push_back(parcel(k, at, radius, 2500.0, draw.vector(0.1), draw.vector(100.0)));
  }
  return list;
}

inline Simulation sticky_start(int threads, double skin = 1.0,
                               std::vector<Parcel> parcels = sticky_parcels()) {
  const Model m = sticky_model(skin);
  Simulation s(m, state_of(m, parcels), threads);
  s.open_source(0);
  s.start_motion(0);
  return s;
}

inline void go(Simulation& s, std::uint64_t steps) {
  for (std::uint64_t k = 0; k < steps; ++k) s.step();
}

}  // namespace pulvis::scenes
