// SPDX-License-Identifier: Apache-2.0
// What getting powder in costs: insert_time [--threads N] [COUNT...]
// For each count: seconds of a pack of 30 % solids, of equal and of lognormal spheres (largest five times the
// smallest), and microseconds of one look of a rain while that many parcels are present.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "engine/insertion/source.hpp"

namespace {

using namespace pulvis;

constexpr double solids = 0.3, dt = 1e-6;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

SourceModel source(bool wide) {
  SourceModel m;
  m.name = "bench";
  m.density = 2500.0;
  SizeLaw law;
  law.kind = wide ? SizeKind::lognormal : SizeKind::single;
  law.diameter = 1e-3;
  law.geometric_deviation = 1.5;
  law.smallest = wide ? 0.45e-3 : 1e-3;
  law.largest = wide ? 2.25e-3 : 1e-3;
  m.sizes.emplace(law);
  return m;
}

/// Seconds of a pack in a cube; `pack` is what lies there afterwards.
double time_pack(bool wide, std::size_t count, int threads, Parcels& pack) {
  SourceModel m = source(wide);
  const double edge =
      std::cbrt(static_cast<double>(count) * sphere_volume(0.5) * m.sizes->mean_cube() / solids);
  m.region.max = {edge, edge, edge};
  m.target_count = count;
  Box domain;
  domain.max = {edge, edge, 1.1 * edge};
  SourceState state;
  const double start = now();
  pack.body = draw_parcels(m, state, 1, 0, 0, dt, {}, domain, nothing_in_the_way, threads);
  return now() - start;
}

/// Seconds of one look of a rain that falls from above onto what is present.
double time_look(const Parcels& present, int threads) {
  double top = 0.0;
  for (const Parcel& p : present.body) top = std::fmax(top, p.position.z + p.radius);
  SourceModel m = source(false);
  m.kind = SourceModel::Kind::rain;
  m.region.min = {0, 0, top};
  m.region.max = {0.02, 0.02, top + 5e-3};
  m.velocity = {0, 0, -0.5};
  m.target_mass = 1.0;
  m.rate = 10.0 * m.density * sphere_volume(0.5e-3) / (static_cast<double>(rain_interval(m, dt)) * dt);
  Box domain;
  domain.max = {top, top, 2 * top};
  constexpr std::uint64_t looks = 20;
  double spent = 0.0;
  SourceState state;
  for (std::uint64_t k = 0; k < looks; ++k) {
    const double start = now();
    draw_parcels(m, state, 1, 0, k * rain_interval(m, dt), dt, present, domain, nothing_in_the_way, threads);
    spent += now() - start;
  }
  return spent / static_cast<double>(looks);
}

}  // namespace

int main(int argc, char** argv) {
  int threads = 1;
  std::vector<std::size_t> counts;
  for (int k = 1; k < argc; ++k) {
    if (!std::strcmp(argv[k], "--threads") && k + 1 < argc)
      threads = std::stoi(argv[++k]);
    else
      counts.push_back(std::stoul(argv[k]));
  }
  if (counts.empty()) counts = {10000, 100000, 1000000};
  fmt::print("{:>10} {:>8} {:>14} {:>14} {:>16}\n", "parcels", "threads", "equal, s", "lognormal, s",
             "look of rain, us");
  for (const std::size_t count : counts) {
    Parcels pack;
    const double wide = time_pack(true, count, threads, pack);
    const double equal = time_pack(false, count, threads, pack);
    fmt::print("{:>10} {:>8} {:>14.3f} {:>14.3f} {:>16.1f}\n", count, threads, equal, wide,
               1e6 * time_look(pack, threads));
  }
  return 0;
}
