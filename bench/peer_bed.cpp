// SPDX-License-Identifier: Apache-2.0
// A bed as LIGGGHTS and LAMMPS dump it, on the yardstick's floor, for bench/peers:
// peer_bed hertz|sjkr|jkr DUMP [--threads N] [--width METRES] [--height METRES] [--tiles N]
// Reads commands from standard input, as they do: "run STEPS" goes on and says "peers: done", "look" says what
// the bed is. Whoever sends them measures the time in between.
#include <fmt/format.h>
#include <malloc.h>

#include <cstdio>
#include <cstring>
#include <iostream>

#include "bench/peer_laws.hpp"
#include "engine/base/failure.hpp"
#include "run/bed_file.hpp"

namespace {

using namespace pulvis;

struct Wanted {
  std::string law, dump;
  int threads = 1;
  double width = 0.1, height = 0.4;  // m
  std::uint32_t tiles = 1;           // the bed beside itself, as many times along x and y
};

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

Model model_of(const Wanted& wanted, const peers::PeerLaw& law, double width) {
  Model model = scenes::yardstick_model(law.stuff, law.parts, width, wanted.height);
  model.classes = ContactClasses(2);
  model.classes.set(0, 0, scenes::contact_class(scenes::material_pair(law.stuff, law.stuff), law.parts));
  // The floor is not sticky (LAMMPS's jkr soon makes numbers that are none there); with W = 0 jkr is Hertz.
  peers::PeerLaw floor = law;
  floor.stuff.work_of_adhesion = 0.0;
  model.classes.set(0, 1,
                    scenes::contact_class(scenes::material_pair(floor.stuff, floor.stuff), floor.parts));
  for (Surface& surface : model.walls.surfaces) surface.species = 1;
  return model;
}

Simulation simulation_of(const Wanted& wanted, const peers::PeerLaw& law) {
  Model model = model_of(wanted, law, wanted.width);
  Bed bed = read_bed(wanted.dump, law.stuff.density, 0, model.domain);
  for (std::uint32_t k = 0; k < bed.parcels.size(); ++k) bed.parcels[k].id = k;
  State state = scenes::state_of(model, bed.parcels);
  if (wanted.tiles == 1) return Simulation(std::move(model), std::move(state), wanted.threads);
  return Simulation(model_of(wanted, law, wanted.width * wanted.tiles),
                    scenes::tiled(state, wanted.width, wanted.tiles), wanted.threads);
}

/// Kinetic energy of translation, J, mean height of the centres, m, and overlapping pairs, all per parcel. Of every
/// code's dump alike: overlaps are looked for, not taken from what a law says of them.
void look(const Simulation& simulation) {
  const auto& body = simulation.state().parcels.body;
  double energy = 0.0, height = 0.0;
  for (const Parcel& p : body) {
    energy += 0.5 * p.mass * dot(p.velocity, p.velocity);
    height += p.position.z;
  }
  std::size_t overlapping = 0;
  const NearPairs& pairs = simulation.pairs();
  for (std::size_t k = 0; k + 1 < pairs.begin.size(); ++k)
    for (std::uint32_t at = pairs.begin[k]; at < pairs.begin[k + 1]; ++at) {
      const std::uint32_t slot = pairs.entry[at] / 2;
      const Parcel &a = body[pairs.first[slot]], &b = body[pairs.second[slot]];
      const Vec3 d = simulation.images()(b.position - a.position);
      overlapping += norm(d) < a.radius + b.radius;
    }
  const auto n = static_cast<double>(body.size());
  // Each pair stood in two lists.
  say(fmt::format(
      "peers: bed parcels {} kinetic {:.9g} height {:.9g} contacts {:.9g} bytes {:.1f} rebuilds {}",
      body.size(), energy / n, height / n, 0.5 * static_cast<double>(overlapping) / n,
      static_cast<double>(simulation.memory()) / n, simulation.rebuilds()));
}

void run(Simulation& simulation, int steps) {
  // A run looks at the state every 16 steps or so.
  for (int k = 1; k <= steps; ++k)
    simulation.step(k % 16 == 0 || k == steps ? Simulation::Then::look : Simulation::Then::go_on);
  say("peers: done");
}

std::optional<Wanted> read_arguments(int argc, char** argv) {
  if (argc < 3) return std::nullopt;
  Wanted wanted;
  wanted.law = argv[1], wanted.dump = argv[2];
  for (int k = 3; k < argc; k += 2) {
    if (k + 1 == argc) return std::nullopt;
    const std::string name = argv[k], value = argv[k + 1];
    if (name == "--threads")
      wanted.threads = std::stoi(value);
    else if (name == "--width")
      wanted.width = std::stod(value);
    else if (name == "--height")
      wanted.height = std::stod(value);
    else if (name == "--tiles")
      wanted.tiles = static_cast<std::uint32_t>(std::stoul(value));
    else
      return std::nullopt;
  }
  return wanted;
}

int obey(const Wanted& wanted, const peers::PeerLaw& law) {
  say("peers: started");
  Simulation simulation = simulation_of(wanted, law);
  malloc_trim(0);  // what reading the dump took is no memory of the bed
  say("peers: ready");
  for (std::string command; std::cin >> command;) {
    int steps = 0;
    if (command == "look") {
      look(simulation);
    } else if (command == "run" && std::cin >> steps) {
      run(simulation, steps);
    } else {
      fmt::print(stderr, "peer_bed: \"{}\" is neither \"run STEPS\" nor \"look\"\n", command);
      return 2;
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto wanted = read_arguments(argc, argv);
    const auto law = wanted ? peers::peer_law(wanted->law) : std::nullopt;
    if (!law) {
      fmt::print(stderr,
                 "usage: peer_bed hertz|sjkr|jkr DUMP [--threads N] [--width METRES] [--height METRES] "
                 "[--tiles N]\n");
      return 2;
    }
    return obey(*wanted, *law);
  } catch (const Failure& failure) {
    fmt::print(stderr, "{}\n", failure.what());
    return static_cast<int>(failure.code());
  }
}
