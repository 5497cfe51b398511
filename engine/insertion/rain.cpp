// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/insertion/drawing.hpp"

namespace pulvis {
namespace {

constexpr std::uint32_t attempts = 1000;  // per parcel and look; what finds no place waits for the next

/// A place for the next parcel in this look, if it finds one.
std::optional<Vec3> find_place(const Places& places, const Dice& dice, std::uint64_t number, double radius,
                               std::uint32_t first_draw, const OverlapGrid& grid, const ClearOfWalls& clear) {
  for (std::uint32_t k = 0; k < attempts; ++k) {
    const auto centre = places.at(radius, dice(number, first_draw + k));
    if (centre && !grid.overlaps(*centre, radius) && clear(*centre, radius)) return centre;
  }
  return std::nullopt;
}

}  // namespace

std::uint64_t rain_interval(const SourceModel& m, double dt) {
  // The time in which a parcel makes room for the next: one diameter's way.
  const double diameter = m.sizes->largest();
  const double speed = greatest(norm(m.velocity), root(9.81 * diameter));
  return static_cast<std::uint64_t>(std::clamp(diameter / (speed * dt), 1.0, 1e6));
}

bool rain_looks_at(const SourceModel& m, const SourceState& state, std::uint64_t step, double dt) {
  return (step - state.opened) % rain_interval(m, dt) == 0;
}

std::vector<Parcel> draw_rain(const SourceModel& m, SourceState& state, const Dice& dice, std::uint64_t step,
                              double dt, const Surroundings& around) {
  if (!rain_looks_at(m, state, step, dt)) return {};
  const std::uint64_t interval = rain_interval(m, dt), since = step - state.opened;
  const double due = state.mass_at_opening + m.rate * static_cast<double>(since + interval) * dt;
  double diameter = next_diameter(m, state, dice);
  std::vector<Parcel> placed;
  const auto is_due = [&] { return diameter > 0.0 && state.mass + 0.5 * mass_of(m, diameter) <= due; };
  if (is_due()) {
    const Places places(m);
    OverlapGrid grid = grid_of_present(m, places, around, 0);
    // Every look draws from a place of its own in the sequence, so that a parcel that found no room is not
    // offered the same places again; after four million looks the sequence begins anew.
    const auto first_draw = static_cast<std::uint32_t>(1 + attempts * (since / interval));
    for (; is_due(); diameter = next_diameter(m, state, dice)) {
      const double radius = 0.5 * diameter;
      const auto centre = find_place(places, dice, state.count, radius, first_draw, grid, around.clear);
      if (!centre) break;
      grid.add(*centre, radius);
      placed.push_back(parcel_at(m, *centre, diameter));
      ++state.count;
      state.mass += placed.back().mass;
    }
  }
  state.done = diameter == 0.0;
  return placed;
}

}  // namespace pulvis
