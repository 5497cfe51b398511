// SPDX-License-Identifier: Apache-2.0
#include "validation/rolling_pile.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "validation/incline.hpp"
#include "validation/sums.hpp"

// TC3: a column of spheres whose container is taken away. Ai et al. (2011) did it in a plane, the LIGGGHTS family's
// test with 2,000 spheres in a cylinder of 15 radii.
//
// In space spheres spin about the normals of their contacts too, and a law of rolling has nothing against that: one
// that comes to lie alone on the floor spins for ever. So the heap in space has resistance to twisting as well,
// and is shown without; in the plane no contact can twist, and rolling resistance must do alone.
namespace pulvis::validation {
namespace {

using scenes::Incline;

constexpr double radius = Incline::radius;
constexpr double settling = 0.6, watching = 5.0;  // s: in the container, and without it
constexpr const char* ai =
    "rest; Ai et al. (2011), doi:10.1016/j.powtec.2010.09.030, with 2,000 spheres in a cylinder as in "
    "LIGGGHTS";
constexpr const char* ai_plane = "rest; Ai et al. (2011), doi:10.1016/j.powtec.2010.09.030";

struct Laws {
  const char* label;
  const char* rolling;
  const char* twisting;
};

Model model(const Laws& laws, double width, double height, double dt) {
  laws::MaterialPair pair = Incline{.friction = 0.8, .rolling_friction = 0.2}.material();
  pair.twisting_friction = pair.rolling_friction;
  scenes::LawParts parts;
  parts.rolling = laws.rolling;
  parts.twisting = laws.twisting;
  const double far = 8.0 * width + 0.5;
  Model m =
      scenes::one_pair(pair, parts, {-far, -far, -0.02}, {far, far, 2.0 * height + 0.1}, dt, radius, radius);
  scenes::add_wall(m, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  m.walls.bodies.push_back({"container", {}});
  return m;
}

void contain(Model& m, Surface surface) {
  surface.body = 1;
  m.walls.surfaces.push_back(surface);
}

/// Spheres packed at random in a cylinder, 15 radii wide for 2,000 of them, higher than they stand in it.
Simulation cylinder(const Laws& laws, int count, double dt) {
  const double wide = 15.0 * radius * std::cbrt(count / 2000.0);
  const double tall = count * sphere_volume(radius) / (0.3 * std::numbers::pi * wide * wide);
  Model m = model(laws, wide, tall, dt);
  for (const Surface& s :
       frustum_surfaces("container", {0, 0, -radius}, {0, 0, 1}, wide, wide, 1.2 * tall, {"base", "top"}))
    contain(m, s);
  SourceModel pack;
  pack.name = "pack";
  pack.density = Incline::density;
  SizeLaw single;
  single.diameter = single.smallest = single.largest = 2.0 * radius;
  pack.sizes = SizeSampler(single);
  pack.region.shape = Region::Shape::cylinder;
  pack.region.radius = wide;
  pack.region.height = tall;
  pack.target_count = static_cast<std::uint64_t>(count);
  m.sources.push_back(pack);
  Simulation s(m, Simulation::initial_state(m), 1);
  s.open_source(0);
  return s;
}

/// Spheres that stay in a plane, between two walls, twice as high as wide; put down on a lattice with some disorder.
Simulation slot(const Laws& laws, int count, double dt) {
  const int columns = static_cast<int>(std::lround(std::sqrt(0.5 * count)));
  const double half = 1.1 * columns * radius, tall = 2.3 * radius * (count / columns + 2);
  Model m = model(laws, 2.0 * half, tall, dt);
  contain(m, plane_surface("left", {-half, 0, 0}, {1, 0, 0}));
  contain(m, plane_surface("right", {half, 0, 0}, {-1, 0, 0}));
  std::mt19937_64 random(1);
  const auto about = [&random](double middle, double spread) {
    return radius * (middle + spread * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5));
  };
  std::vector<Parcel> spheres;
  for (int k = 0; k < count; ++k)
    spheres.push_back(scenes::parcel(
        static_cast<std::uint32_t>(k),
        {about(1.1 + 2.2 * (k % columns), 0.15) - half, 0, about(1.1 + 2.25 * (k / columns), 0.1)}, radius,
        Incline::density));
  return Simulation(m, scenes::state_of(m, spheres), 1);
}

/// Mean kinetic energy of a sphere over m g R, spin included, after the container is gone.
Curve energy_after(Simulation s, const char* label) {
  scenes::run_to(s, settling);
  s.set_absent(1, true);
  Curve c{label, {}, {}, false};
  constexpr double between_points = 0.05;  // s
  while (c.x.empty() || c.x.back() < watching - 0.5 * between_points) {
    scenes::run_to(s, settling + between_points * static_cast<double>(c.x.size() + 1));
    const Parcels& all = s.state().parcels;
    const double unit = static_cast<double>(all.size()) * Incline::mass() * Incline::gravity * radius;
    c.x.push_back(s.time() - settling);
    c.y.push_back(scenes::kinetic_energy(all) / unit);
  }
  if (s.state().ledger.escaped > 0)
    c.y.back() = std::numeric_limits<double>::quiet_NaN();  // it ran out of room
  return c;
}

std::string name(const char* heap, int count, const Laws& laws) {
  return fmt::format("TC3 {} of {} spheres, {}: mean kinetic energy over m g R, {:g} s after", heap, count,
                     laws.label, watching);
}

}  // namespace

void rolling_pile(Findings& f, Effort effort) {
  const int count = effort == Effort::quick ? 250 : 2000;
  const double automatic = Incline::automatic_step();
  const double dt = effort == Effort::quick ? automatic : Incline::published_step;
  Figure figure{"rolling-heap",
                "A heap comes to rest after its cylinder is gone",
                "time (s)",
                "mean kinetic energy / m g R",
                {},
                false,
                true};

  const Laws both{"EPSD2 with twisting resistance", "elastic_plastic", "elastic_plastic"};
  figure.curves.push_back(energy_after(cylinder(both, count, dt), both.label));
  Row& rest =
      f.compare(name("heap", count, both), ai, 0.0, figure.curves.back().y.back(), Compare::bound, 1e-10);
  rest.automatic = dt == automatic ? rest.value : energy_after(cylinder(both, count, automatic), "").y.back();

  // Beside it: CDT, whose torque flips, and EPSD2 where spin about the normal is free.
  for (const Laws& other : {Laws{"CDT with twisting resistance", "constant_torque", "elastic_plastic"},
                            Laws{"EPSD2 without it", "elastic_plastic", "none"}}) {
    figure.curves.push_back(energy_after(cylinder(other, count, automatic), other.label));
    f.compare(name("heap", count, other), ai, 0.0, figure.curves.back().y.back(), Compare::bound,
              std::nullopt);
  }

  constexpr int in_plane = 150;
  const Laws alone{"EPSD2", "elastic_plastic", "none"};
  figure.curves.push_back(energy_after(slot(alone, in_plane, dt), "EPSD2 in a plane"));
  Row& plane = f.compare(name("plane heap", in_plane, alone), ai_plane, 0.0, figure.curves.back().y.back(),
                         Compare::bound, 1e-10);
  plane.automatic =
      dt == automatic ? plane.value : energy_after(slot(alone, in_plane, automatic), "").y.back();
  f.figure(figure);
}

}  // namespace pulvis::validation
