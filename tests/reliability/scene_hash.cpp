// SPDX-License-Identifier: Apache-2.0
// Runs a case without output or measures and prints the hash of its last state: what must be the same however it is
// run. usage: scene_hash CASE [--threads N] [--skin X] [--save-every STEPS]
#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "case/reader.hpp"
#include "engine/simulation/simulation.hpp"
#include "run/assemble.hpp"
#include "run/procedure.hpp"

namespace {

using namespace pulvis;

struct Way {
  std::string file;
  int threads = 1;
  double skin = 1.0;             ///< over the usual one
  std::uint64_t save_every = 0;  ///< steps after which the state goes to bytes and back; 0: never
};

Way way_of(int argc, char** argv) {
  Way way;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const char* value = k + 1 < argc ? argv[k + 1] : "";
    if (word == "--threads")
      way.threads = std::atoi(value), ++k;
    else if (word == "--skin")
      way.skin = std::atof(value), ++k;
    else if (word == "--save-every")
      way.save_every = std::strtoull(value, nullptr, 10), ++k;
    else
      way.file = word;
  }
  if (way.file.empty() || way.threads < 1 || !(way.skin > 0.0))
    throw Failure(Exit::usage, "usage: scene_hash CASE [--threads N] [--skin X] [--save-every STEPS]");
  return way;
}

/// Runs from a state until the case is over or the state is to be saved.
State advance(const Case& c, const Model& model, State state, const Way& way, bool& finished) {
  Simulation simulation(model, std::move(state), way.threads);
  Procedure procedure(c, simulation);
  while (!procedure.finished()) {
    const bool saves = way.save_every != 0 && (simulation.state().step + 1) % way.save_every == 0;
    const bool looks = saves || procedure.may_end_after_next_step();
    simulation.step(looks ? Simulation::Then::look : Simulation::Then::go_on);
    if (!looks) continue;
    if (procedure.ended()) procedure.next_phase();
    if (saves) return simulation.snapshot();
  }
  finished = true;
  return simulation.snapshot();
}

void run(const Way& way) {
  const Case c = read_case(way.file);
  Model model = assemble(c).model;
  model.skin = way.skin;
  model.parcels_per_thread = 50;  // so that few parcels keep many threads busy
  State state = Simulation::initial_state(model);
  for (bool finished = false; !finished;)
    state = load_state(save_state(advance(c, model, std::move(state), way, finished)));
  fmt::print("{} {} steps, {} parcels, {} contacts, {} with walls\n", state_hash(state), state.step,
             state.parcels.size(), state.pairs.size(), state.walls.size());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(way_of(argc, argv));
    return 0;
  } catch (const Failure& failure) {
    fmt::print(stderr, "{}\n", failure.what());
    return static_cast<int>(failure.code());
  }
}
