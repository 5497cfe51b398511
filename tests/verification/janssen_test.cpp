// SPDX-License-Identifier: Apache-2.0
// A column of beads in a rough cylinder, its floor lowered a little, so that friction at the wall is roused: walls and
// floor together bear the weight, and the stress saturates with depth as H. A. Janssen, Z. Ver. Dtsch. Ing. 39
// (1895) 1045, has it. With the weight above over the cross-section, p, for depth (as L. Vanel, E. Clement, Eur.
// Phys. J. B 11 (1999) 525, plot it) it has one parameter:
//   sigma = s (1 - exp(-p/s))
#include <gtest/gtest.h>

#include <cmath>

#include "validation/scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr double radius = 0.5e-3, tube = 4e-3, gravity = 9.81, density = 2500.0;
constexpr int count = 1500;
// One bead thick, from the top down; the five or so above the floor are left out, where the floor's own friction
// turns the stress.
constexpr std::size_t layers = 21;

struct Column {
  double weight = 0.0, borne = 0.0, floor = 0.0;  ///< N
  // At the lower end of each layer, Pa: the weight above over the cross-section, and what of it is not yet borne.
  std::vector<double> above = std::vector<double>(layers, 0.0), stress = std::vector<double>(layers, 0.0);
};

Model column_model(std::uint64_t seed) {
  Stuff stuff{density, 5e6, 0.3, 0.3, 0.5, 0.1, 0.0};
  Model m = one_material(stuff, {}, {-5e-3, -5e-3, -3e-3}, {5e-3, 5e-3, 80e-3}, 8e-6, radius, radius);
  m.seed = seed;
  Region region;
  region.shape = Region::Shape::cylinder;
  region.base = {0, 0, -6e-3};
  region.axis = {0, 0, 1};
  region.radius = tube;
  region.height = 80e-3;
  for (Surface s : cylinder_surfaces("tube", region, {"base", "top"})) add_wall(m, s);
  m.walls.bodies.push_back({"floor", {0}});
  m.walls.surfaces.push_back(plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  m.walls.surfaces.back().body = 1;
  m.motions = {{motions::Translation{{0, 0, -4e-3}}}};
  SourceModel pack;
  pack.name = "pack";
  pack.density = density;
  SizeLaw single;
  single.diameter = single.smallest = single.largest = 2.0 * radius;
  pack.sizes = SizeSampler(single);
  region.base = {0, 0, 0};
  region.height = count * sphere_volume(radius) / (0.28 * pi * tube * tube);
  pack.region = region;
  pack.velocity = {0, 0, -0.3};
  pack.target_count = count;
  m.sources.push_back(pack);
  return m;
}

/// Adds what walls bear now; the top of the column is its highest bead.
void look(const Simulation& s, Column& sum) {
  double top = -1.0;
  for (const Parcel& p : s.state().parcels.body) top = std::max(top, p.position.z + p.radius);
  std::vector<double> weight(layers + 1, 0.0), shear(layers + 1, 0.0);
  const auto layer = [&](double z) {
    return std::min(static_cast<std::size_t>((top - z) / (2.0 * radius)), layers);
  };
  for (const Parcel& p : s.state().parcels.body) {
    weight[layer(p.position.z)] += p.mass * gravity;
    sum.weight += p.mass * gravity;
  }
  const NearWalls& w = s.walls();
  for (const std::uint32_t slot : s.wall_slots_by_id()) {
    if (!w.touching[slot]) continue;
    const double up = w.load[slot].force.z;
    sum.borne += up;
    if (w.surface[slot] == 0)
      shear[layer(s.state().parcels.body[w.parcel[slot]].position.z)] += up;
    else
      sum.floor += up;
  }
  double above = 0.0, held = 0.0;
  for (std::size_t k = 0; k < layers; ++k) {
    above += weight[k];
    held += shear[k];
    sum.above[k] += above / (pi * tube * tube);
    sum.stress[k] += (above - held) / (pi * tube * tube);
  }
}

Column settle_lower_and_look(std::uint64_t seed) {
  const Model m = column_model(seed);
  Simulation s(m, Simulation::initial_state(m), 1);
  s.open_source(0);
  for (int k = 0; k < 15000; ++k) s.step();
  // Half a bead's way until friction is roused everywhere, then the mean over half of one: long enough that what the
  // powder gains in momentum is below a thousandth of its weight, and looked at often enough for its jerks.
  s.start_motion(0);
  for (int k = 0; k < 16000; ++k) s.step();
  Column sum;
  constexpr int looks = 3000;
  for (int k = 0; k < 5 * looks; ++k) {
    s.step();
    if (k % 5 == 0) look(s, sum);
  }
  for (double* value : {&sum.weight, &sum.borne, &sum.floor}) *value /= looks;
  for (std::vector<double>* list : {&sum.above, &sum.stress})
    for (double& value : *list) value /= looks;
  return sum;
}

/// R^2 of Janssen's form.
double fit(const Column& c, double saturation) {
  double mean = 0.0, off = 0.0, spread = 0.0;
  for (const double stress : c.stress) mean += stress / double(layers);
  for (std::size_t k = 0; k < layers; ++k) {
    const double form = saturation * (1.0 - std::exp(-c.above[k] / saturation));
    off += (c.stress[k] - form) * (c.stress[k] - form);
    spread += (c.stress[k] - mean) * (c.stress[k] - mean);
  }
  return 1.0 - off / spread;
}

}  // namespace

TEST(JanssenColumn, BearsItsWeightAndSaturatesWithDepth) {
  Column mean;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Column c = settle_lower_and_look(seed);
    mean.weight += c.weight / 5.0;
    mean.borne += c.borne / 5.0;
    mean.floor += c.floor / 5.0;
    for (std::size_t k = 0; k < layers; ++k) {
      mean.above[k] += c.above[k] / 5.0;
      mean.stress[k] += c.stress[k] / 5.0;
    }
  }
  EXPECT_NEAR(mean.borne / mean.weight, 1.0, 1e-3);
  EXPECT_LT(mean.floor, 0.5 * mean.weight) << "the wall bears most of the weight";
  double best = -1.0, saturation = 0.0;
  for (double s = 10.0; s < 1000.0; s *= 1.005)
    if (const double r2 = fit(mean, s); r2 > best) best = r2, saturation = s;
  std::printf("Janssen: borne/weight %.6f, floor/weight %.4f, saturation %.4g Pa, R2 %.5f\n",
              mean.borne / mean.weight, mean.floor / mean.weight, saturation, best);
  EXPECT_GT(best, 0.98);
}
