// SPDX-License-Identifier: Apache-2.0
#include "engine/insertion/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/base/failure.hpp"
#include "engine/base/parallel.hpp"
#include "engine/insertion/drawing.hpp"

namespace pulvis {

double mass_of(const SourceModel& m, double diameter) { return m.density * sphere_volume(0.5 * diameter); }

double next_diameter(const SourceModel& m, const SourceState& state, const Dice& dice) {
  if (m.target_count && state.count >= *m.target_count) return 0.0;
  const double drawn = m.sizes->diameter(dice.seed, dice.stream, state.count);
  if (!m.target_mass) return drawn;
  const double remaining = *m.target_mass - state.mass, half_smallest = 0.5 * mass_of(m, m.sizes->smallest());
  if (remaining < half_smallest) return 0.0;
  constexpr std::uint32_t redraws = 64, other_streams = 0x10000;
  double diameter = drawn;
  for (std::uint32_t k = 1; k <= redraws; ++k) {
    if (mass_of(m, diameter) <= remaining + half_smallest) return diameter;
    diameter = m.sizes->diameter(dice.seed, dice.stream + k * other_streams, state.count);
  }
  return m.sizes->smallest();
}

Parcel parcel_at(const SourceModel& m, const Vec3& centre, double diameter) {
  Parcel p;
  p.position = centre;
  p.radius = 0.5 * diameter;
  p.velocity = m.velocity;
  p.mass = mass_of(m, diameter);
  p.species = m.species;
  return p;
}

namespace {

/// Whether a sphere, or one of its images across periodic boundaries, reaches into [low, high].
bool reaches_into(const Parcel& p, const Vec3& low, const Vec3& high, const Box& domain) {
  for (int axis = 0; axis < 3; ++axis) {
    const double x = p.position[axis], from = low[axis] - p.radius, to = high[axis] + p.radius;
    const double length = domain.periodic[axis] ? domain.max[axis] - domain.min[axis] : 0.0;
    const auto in = [&](double shifted) { return shifted > from && shifted < to; };
    if (!in(x) && !in(x + length) && !in(x - length)) return false;
  }
  return true;
}

/// Indices of the parcels that reach into the region: of a million in a die, the few below a rain.
std::vector<std::uint32_t> reaching_into(const Places& places, const Surroundings& around) {
  constexpr std::size_t worth_a_thread = 100000;  // a tenth of a millisecond
  const int threads = std::min(around.threads, static_cast<int>(1 + around.present.size() / worth_a_thread));
  std::vector<std::vector<std::uint32_t>> found(static_cast<std::size_t>(threads));
  parallel_shares(around.present.size(), threads, [&](std::size_t begin, std::size_t end, int thread) {
    for (std::size_t i = begin; i < end; ++i)
      if (reaches_into(around.present.body[i], places.low(), places.high(), around.domain))
        found[static_cast<std::size_t>(thread)].push_back(static_cast<std::uint32_t>(i));
  });
  for (std::size_t t = 1; t < found.size(); ++t)
    found[0].insert(found[0].end(), found[t].begin(), found[t].end());
  return std::move(found[0]);
}

}  // namespace

OverlapGrid grid_of_present(const SourceModel& m, const Places& places, const Surroundings& around,
                            std::size_t fresh) {
  const std::vector<std::uint32_t> near = reaching_into(places, around);
  double largest = 0.5 * m.sizes->largest();
  for (const std::uint32_t i : near) largest = greatest(largest, around.present.body[i].radius);
  OverlapGrid grid(places.low(), places.high(), largest, around.domain, near.size() + fresh);
  for (const std::uint32_t i : near) grid.add(around.present.body[i].position, around.present.body[i].radius);
  return grid;
}

namespace {

/// A region must have room for the largest parcel, whole.
void require_room(const SourceModel& m) {
  const double room = narrowest(m.region);
  const double largest = m.sizes->largest();
  if (largest > room * (1.0 + 1e-12))
    throw Failure(Exit::bad_case,
                  fmt::format("source {}: its region is {:.4g} m wide where it is narrowest, less "
                              "than the largest parcel, {:.4g} m\n  enlarge the region",
                              m.name, room, largest));
  if (m.sieve && (m.sieve->opening < largest * (1.0 - 1e-12) || m.sieve->pitch < m.sieve->opening))
    throw Failure(Exit::bad_case,
                  fmt::format("source {}: its sieve has openings of {:.4g} m every {:.4g} m; the largest "
                              "parcel is {:.4g} m\n  make openings at least as wide as the largest parcel, "
                              "and no wider than their pitch",
                              m.name, m.sieve->opening, m.sieve->pitch, largest));
}

}  // namespace

std::vector<Parcel> draw_parcels(const SourceModel& model, SourceState& state, std::uint64_t seed,
                                 std::uint32_t stream, std::uint64_t step, double dt, const Parcels& present,
                                 const Box& domain, const ClearOfWalls& clear, int threads) {
  if (model.kind == SourceModel::Kind::list) {
    state.done = true;
    state.count = model.list.size();
    for (const Parcel& p : model.list) state.mass += p.mass;
    return model.list;
  }
  const Dice dice{seed, stream};
  const Surroundings around{present, domain, clear, threads < 1 ? 1 : threads};
  if (model.kind == SourceModel::Kind::dense) return draw_dense(model, state, dice, around);
  require_room(model);
  if (model.kind == SourceModel::Kind::pack) return draw_pack(model, state, dice, around);
  return draw_rain(model, state, dice, step, dt, around);
}

bool is_due(const SourceModel& model, const SourceState& state, std::uint64_t step, double dt) {
  if (!state.open || state.done) return false;
  return model.kind != SourceModel::Kind::rain || rain_looks_at(model, state, step, dt);
}

}  // namespace pulvis
