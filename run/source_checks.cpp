// SPDX-License-Identifier: Apache-2.0
#include "run/source_checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/units.hpp"

namespace pulvis {
namespace {

std::string in_mm(double metres) { return format_quantity(metres, dimension::length); }

/// Largest over smallest diameter.
double breadth(const SizeSampler& sizes) { return sizes.largest() / sizes.smallest(); }

/// Solid fraction above which a pack by random placement fails for sure: 0.35 is reached with equal spheres,
/// 0.45 with lognormal sizes of 1:2 and 0.52 with 1:5, in a box of thirty diameters.
double densest_random_pack(const SizeSampler& sizes) {
  return std::fmin(0.38 + 0.11 * std::log(breadth(sizes)), 0.6);
}

SourceProblem too_thin(const Source& source, const SizeSampler& sizes) {
  return {"region",
          fmt::format("sources.{}.region is {} thin and cannot hold the largest parcel ({})\n  enlarge the "
                      "region or lower coarse_graining",
                      source.name, in_mm(narrowest(source.region)), in_mm(sizes.largest()))};
}

SourceProblem too_full(const Source& source, double parcels, double solid, double most) {
  return {"",
          fmt::format("sources.{} asks for {:.0f} parcels, {:.0f} % of its region; a random pack without "
                      "overlap holds at most about {:.0f} % ({:.0f} parcels)\n  ask for less, enlarge the "
                      "region, or let it rain",
                      source.name, parcels, 100 * solid, 100 * most, parcels * most / solid)};
}

SourceProblem too_fine(const Source& source, const SizeSampler& sizes) {
  return {"sieve_opening",
          fmt::format("sources.{}.sieve_opening is {}, less than the largest parcel ({})\n  widen the "
                      "openings or lower coarse_graining",
                      source.name, in_mm(*source.sieve_opening), in_mm(sizes.largest()))};
}

/// How far a region reaches along a direction, m.
double reach_along(const Region& r, const Vec3& direction) {
  if (r.shape == Region::Shape::box) {
    const int axis = fall_axis(direction);
    return r.max[axis] - r.min[axis];
  }
  const double along = std::fabs(dot(r.axis, direction));
  return along * r.height + 2.0 * std::sqrt(std::fmax(1.0 - along * along, 0.0)) * r.radius;
}

/// Time in which a parcel leaves the region, s.
double time_inside(const SourceModel& rain, const Vec3& gravity) {
  const double speed = norm(rain.velocity);
  const Vec3 fall = speed > 0.0 ? rain.velocity : gravity;
  if (norm(fall) == 0.0) return HUGE_VAL;
  const Vec3 direction = fall / norm(fall);
  const double way = reach_along(rain.region, direction), acceleration = dot(gravity, direction);
  return 2.0 * way / (speed + std::sqrt(std::fmax(speed * speed + 2.0 * acceleration * way, 0.0)));
}

}  // namespace

std::vector<SourceProblem> source_problems(const Source& source, const SourceModel& model,
                                           double expected_parcels) {
  std::vector<SourceProblem> problems;
  const SizeSampler& sizes = *model.sizes;
  if (narrowest(source.region) < sizes.largest()) problems.push_back(too_thin(source, sizes));
  if (source.sieve_opening && *source.sieve_opening < sizes.largest() * (1.0 - 1e-12))
    problems.push_back(too_fine(source, sizes));
  if (source.kind != Source::Kind::pack) return problems;
  const double solid = expected_parcels * sphere_volume(0.5) * sizes.mean_cube() / volume(source.region);
  const double most = densest_random_pack(sizes);
  if (solid > most) problems.push_back(too_full(source, expected_parcels, solid, most));
  return problems;
}

double highest_rain_rate(const SourceModel& rain, const Vec3& gravity) {
  // Measured with rains of which far too much was asked: regions of 1 to 30 parcels height, speeds from 0 to
  // 1 m/s, openings from 1 to 3 parcels. Large parcels that wait for a gap hold up the small ones behind.
  const double solid = (rain.sieve ? 0.17 : 0.25) / (1.0 + 0.25 * std::log(breadth(*rain.sizes)));
  const double open = rain.sieve ? square(rain.sieve->opening / rain.sieve->pitch) : 1.0;
  return solid * open * rain.density * volume(rain.region) / time_inside(rain, gravity);
}

std::string rain_warning(const SourceModel& rain, const Vec3& gravity) {
  const double highest = highest_rain_rate(rain, gravity);
  if (rain.kind != SourceModel::Kind::rain || rain.rate <= highest) return "";
  return fmt::format(
      "sources.{}: parcels leave its region too slowly for {}; above about {} it waits for room and falls "
      "behind: lower mass_rate, raise the velocity, or widen the region{}",
      rain.name, format_quantity(rain.rate, dimension::mass_rate),
      format_quantity(highest, dimension::mass_rate), rain.sieve ? " or the openings" : "");
}

}  // namespace pulvis
