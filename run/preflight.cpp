// SPDX-License-Identifier: Apache-2.0
#include "run/preflight.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "case/units.hpp"
#include "engine/simulation/simulation.hpp"
#include "run/body_pull.hpp"
#include "run/build_walls.hpp"
#include "run/pair_law.hpp"
#include "run/pair_numbers.hpp"
#include "run/pair_warnings.hpp"
#include "run/source_checks.hpp"

namespace pulvis {
namespace {

/// Pressure under the expected bed, Pa: its weight over the smallest footprint of a wall that could hold it.
double bed_stress(const Case& c, const Walls& walls, double mass) {
  const Vec3 pull = strongest_pull(c);
  const auto footprint = [&](const Vec3& e) {
    const double x = std::abs(pull.x), y = std::abs(pull.y), z = std::abs(pull.z);
    return x > y && x > z ? e.y * e.z : y > z ? e.x * e.z : e.x * e.y;
  };
  double area = 1e300;
  for (std::size_t w = 0; w < c.walls.size(); ++w) {
    const Wall& wall = c.walls[w];
    Vec3 low, high;
    if (wall.shape == Wall::Shape::cylinder)
      area = std::min(area, pi * square(wall.region.radius));
    else if ((wall.has_inside() || wall.shape == Wall::Shape::mesh) && bounds_of_wall(walls, w, low, high))
      area = std::min(area, footprint(high - low));
  }
  if (!(area > 0.0 && area < 1e299)) area = footprint(c.domain.max - c.domain.min);
  return mass * norm(pull) / area;
}

PairForecast forecast_pair(const Case& c, const Assembly& a, const PairProperties& p, double stress) {
  const double speed = a.time_step.characteristic_speed;
  const PairNumbers grain = pair_numbers(c, a.species, p, Scale::grain, stress, speed),
                    parcel = pair_numbers(c, a.species, p, Scale::parcel, stress, speed);
  PairForecast f;
  f.first = a.species[p.first].name;
  f.second = a.species[p.second].name;
  f.pull_off_real = grain.adhesion.pull_off;
  f.pull_off = parcel.adhesion.pull_off;
  f.bond_real = grain.bond();
  f.bond = parcel.bond();
  f.sticking_speed_real = grain.undamped_sticking.highest;
  f.sticking_speed = parcel.undamped_sticking.highest;
  f.coheres = cohesion_strength(c.contact, p.simulated) > 0.0;
  f.holds = parcel.adhesion.holds;
  // What a law that yields keeps of an overlap is its dent, not softness.
  if (!parcel.contact.remembers()) f.own_overlap = parcel.adhesion.zero_force_overlap / parcel.radius;
  f.resting_overlap = parcel.contact.overlap_under(parcel.load).value_or(parcel.radius) / parcel.radius;
  const single_contact::Collision shown = single_contact::collide(parcel.contact, speed),
                                  undamped = single_contact::collide(parcel.contact.undamped(), speed);
  f.impact_overlap = undamped.largest_overlap / parcel.radius;
  f.restitution = parcel.restitution;
  f.restitution_shown = shown.restitution;
  f.restitution_in_steps =
      single_contact::collide(parcel.contact, a.time_step.characteristic_speed, a.time_step.step).restitution;
  f.undamped_restitution = undamped.restitution;
  return f;
}

/// Bytes of this machine's memory, 0 where the system does not say.
double physical_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
  return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : 0.0;
}

void add_warnings(const Case& c, const Assembly& a, Forecast& f) {
  if (const double there = physical_memory(); there > 0.0 && f.memory > there)
    f.warnings.push_back(
        fmt::format("{:.0f} parcels need about {:.0f} MB of memory; this machine has {:.0f} MB: raise "
                    "coarse_graining",
                    f.parcels, std::ceil(f.memory / 1e6), std::floor(there / 1e6)));
  for (const SourceModel& source : a.model.sources)
    if (const std::string warning = rain_warning(source, strongest_pull(c)); !warning.empty())
      f.warnings.push_back(warning);
  for (const std::string& warning : pair_warnings(c, a, f.pairs)) f.warnings.push_back(warning);
}

std::string force_text(double newton) { return newton > 0 ? format_quantity(newton, dimension::force) : "-"; }
std::string speed_text(double speed) {
  if (std::isinf(speed)) return "any";
  return speed > 0 ? format_quantity(speed, dimension::speed) : "-";
}
std::string number_text(double value) { return value > 0 ? fmt::format("{:.4g}", value) : "-"; }

/// Half the way of a motion that swings to and fro, m, and its direction.
std::optional<std::pair<double, Vec3>> swing_of(const motions::Motion& motion) {
  if (const auto* sine = std::get_if<motions::Sine>(&motion.kind))
    return std::pair{sine->wave.amplitude, sine->direction};
  if (const auto* wave = std::get_if<motions::SquareWave>(&motion.kind))
    return std::pair{wave->amplitude, wave->direction};
  return {};
}

std::string powder_lines(const Case& c) {
  std::string text;
  for (const Powder& p : c.powders) {
    const SizeSampler grains(grain_sizes(p)), parcels(parcel_sizes(p));
    const Material& m = c.materials[p.material];
    text += fmt::format(
        "powder {}: {}, grain d50 {}, coarse graining {:g} (similarity: {}), parcel d50 {} ({} to {})\n",
        p.name, m.name, format_quantity(grains.median_by_mass(), dimension::length), p.coarse_graining,
        c.contact.similarity, format_quantity(parcels.median_by_mass(), dimension::length),
        format_quantity(parcels.smallest(), dimension::length),
        format_quantity(parcels.largest(), dimension::length));
    if (p.simulated_modulus)
      text += fmt::format("  softened from {} to {}, keeping the {}\n",
                          format_quantity(m.young_modulus, dimension::pressure),
                          format_quantity(*p.simulated_modulus, dimension::pressure),
                          p.keep == Powder::Keep::pull_off ? "pull-off force" : "sticking speed");
  }
  return text;
}

}  // namespace

