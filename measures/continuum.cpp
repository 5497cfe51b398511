// SPDX-License-Identifier: Apache-2.0
#include "measures/continuum.hpp"

#include <cmath>

#include "measures/lucy_kernel.hpp"
#include "measures/near_points.hpp"
#include "measures/parallel.hpp"

namespace pulvis::measures {
namespace {

/// A straight line that carries a force: f (x) branch is what it adds to the stress.
struct ForceLine {
  Vec3 from{}, to{};
  Tensor moment{};  // N m
};

std::vector<ForceLine> force_lines(std::span<const Particle> parcels, std::span<const PairForce> pairs,
                                   std::span<const WallForce> walls) {
  std::vector<ForceLine> lines;
  lines.reserve(pairs.size() + walls.size());
  const auto add = [&](std::uint32_t parcel, const Vec3& force, const Vec3& branch) {
    const Vec3& centre = parcels[parcel].position;
    lines.push_back({centre, centre - branch, outer(force, branch)});
  };
  for (const PairForce& pair : pairs) add(pair.first, pair.force, pair.branch);
  for (const WallForce& wall : walls) add(wall.parcel, wall.force, wall.branch);
  return lines;
}

/// What moves near a point: density, velocity and kinetic stress there.
void add_motion(ContinuumFields& fields, std::size_t place, const Vec3& point,
                std::span<const Particle> parcels, const NearPoints& grid, const LucyKernel& kernel) {
  struct Weighted {
    std::uint32_t parcel;
    double mass;  // kg/m^3; its share of the density
  };
  std::vector<Weighted> near;
  double density = 0.0;
  Vec3 momentum;
  grid.near(point, [&](std::uint32_t i) {
    const Vec3 apart = point - parcels[i].position;
    const double weight = kernel.at(dot(apart, apart));
    if (weight == 0.0) return;
    near.push_back({i, parcels[i].mass * weight});
    density += near.back().mass;
    momentum += near.back().mass * parcels[i].velocity;
  });
  if (!(density > 0.0)) return;
  fields.density[place] = density;
  fields.velocity[place] = momentum / density;
  for (const Weighted& w : near) {
    const Vec3 about = parcels[w.parcel].velocity - fields.velocity[place];
    fields.kinetic_stress[place] += w.mass * outer(about, about);
  }
}

}  // namespace

ContinuumFields continuum_fields(std::span<const Vec3> points, std::span<const Particle> parcels,
                                 std::span<const PairForce> pairs, std::span<const WallForce> walls,
                                 double support) {
  check_forces(pairs, walls, parcels.size());
  const LucyKernel kernel(support);
  std::vector<Vec3> centres;
  centres.reserve(parcels.size());
  for (const Particle& parcel : parcels) centres.push_back(parcel.position);
  const NearPoints parcel_grid(centres, points, support);

  // Lines are found by their middles: those within c plus half the longest line may reach a point.
  const std::vector<ForceLine> lines = force_lines(parcels, pairs, walls);
  std::vector<Vec3> middles;
  middles.reserve(lines.size());
  double longest = 0.0;  // squared
  for (const ForceLine& line : lines) {
    middles.push_back(0.5 * (line.from + line.to));
    longest = greatest(longest, dot(line.to - line.from, line.to - line.from));
  }
  const double reach = support + 0.5 * std::sqrt(longest);
  const NearPoints line_grid(middles, points, reach);

  ContinuumFields fields;
  fields.density.resize(points.size());
  fields.velocity.resize(points.size());
  fields.contact_stress.resize(points.size());
  fields.kinetic_stress.resize(points.size());
  parallel_for(points.size(), [&](std::size_t place) {
    const Vec3& point = points[place];
    add_motion(fields, place, point, parcels, parcel_grid, kernel);
    line_grid.near(point, [&](std::uint32_t i) {
      const Vec3 apart = point - middles[i];
      if (dot(apart, apart) > reach * reach) return;
      fields.contact_stress[place] += kernel.along(point, lines[i].from, lines[i].to) * lines[i].moment;
    });
  });
  return fields;
}

std::vector<Vec3> grid_points(const Container& container, const std::array<std::size_t, 3>& cells) {
  const DieFrame frame(container);
  std::vector<Vec3> points;
  points.reserve(cells[0] * cells[1] * cells[2]);
  const auto middle = [&](std::size_t i, std::size_t axis) {
    return (static_cast<double>(i) + 0.5) * frame.size()[static_cast<int>(axis)] /
           static_cast<double>(cells[axis]);
  };
  for (std::size_t k = 0; k < cells[2]; ++k)
    for (std::size_t j = 0; j < cells[1]; ++j)
      for (std::size_t i = 0; i < cells[0]; ++i)
        points.push_back(frame.to_container({middle(i, 0), middle(j, 1), middle(k, 2)}));
  return points;
}

}  // namespace pulvis::measures
