// SPDX-License-Identifier: Apache-2.0
// Time per particle-step and memory on settled beds of growing size: step_time [--threads N] [--jkr]
// [--energy] [--look-every STEPS] [COUNT...] A bed of 10,000 is settled once and laid side by side, so that all sizes are
// the same bed.
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "validation/scene.hpp"

namespace {

using namespace pulvis;

constexpr std::size_t tile = 10000;
constexpr double width = 0.04;  // m
constexpr int settling_steps = 30000, warm_up = 300;

/// Seconds: of the processor with one thread, so that other programs disturb less; else of the wall clock.
double now(int threads) {
  if (threads == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

void measure(const State& settled, std::size_t count, const scenes::Stuff& stuff,
             const scenes::LawParts& parts, bool energy, int threads, int look_every) {
  const auto tiles = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count) / tile)));
  Model model = scenes::yardstick_model(stuff, parts, width * std::max(tiles, 1u), 0.3);
  model.energy_ledger = energy;
  Simulation simulation(model, scenes::tiled(settled, width, std::max(tiles, 1u)), threads);
  for (int k = 0; k < warm_up; ++k) simulation.step();
  const std::size_t parcels = simulation.state().parcels.size();
  const int steps = static_cast<int>(std::max<std::size_t>(100, 20'000'000 / parcels));
  const auto rebuilds = simulation.rebuilds();
  const double start = now(threads);
  // A run looks at the state every 16 steps or so.
  for (int k = 1; k <= steps; ++k)
    simulation.step(k % look_every == 0 || k == steps ? Simulation::Then::look : Simulation::Then::go_on);
  const double per = (now(threads) - start) / steps / static_cast<double>(parcels);
  std::size_t touching = 0;
  for (const auto t : simulation.pairs().touching) touching += t;
  const auto n = static_cast<double>(parcels);
  fmt::print("{:>10} {:>8} {:>10.1f} {:>12.2f} {:>10.2f} {:>10.2f} {:>12.4f} {:>12.0f} {:>12.0f}\n", parcels,
             threads, per * 1e9, 1e-6 / per, static_cast<double>(touching) / n,
             static_cast<double>(simulation.pairs().slots()) / n,
             static_cast<double>(simulation.rebuilds() - rebuilds) / steps,
             static_cast<double>(simulation.memory()) / n, peak_bytes() / n);
}

}  // namespace

int main(int argc, char** argv) {
  int threads = 1, look_every = 16;
  bool energy = false;  // with the ledger of energy
  scenes::LawParts parts;
  scenes::Stuff stuff;
  std::vector<std::size_t> counts;
  for (int k = 1; k < argc; ++k) {
    if (!std::strcmp(argv[k], "--threads") && k + 1 < argc)
      threads = std::stoi(argv[++k]);
    else if (!std::strcmp(argv[k], "--energy"))
      energy = true;
    else if (!std::strcmp(argv[k], "--look-every") && k + 1 < argc)
      look_every = std::stoi(argv[++k]);
    else if (!std::strcmp(argv[k], "--jkr")) {
      parts.normal = "jkr";
      stuff.work_of_adhesion = 0.1;
    } else
      counts.push_back(std::stoul(argv[k]));
  }
  if (counts.empty()) counts = {10000, 90000, 1000000};
  fmt::print("{} kernels; settling a bed of {}\n", kernels::name_of(kernels::instruction_set()), tile);
  const State settled = scenes::settled_yardstick(stuff, parts, width, tile, settling_steps, threads);
  fmt::print("{:>10} {:>8} {:>10} {:>12} {:>10} {:>10} {:>12} {:>12} {:>12}\n", "parcels", "threads",
             "ns/step", "Mp-steps/s", "contacts", "near", "rebuild/step", "bytes", "peak bytes");
  for (const std::size_t count : counts) measure(settled, count, stuff, parts, energy, threads, look_every);
  return 0;
}
