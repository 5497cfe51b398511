// SPDX-License-Identifier: Apache-2.0
// Time per particle-step on settled beds of growing size: bench/step_time [--threads N] [--jkr] COUNT...
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "tests/support/scene.hpp"

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

int main(int argc, char** argv) {
  using namespace pulvis;
  int threads = 1;
  bool jkr = false;
  std::vector<std::size_t> counts;
  for (int k = 1; k < argc; ++k) {
    if (!std::strcmp(argv[k], "--threads") && k + 1 < argc) threads = std::stoi(argv[++k]);
    else if (!std::strcmp(argv[k], "--jkr")) jkr = true;
    else counts.push_back(std::stoul(argv[k]));
  }
  if (counts.empty()) counts = {10000, 100000, 1000000};
  fmt::print("{:>10} {:>8} {:>14} {:>14} {:>10} {:>12} {:>14}\n", "parcels", "threads", "ns/step/parcel",
             "Msteps/s", "contacts", "rebuild/step", "bytes/parcel");
  for (const std::size_t count : counts) {
    // A bed as high as it is wide keeps the share of surface alike at every size.
    const double spacing = 0.00252, radius = 0.00125;
    const double width = spacing * std::round(std::cbrt(static_cast<double>(count)));
    scenes::LawParts parts;
    if (jkr) parts.normal = "jkr";
    scenes::Stuff stuff;
    stuff.work_of_adhesion = jkr ? 0.1 : 0.0;
    Model model = scenes::yardstick_model(parts, width, 1.2 * width + 0.02);
    model.classes = ContactClasses(1);
    model.classes.set(0, 0, scenes::contact_class(scenes::material_pair(stuff, stuff), parts));
    Simulation simulation(model, scenes::state_of(model, scenes::loose_lattice(count, width, spacing, radius, 2500.0)),
                          threads);
    const int settle = 3000, measure = count > 300000 ? 200 : 1000;
    for (int k = 0; k < settle; ++k) simulation.step();
    const auto rebuilds = simulation.rebuilds();
    const double start = now();
    for (int k = 0; k < measure; ++k) simulation.step();
    const double seconds = now() - start;
    const double per = seconds / measure / static_cast<double>(count);
    std::size_t touching = 0;
    for (const auto t : simulation.pairs().touching) touching += t;
    fmt::print("{:>10} {:>8} {:>14.1f} {:>14.2f} {:>10.2f} {:>12.3f} {:>14.0f}\n", count, threads, per * 1e9, 1e-6 / per,
               static_cast<double>(touching) / static_cast<double>(count),
               static_cast<double>(simulation.rebuilds() - rebuilds) / measure,
               static_cast<double>(simulation.memory()) / static_cast<double>(count));
  }
  return 0;
}
