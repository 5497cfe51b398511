// SPDX-License-Identifier: Apache-2.0
#include "engine/insertion/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/failure.hpp"
#include "engine/base/random.hpp"
#include "engine/insertion/overlap_grid.hpp"
#include "engine/math/functions.hpp"

namespace pulvis {
namespace {

constexpr std::uint32_t pack_attempts =
    20000;  // per parcel; packs of equal spheres give up near a solid fraction of 0.36
constexpr std::uint32_t rain_attempts = 100;  // per parcel and look; what finds no place waits for the next

/// Random numbers of one parcel of one source.
struct Dice {
  std::uint64_t seed;
  std::uint32_t stream;
  std::uint64_t number;
  double operator()(std::uint32_t draw) const { return uniform(seed, stream, number, draw); }
};

double mass_of(double diameter, double density) { return density * sphere_volume(0.5 * diameter); }

/// Diameter of the next parcel, or 0 if the target is met. A mass is met to within half the smallest parcel:
/// near the end parcels that are too heavy are drawn
/// again, and after many draws the smallest fill the rest.
double next_diameter(const SourceModel& m, const SourceState& state, std::uint64_t seed,
                     std::uint32_t stream) {
  if (m.target_count && state.count >= *m.target_count) return 0.0;
  const double drawn = m.sizes->diameter(seed, stream, state.count);
  if (!m.target_mass) return drawn;
  const double remaining = *m.target_mass - state.mass,
               half_smallest = 0.5 * mass_of(m.sizes->smallest(), m.density);
  if (remaining < half_smallest) return 0.0;
  constexpr std::uint32_t redraws = 64, other_streams = 0x10000;
  double diameter = drawn;
  for (std::uint32_t k = 1; k <= redraws; ++k) {
    if (mass_of(diameter, m.density) <= remaining + half_smallest) return diameter;
    diameter = m.sizes->diameter(seed, stream + k * other_streams, state.count);
  }
  return m.sizes->smallest();
}

/// A centre so that the whole sphere lies in the region. Draws 3 numbers from `first_draw`.
Vec3 place_in(const Region& r, double radius, const Dice& dice, std::uint32_t first_draw) {
  const double a = dice(first_draw), b = dice(first_draw + 1), c = dice(first_draw + 2);
  if (r.shape == Region::Shape::box) {
    const Vec3 room = r.max - r.min - Vec3{2 * radius, 2 * radius, 2 * radius};
    return r.min + Vec3{radius, radius, radius} +
           Vec3{a * greatest(room.x, 0.0), b * greatest(room.y, 0.0), c * greatest(room.z, 0.0)};
  }
  const Vec3 u = perpendicular(r.axis), v = cross(r.axis, u);
  const double distance = greatest(r.radius - radius, 0.0) * root(a);
  const double along = radius + c * greatest(r.height - 2 * radius, 0.0);
  return r.base + along * r.axis + (distance * cosine_of_cycles(b)) * u + (distance * sine_of_cycles(b)) * v;
}

void bounds_of(const Region& r, Vec3& low, Vec3& high) {
  if (r.shape == Region::Shape::box) {
    low = r.min;
    high = r.max;
    return;
  }
  const Vec3 end = r.base + r.height * r.axis;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = least(r.base[axis], end[axis]) - r.radius;
    high[axis] = greatest(r.base[axis], end[axis]) + r.radius;
  }
}

OverlapGrid grid_of_present(const SourceModel& m, const Parcels& present, const Box& domain) {
  Vec3 low, high;
  bounds_of(m.region, low, high);
  double largest = 0.5 * m.sizes->largest();
  for (const Parcel& p : present.body) largest = greatest(largest, p.radius);
  OverlapGrid grid(low, high, largest, domain, present.size() + m.target_count.value_or(0));
  for (const Parcel& p : present.body) grid.add(p.position, p.radius);
  return grid;
}

/// Tries to place one parcel of this diameter; true if it found room.
bool place(const SourceModel& m, SourceState& state, double diameter, const Dice& dice,
           std::uint32_t attempts, std::uint32_t first_draw, const ClearOfWalls& clear, OverlapGrid& grid,
           std::vector<Parcel>& placed) {
  const double radius = 0.5 * diameter;
  for (std::uint32_t k = 0; k < attempts; ++k) {
    const Vec3 centre = place_in(m.region, radius, dice, first_draw + 3 * k);
    if (grid.overlaps(centre, radius) || !clear(centre, radius)) continue;
    grid.add(centre, radius);
    Parcel p;
    p.position = centre;
    p.radius = radius;
    p.velocity = m.velocity;
    p.mass = mass_of(diameter, m.density);
    p.species = m.species;
    placed.push_back(p);
    ++state.count;
    state.mass += p.mass;
    return true;
  }
  return false;
}

std::vector<Parcel> draw_pack(const SourceModel& m, SourceState& state, std::uint64_t seed,
                              std::uint32_t stream, const Parcels& present, const Box& domain,
                              const ClearOfWalls& clear) {
  OverlapGrid grid = grid_of_present(m, present, domain);
  std::vector<Parcel> placed;
  double solid = 0.0;
  while (const double diameter = next_diameter(m, state, seed, stream)) {
    if (!place(m, state, diameter, {seed, stream, state.count}, pack_attempts, 1, clear, grid, placed))
      throw Failure(
          Exit::bad_case,
          fmt::format("source {}: the region is too full: {} parcels fill {:.1f} % of it and the next "
                      "finds no place in {} attempts\n  ask for at most about {} parcels ({:.4g} kg), "
                      "enlarge the region, or let it rain",
                      m.name, state.count, 100.0 * solid / volume(m.region), pack_attempts,
                      static_cast<std::uint64_t>(0.95 * static_cast<double>(state.count)),
                      0.95 * state.mass));
    solid += sphere_volume(placed.back().radius);
  }
  state.done = true;
  return placed;
}

std::vector<Parcel> draw_rain(const SourceModel& m, SourceState& state, std::uint64_t seed,
                              std::uint32_t stream, std::uint64_t step, double dt, const Parcels& present,
                              const Box& domain, const ClearOfWalls& clear) {
  const std::uint64_t interval = rain_interval(m, dt), since = step - state.opened;
  if (since % interval != 0) return {};
  const double due = state.mass_at_opening + m.rate * static_cast<double>(since + interval) * dt;
  double diameter = next_diameter(m, state, seed, stream);
  state.done = diameter == 0.0;
  if (state.done || state.mass + 0.5 * mass_of(diameter, m.density) > due) return {};

  OverlapGrid grid = grid_of_present(m, present, domain);
  std::vector<Parcel> placed;
  // Every look draws from a place of its own in the sequence, so that a parcel that found no room is not
  // offered the same places again. 2^32 draws last for over ten million looks.
  const auto first_draw = static_cast<std::uint32_t>(1 + 3 * rain_attempts * (since / interval));
  while (diameter > 0.0 && state.mass + 0.5 * mass_of(diameter, m.density) <= due) {
    if (!place(m, state, diameter, {seed, stream, state.count}, rain_attempts, first_draw, clear, grid,
               placed))
      break;
    diameter = next_diameter(m, state, seed, stream);
  }
  state.done = diameter == 0.0;
  return placed;
}

/// A region must have room for the largest parcel, whole.
void require_room(const SourceModel& m) {
  const double room = narrowest(m.region);
  const double largest = m.sizes->largest();
  if (largest > room * (1.0 + 1e-12))
    throw Failure(Exit::bad_case,
                  fmt::format("source {}: its region is {:.4g} m wide where it is narrowest, less "
                              "than the largest parcel, {:.4g} m\n  enlarge the region",
                              m.name, room, largest));
}

}  // namespace

std::uint64_t rain_interval(const SourceModel& m, double dt) {
  // The time in which a parcel makes room for the next: one diameter's way.
  const double diameter = m.sizes->largest();
  const double speed = greatest(norm(m.velocity), root(9.81 * diameter));
  return static_cast<std::uint64_t>(std::clamp(diameter / (speed * dt), 1.0, 1e6));
}

std::vector<Parcel> draw_parcels(const SourceModel& model, SourceState& state, std::uint64_t seed,
                                 std::uint32_t stream, std::uint64_t step, double dt, const Parcels& present,
                                 const Box& domain, const ClearOfWalls& clear) {
  if (model.kind != SourceModel::Kind::list) require_room(model);
  switch (model.kind) {
    case SourceModel::Kind::pack:
      return draw_pack(model, state, seed, stream, present, domain, clear);
    case SourceModel::Kind::rain:
      return draw_rain(model, state, seed, stream, step, dt, present, domain, clear);
    case SourceModel::Kind::list:
      break;
  }
  state.done = true;
  state.count = model.list.size();
  for (const Parcel& p : model.list) state.mass += p.mass;
  return model.list;
}

}  // namespace pulvis
