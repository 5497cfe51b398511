// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/failure.hpp"
#include "engine/insertion/packing.hpp"

namespace pulvis {
namespace {

/// All diameters of a pack, by number; no more than fill the region without gaps, which cannot be placed.
std::vector<double> draw_sizes(const SourceModel& m, SourceState& state, const Dice& dice) {
  std::vector<double> diameters;
  const double most = m.density * volume(m.region), before = state.mass;
  while (const double diameter = next_diameter(m, state, dice)) {
    diameters.push_back(diameter);
    ++state.count;
    state.mass += mass_of(m, diameter);
    if (state.mass - before > most) break;
  }
  return diameters;
}

/// m^3 of the parcels present whose centres lie in the box around the region.
double solid_present(const Places& places, const Parcels& present) {
  double sum = 0.0;
  for (const Parcel& p : present.body) {
    bool in = true;
    for (int axis = 0; axis < 3; ++axis)
      in = in && p.position[axis] > places.low()[axis] && p.position[axis] < places.high()[axis];
    if (in) sum += sphere_volume(p.radius);
  }
  return sum;
}

std::string number_and_mass(double count, double mass) {
  return fmt::format("{:.0f} parcels ({:.4g} kg)", count, mass);
}

/// How full the region is, and what would fit of the same sizes: the large ones were placed first, so that
/// a pack of as much volume fits all the better.
[[noreturn]] void too_full(const SourceModel& m, const Packing& packing, const std::vector<double>& diameters,
                           const Parcels& present) {
  constexpr double spare = 0.95;  // so that what is advised finds places quickly
  double drawn = 0.0;
  for (const double d : diameters) drawn += sphere_volume(0.5 * d);
  const double mean = drawn / static_cast<double>(diameters.size());
  const double asked_count =
      m.target_count ? static_cast<double>(*m.target_count) : *m.target_mass / (mean * m.density);
  const double count = std::floor(spare * packing.solid() / mean);
  const double there = solid_present(packing.places(), present) / volume(m.region);
  const std::string beside =
      there > 0.0 ? fmt::format(", beside {:.1f} % that were there before", 100.0 * there) : "";
  throw Failure(
      Exit::bad_case,
      fmt::format(
          "source {}: the region is too full: {} parcels fill {:.1f} % of it{} and the next finds no "
          "place in {} attempts\n  {} are asked for; ask for at most about {}, make the region {:.2g} "
          "times as large, or let it rain",
          m.name, packing.placed(), 100.0 * packing.solid() / volume(m.region), beside, Packing::hopeless,
          number_and_mass(asked_count, asked_count * mean * m.density),
          number_and_mass(count, count * mean * m.density), asked_count / std::max(count, 1.0)));
}

}  // namespace

std::vector<Parcel> draw_pack(const SourceModel& m, SourceState& state, const Dice& dice,
                              const Surroundings& around) {
  SourceState after = state;
  const std::vector<double> diameters = draw_sizes(m, after, dice);
  Packing packing(m, dice, around, state.count, diameters);
  if (!packing.place_all()) too_full(m, packing, diameters, around.present);
  std::vector<Parcel> parcels;
  parcels.reserve(diameters.size());
  for (std::size_t k = 0; k < diameters.size(); ++k)
    parcels.push_back(parcel_at(m, packing.centre(k), diameters[k]));
  state = after;
  state.done = true;
  return parcels;
}

}  // namespace pulvis
