// SPDX-License-Identifier: Apache-2.0
#include "yardstick/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>

#include "engine/base/failure.hpp"
#include "engine/kernels/contact_block.hpp"
#include "engine/simulation/simulation.hpp"
#include "output/progress.hpp"
#include "output/result_json.hpp"
#include "validation/scene.hpp"
#include "yardstick/memory.hpp"
#include "yardstick/table.hpp"

namespace pulvis::yardstick {
namespace {

using Json = nlohmann::ordered_json;

constexpr double width_of_largest_tile = 0.04;  // m: a bed of some 35 layers of spheres
constexpr std::size_t largest_tile = 10'000;
constexpr int settling_steps = 30'000, warm_up = 300;
constexpr double particle_steps = 20e6;
constexpr double height = 0.3;  // m

struct LawOfBed {
  const char *name, *title;
  scenes::Stuff stuff{};
  scenes::LawParts parts{};
};

std::vector<LawOfBed> laws_of_beds() {
  std::vector<LawOfBed> list{{"hertz", "Hertz, without cohesion"},
                             {"jkr", "JKR, work of adhesion 0.1 J/m^2"},
                             {"dmt", "Hertz and DMT, work of adhesion 0.1 J/m^2"},
                             {"sjkr", "Hertz and SJKR, 1e4 J/m^3"}};
  list[1].parts.normal = "jkr";
  list[1].stuff.work_of_adhesion = 0.1;
  list[2].parts.cohesion = "dmt";
  list[2].stuff.work_of_adhesion = 0.1;
  list[3].parts.cohesion = "sjkr";
  list[3].stuff.cohesion_energy_density = 1e4;
  return list;
}

LawOfBed law_named(const std::string& name) {
  std::string known;
  for (const LawOfBed& law : laws_of_beds()) {
    if (law.name == name) return law;
    known += fmt::format("\n  {:<6} {}", law.name, law.title);
  }
  throw Failure(Exit::usage, fmt::format("there is no bed with the law \"{}\"; laws are:{}", name, known));
}

void require_room_for(std::size_t parcels) {
  const double needed = static_cast<double>(parcels) * Simulation::peak_bytes_per_parcel,
               there = free_memory();
  if (needed > there)
    throw Failure(Exit::usage,
                  fmt::format("a bed of {} parcels needs about {:.0f} MB of memory, and {:.0f} MB are free: "
                              "ask for --sizes up to {:.0f}",
                              parcels, std::ceil(needed / 1e6), std::floor(there / 1e6),
                              std::floor(there / Simulation::peak_bytes_per_parcel)));
}

/// Seconds: of the processor where one thread works, so that other programs disturb less; else of the clock.
double now(int threads_used) { return threads_used == 1 ? seconds_of_this_thread() : seconds_now(); }

/// How many beds of `tile` parcels lie side by side along each axis for about `size`.
std::uint32_t tiles_for(std::size_t size, std::size_t tile) {
  const double share = static_cast<double>(size) / static_cast<double>(tile);
  return static_cast<std::uint32_t>(std::max(1L, std::lround(std::sqrt(share))));
}

/// Parcels of the bed that all sizes are made of.
std::size_t tile_of(const Request& request) {
  return std::min(*std::min_element(request.sizes.begin(), request.sizes.end()), largest_tile);
}

class Bench {
 public:
  explicit Bench(const Request& request)
      : request_(request), progress_(ProgressOptions::for_stderr()), sizes_(request.sizes) {
    std::sort(sizes_.begin(), sizes_.end());
    tile_ = tile_of(request);
    width_ =
        width_of_largest_tile * std::sqrt(static_cast<double>(tile_) / static_cast<double>(largest_tile));
    write();  // if it cannot be written, that is better known now
  }

  void run() {
    for (const std::string& name : request_.laws) {
      const LawOfBed law = law_named(name);
      const State settled = settle(law);
      for (const std::size_t size : sizes_)
        for (const int threads : request_.threads) time_bed(law, settled, size, threads);
    }
    progress_.finish();
    const double largest = static_cast<double>(rows_.back().parcels);
    fmt::print("Peak memory of the program: {:.0f} MB, {:.0f} bytes per parcel of the largest bed.\n",
               peak_memory() / 1e6, peak_memory() / largest);
  }