std::string motion_line(const Motion& motion) {
  const motions::Peaks peaks = motions::peaks(motion.motion);
  std::string text = fmt::format("motion {}:", motion.name);
  if (const auto swing = swing_of(motion.motion)) {
    const auto& [amplitude, direction] = *swing;
    text += fmt::format(" amplitude {} along ({:.3g}, {:.3g}, {:.3g}),",
                        format_quantity(amplitude, dimension::length), direction.x, direction.y, direction.z);
  }
  if (const auto period = motions::cycle(motion.motion))
    text += fmt::format(" {},", format_quantity(1.0 / *period, dimension::frequency));
  if (peaks.speed > 0.0)
    text += fmt::format(
        " peak speed {}, peak acceleration {} ({:.3g} g)", format_quantity(peaks.speed, dimension::speed),
        format_quantity(peaks.acceleration, dimension::acceleration), peaks.acceleration / 9.80665);
  if (peaks.rate > 0.0)
    text += fmt::format(" peak rate {:.4g} rad/s, peak angular acceleration {:.4g} rad/s^2", peaks.rate,
                        peaks.angular_acceleration);
  if (const auto end = motions::duration(motion.motion))
    text += fmt::format(", at rest after {}", format_quantity(*end, dimension::time));
  return text;
}

Forecast forecast(const Case& c, const Assembly& a) {
  Forecast f;
  double mass = 0.0;
  for (std::size_t k = 0; k < c.sources.size(); ++k) {
    const Source& source = c.sources[k];
    if (source.kind == Source::Kind::file) {
      f.parcels += static_cast<double>(a.model.sources[k].list.size());
      for (const Parcel& p : a.model.sources[k].list) mass += p.mass;
      continue;
    }
    const double parcels = expected_parcels(c, source);
    f.parcels += parcels;
    const Powder& powder = c.powders[source.powder];
    mass += source.target.mass.value_or(parcels * c.materials[powder.material].density * sphere_volume(0.5) *
                                        SizeSampler(parcel_sizes(powder)).mean_cube());
  }
  f.memory = f.parcels * Simulation::peak_bytes_per_parcel;
  f.bed_stress = bed_stress(c, a.model.walls, mass);
  for (const PairProperties& p : a.pairs) f.pairs.push_back(forecast_pair(c, a, p, f.bed_stress));
  f.graining = graining(c, a, f.parcels, f.bed_stress);
  add_warnings(c, a, f);
  f.warnings.insert(f.warnings.end(), f.graining.warnings.begin(), f.graining.warnings.end());
  f.warnings.insert(f.warnings.end(), a.warnings.begin(), a.warnings.end());
  return f;
}

std::string check_report(const Case& c, const Assembly& a, const Forecast& f) {
  std::string text = fmt::format("{}{}\n", c.file, c.title.empty() ? "" : ": " + c.title) + powder_lines(c);
  const StepLimit& binding = a.time_step.limits.front();
  text += fmt::format("time step {}: {:.3g} of the smallest limit, {} of {} ({})\n",
                      format_quantity(a.time_step.step, dimension::time), a.time_step.step / binding.time,
                      binding.kind, binding.of, format_quantity(binding.time, dimension::time));
  for (const StepLimit& l : a.time_step.limits)
    text += fmt::format("  {:<20} {:<40} {}\n", l.kind, l.of, format_quantity(l.time, dimension::time));
  text += fmt::format("characteristic speed {}\n",
                      format_quantity(a.time_step.characteristic_speed, dimension::speed));
  text += fmt::format("parcels {:.0f}, memory about {:.0f} MB, pressure under the bed about {}\n", f.parcels,
                      std::ceil(f.memory / 1e6), format_quantity(f.bed_stress, dimension::pressure));
  for (const std::string& note : a.notes) text += note + "\n";
  for (const Motion& motion : c.motions) text += motion_line(motion) + "\n";
  text += fmt::format("\n{:<34} {:>12} {:>12} {:>10} {:>10} {:>12} {:>12} {:>9} {:>9} {:>15}\n", "pair (d50)",
                      "pull-off", "pull-off", "Bond", "Bond", "sticking", "sticking", "overlap", "overlap",
                      "restitution");
  text += fmt::format("{:<34} {:>12} {:>12} {:>10} {:>10} {:>12} {:>12} {:>9} {:>9} {:>15}\n", "",
                      "real grain", "simulated", "real", "simulated", "speed real", "simulated", "at rest",
                      "impact", "asked / shown");
  for (const PairForecast& p : f.pairs)
    text += fmt::format("{:<34} {:>12} {:>12} {:>10} {:>10} {:>12} {:>12} {:>8.3f}% {:>8.2f}% {:>15}\n",
                        p.first + " / " + p.second, force_text(p.pull_off_real), force_text(p.pull_off),
                        number_text(p.bond_real), number_text(p.bond), speed_text(p.sticking_speed_real),
                        speed_text(p.sticking_speed), 100 * p.resting_overlap, 100 * p.impact_overlap,
                        fmt::format("{:.3g} / {:.3g}", p.restitution, p.restitution_shown));
  text +=
      "(Bond: pull-off force over the weight of the d50 sphere; sticking speed without damping; overlaps "
      "over the "
      "radius;\nrestitution of parcels at the characteristic speed. More of it: pulvis law)\n";
  return text + graining_text(c, f.graining);
}

}  // namespace pulvis
