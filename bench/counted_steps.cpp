// SPDX-License-Identifier: Apache-2.0
// Fixed pieces of work for tools/instruction-count, each in a function of its own: counted_steps [--about]
// `--about` prints what was compiled, since the counts hold for that alone, and names the pieces.
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <optional>

#include "engine/base/failure.hpp"
#include "validation/scene.hpp"

namespace {

using namespace pulvis;

constexpr double radius = 0.00125, spacing = 1.98 * radius;  // m: neighbours overlap a little
constexpr std::uint32_t along = 10, layers = 10;

/// A cubic lattice on a floor, periodic sideways, each parcel with a small velocity of its own: a dense bed that need not
/// settle first.
Simulation bed(const scenes::Stuff& stuff, const scenes::LawParts& parts, bool energy_ledger = false) {
  Model model = scenes::yardstick_model(stuff, parts, along * spacing, (layers + 5) * spacing);
  model.energy_ledger = energy_ledger;
  std::vector<Parcel> parcels;
  for (std::uint32_t id = 0; id < along * along * layers; ++id) {
    const double x = id % along + 0.5, y = id / along % along + 0.5, z = id / (along * along) + 0.5;
    const auto [u, v, w] = uniform_triple(1, 0, id, 0);
    const Vec3 velocity = 0.02 * Vec3{u - 0.5, v - 0.5, w - 0.5};  // m/s
    parcels.push_back(scenes::parcel(id, spacing * Vec3{x, y, z}, radius, stuff.density, velocity));
  }
  return {model, scenes::state_of(model, parcels), 1};
}

/// One layer on the floor: as many contacts with walls as parcels.
Simulation layer() {
  const scenes::Stuff stuff;
  constexpr std::uint32_t edge = 30;
  Model model = scenes::yardstick_model(stuff, {}, edge * 2.2 * radius, 0.05);
  std::vector<Parcel> parcels;
  for (std::uint32_t id = 0; id < edge * edge; ++id)
    parcels.push_back(scenes::parcel(
        id, {2.2 * radius * (id % edge + 0.5), 2.2 * radius * (id / edge + 0.5), 0.99 * radius}, radius,
        stuff.density, {0.01, 0.005, 0.0}));
  return {model, scenes::state_of(model, parcels), 1};
}

void advance(Simulation& simulation, int steps) {
  for (int k = 1; k <= steps; ++k)
    simulation.step(k % 16 == 0 ? Simulation::Then::look : Simulation::Then::go_on);
}

}  // namespace

// What is counted: everything between entering one of these and leaving it.
#define COUNTED extern "C" __attribute__((noinline, noclone)) void

COUNTED counted_hertz(Simulation& simulation) { advance(simulation, 96); }
COUNTED counted_jkr(Simulation& simulation) { advance(simulation, 96); }
COUNTED counted_walls(Simulation& simulation) { advance(simulation, 192); }
COUNTED counted_energy_ledger(Simulation& simulation) { advance(simulation, 32); }
/// A wall that goes and comes back renews all lists.
COUNTED counted_near_lists(Simulation& simulation) {
  for (int k = 0; k < 16; ++k) {
    simulation.set_absent(0, true);
    simulation.set_absent(0, false);
  }
}

int main(int argc, char** argv) {
  if (argc == 2 && !std::strcmp(argv[1], "--about")) {
    fmt::print("{}\nhertz near_lists jkr energy_ledger walls\n", PULVIS_BUILD);
    return 0;
  }
  const char* set = std::getenv("PULVIS_INSTRUCTION_SET");
  if (argc > 1 || !set || std::strcmp(set, "baseline") != 0) {
    fmt::print(stderr, "usage: PULVIS_INSTRUCTION_SET=baseline counted_steps [--about]\n");
    return static_cast<int>(Exit::usage);
  }
  scenes::Stuff adhesive;
  adhesive.work_of_adhesion = 0.1;
  scenes::LawParts jkr;
  jkr.normal = "jkr";
  std::optional<Simulation> simulation;
  counted_hertz(simulation.emplace(bed({}, {})));
  counted_near_lists(*simulation);
  counted_jkr(simulation.emplace(bed(adhesive, jkr)));
  counted_energy_ledger(simulation.emplace(bed(adhesive, jkr, true)));
  counted_walls(simulation.emplace(layer()));
  return 0;
}