 private:
  void show(const std::string& what, double share, std::size_t parcels) {
    progress_.update({.phase = what,
                      .simulated_time = 0.0,
                      .fraction = share,
                      .parcels = parcels,
                      .particle_steps = particle_steps_});
  }

  /// The bed that all sizes are made of, side by side.
  State settle(const LawOfBed& law) {
    const int threads = *std::max_element(request_.threads.begin(), request_.threads.end());
    const std::string what = fmt::format("{}: a bed settles", law.name);
    return scenes::settled_yardstick(law.stuff, law.parts, width_, tile_, settling_steps, threads,
                                     [&](int k) {
                                       particle_steps_ += tile_;
                                       show(what, static_cast<double>(k) / settling_steps, tile_);
                                     });
  }

  void time_bed(const LawOfBed& law, const State& settled, std::size_t size, int threads) {
    const std::uint32_t tiles = tiles_for(size, tile_);
    Model model = scenes::yardstick_model(law.stuff, law.parts, width_ * tiles, height);
    model.energy_ledger = request_.energy;
    Simulation simulation(model, scenes::tiled(settled, width_, tiles), threads);
    Row row;
    row.law = law.name;
    row.parcels = simulation.state().parcels.size();
    row.threads = threads;
    row.threads_used = simulation.threads();
    row.steps = request_.steps > 0 ? request_.steps
                                   : static_cast<int>(std::max(100.0, row.per_parcel(particle_steps)));
    const std::string what = fmt::format("{}: {} parcels, threads: {}", law.name, row.parcels, threads);
    const auto steps = [&](int count, bool told) {
      for (int k = 1; k <= count; ++k) {
        simulation.step(k % request_.look_every == 0 || k == count ? Simulation::Then::look
                                                                   : Simulation::Then::go_on);
        particle_steps_ += row.parcels;
        if (told) show(what, static_cast<double>(k) / count, row.parcels);
      }
    };
    steps(warm_up, true);
    simulation.times().book(Task::rest);
    row.times = simulation.times().seconds();
    row.rebuilds = simulation.rebuilds();
    const double start = now(row.threads_used);
    steps(row.steps, false);
    row.seconds = now(row.threads_used) - start;
    for (std::size_t k = 0; k < row.times.of.size(); ++k)
      row.times.of[k] = simulation.times().seconds().of[k] - row.times.of[k];
    row.rebuilds = simulation.rebuilds() - row.rebuilds;
    for (const auto touching : simulation.pairs().touching) row.contacts += touching;
    row.near_pairs = simulation.pairs().entry.size() / 2;
    row.bytes = simulation.memory();
    add(row);
  }

  void add(const Row& row) {
    progress_.finish();
    if (rows_.empty()) fmt::print("{}", table_head());
    rows_.push_back(row);
    fmt::print("{}", table_line(rows_, row));
    std::fflush(stdout);
    write();
  }

  void write() const {
    if (request_.json.empty()) return;
    write_json(request_.json, {{"version", PULVIS_VERSION},
                               {"instruction_set", kernels::name_of(kernels::instruction_set())},
                               {"energy_ledger", request_.energy},
                               {"look_every", request_.look_every},
                               {"peak_bytes", peak_memory()},
                               {"rows", to_json(rows_)}});
  }

  const Request& request_;
  Progress progress_;
  std::vector<std::size_t> sizes_;
  std::size_t tile_ = 0;
  double width_ = 0.0;
  std::uint64_t particle_steps_ = 0;
  std::vector<Row> rows_;
};

}  // namespace

std::vector<KnownLaw> known_laws() {
  std::vector<KnownLaw> list;
  for (const LawOfBed& law : laws_of_beds()) list.push_back({law.name, law.title});
  return list;
}

double seconds_of_this_thread() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

void bench(const Request& request) {
  for (const std::string& name : request.laws) law_named(name);
  const std::size_t tile = tile_of(request);
  for (const std::size_t size : request.sizes) {
    const std::size_t tiles = tiles_for(size, tile);
    require_room_for(tiles * tiles * tile);
  }
  Bench(request).run();
}

}  // namespace pulvis::yardstick
