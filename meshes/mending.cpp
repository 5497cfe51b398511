// SPDX-License-Identifier: Apache-2.0
#include "meshes/mending.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/failure.hpp"
#include "meshes/chain_table.hpp"
#include "meshes/edges.hpp"
#include "meshes/orientation.hpp"
#include "meshes/slivers.hpp"
#include "meshes/welding.hpp"

namespace pulvis {
namespace {

constexpr std::uint32_t none = ChainTable::none;

double weld_distance_of(const Bounds& bounds, const MendingChoices& choices) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, std::fabs(bounds.min[axis]), std::fabs(bounds.max[axis])});
  const double chosen =
      choices.weld_distance.value_or(std::max(1e-6 * norm(bounds.size()), 0x1p-22 * largest));
  // Doubles do not tell less apart, and the grid that finds close points counts in it.
  return chosen > 1e-15 * largest ? chosen : 0.0;
}

std::vector<std::array<Vec3, 3>> in_metres(const TriangleSoup& soup, double metres_per_unit) {
  if (!(metres_per_unit > 0.0) || !std::isfinite(metres_per_unit))
    throw Failure(Exit::bad_input, fmt::format("{}: error: a unit of {:g} m", soup.source, metres_per_unit));
  if (soup.triangles.empty())
    throw Failure(Exit::bad_input, fmt::format("{}: error: there is no triangle in it", soup.source));
  std::vector<std::array<Vec3, 3>> triangles = soup.triangles;
  for (auto& corners : triangles)
    for (Vec3& corner : corners) corner *= metres_per_unit;
  return triangles;
}

std::uint64_t hash_of(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return stirred(stirred(0, corners[0]), std::uint64_t{corners[1]} << 32 | corners[2]);
}

bool same_points(Corners a, Corners b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

// The first of those with the same three points stays, whichever way round they are: a wall has two sides.
void remove_duplicates(std::vector<Corners>& triangles, std::vector<std::uint32_t>& facets) {
  ChainTable table(triangles.size());
  std::uint32_t kept = 0;
  const auto is_new = [&](const Corners& corners, std::uint64_t hash) {
    for (std::uint32_t k = table.first(hash); k != none; k = table.after(k))
      if (same_points(triangles[k], corners)) return false;
    return true;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint64_t hash = hash_of(triangles[t]);
    if (!is_new(triangles[t], hash)) continue;
    triangles[kept] = triangles[t];
    facets[kept] = facets[t];
    table.add(hash, kept++);
  }
  triangles.resize(kept);
  facets.resize(kept);
}

// A facet may have become several triangles or none.
std::vector<bool> marked(const std::vector<std::uint32_t>& facets, std::size_t count) {
  std::vector<bool> marks(count, false);
  for (const std::uint32_t facet : facets) marks[facet] = true;
  return marks;
}

void mend_slivers(WeldedTriangles& welded, std::size_t facets_read, MeshReport& report) {
  const auto before = welded.facets;
  std::vector<bool> without_area(facets_read, false);
  for (std::size_t t = 0; t < welded.triangles.size(); ++t)
    if (!(area_of(welded.points, welded.triangles[t]) > 0.0)) without_area[welded.facets[t]] = true;
  report.slivers_kept = remove_slivers(welded.points, report.weld_distance, welded.triangles, welded.facets);
  if (welded.facets == before) return;
  const auto after = marked(welded.facets, facets_read);
  for (const std::uint32_t facet : before)
    if (!after[facet]) ++(without_area[facet] ? report.degenerate : report.slivers);
  // Halves of split triangles may have come to lie on others.
  remove_duplicates(welded.triangles, welded.facets);
}

void drop_unused_points(WeldedTriangles& welded) {
  std::vector<std::uint32_t> numbers(welded.points.size(), none);
  std::vector<Vec3> used;
  for (Corners& corners : welded.triangles)
    for (std::uint32_t& point : corners) {
      if (numbers[point] == none) {
        numbers[point] = static_cast<std::uint32_t>(used.size());
        used.push_back(welded.points[point]);
      }
      point = numbers[point];
    }
  welded.points = std::move(used);
}

void add_edge(const TriangleMesh& mesh, const EdgeUse& use, EdgePlaces& places) {
  const Vec3 &a = mesh.points[use.low], &b = mesh.points[use.high];
  if (places.count++ == 0) places.place = 0.5 * (a + b);
  places.length += norm(b - a);
}

std::uint64_t sets_among(AgreementSets& sets, const std::vector<std::uint32_t>& members) {
  return static_cast<std::uint64_t>(std::count_if(members.begin(), members.end(),
                                                  [&](std::uint32_t k) { return sets.find(k).first == k; }));
}

// Shells, holes, and whether each edge is walked as often one way as the other, as on a closed surface.
bool look_at_edges(const TriangleMesh& mesh, std::span<const EdgeUse> uses, MeshReport& report) {
  AgreementSets shells(mesh.triangles.size()), holes(mesh.points.size());
  std::vector<std::uint32_t> all(mesh.triangles.size()), rim;
  bool balanced = true;
  report.shortest_edge = Bounds::infinity;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const EdgeUse& first = edge[0];
    std::size_t upward = 0;
    for (const EdgeUse& use : edge) {
      shells.join(first.triangle, use.triangle);
      upward += runs_upward(mesh.triangles[use.triangle], use);
    }
    balanced &= 2 * upward == edge.size();
    report.shortest_edge =
        std::min(report.shortest_edge, norm(mesh.points[first.high] - mesh.points[first.low]));
    if (edge.size() > 2) add_edge(mesh, first, report.crowded_edges);
    if (edge.size() > 1) return;
    add_edge(mesh, first, report.open_edges);
    holes.join(first.low, first.high);
    rim.insert(rim.end(), {first.low, first.high});
  });
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  std::sort(rim.begin(), rim.end());
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
  report.shells = sets_among(shells, all);
  report.holes = sets_among(holes, rim);
  return balanced;
}

void measure(const TriangleMesh& mesh, std::span<const EdgeUse> uses, MeshReport& report) {
  report.triangles = mesh.triangles.size();
  report.points = mesh.points.size();
  report.bounds = {};
  for (const Vec3& p : mesh.points) report.bounds.include(p);
  const bool balanced = look_at_edges(mesh, uses, report);
  report.watertight = report.open_edges.count == 0;
  double volume = 0.0;
  for (const Corners& corners : mesh.triangles) {
    report.area += area_of(mesh.points, corners);
    volume += signed_volume(mesh.points, report.bounds.centre(), corners);
  }
  if (report.watertight && balanced) report.volume = volume;
}

// Triangles of shared points, with what was mended in the report.
WeldedTriangles join(const TriangleSoup& soup, double metres_per_unit, const MendingChoices& choices,
                     MeshReport& report) {
  const auto triangles = in_metres(soup, metres_per_unit);
  Bounds bounds;
  for (const auto& corners : triangles)
    for (const Vec3& corner : corners) bounds.include(corner);
  report.triangles_read = triangles.size();
  report.weld_distance = weld_distance_of(bounds, choices);
  WeldedTriangles welded = weld(triangles, report.weld_distance);
  report.points_welded = welded.points_moved;
  report.degenerate = welded.degenerate;
  report.slivers = welded.needles;
  const std::size_t with_duplicates = welded.triangles.size();
  remove_duplicates(welded.triangles, welded.facets);
  report.duplicates = with_duplicates - welded.triangles.size();
  mend_slivers(welded, triangles.size(), report);
  drop_unused_points(welded);
  return welded;
}

}  // namespace

MendedMesh mend(const TriangleSoup& soup, double metres_per_unit, const MendingChoices& choices) {
  MendedMesh result;
  MeshReport& report = result.report;
  WeldedTriangles welded = join(soup, metres_per_unit, choices, report);
  if (welded.triangles.empty())
    throw Failure(
        Exit::bad_input,
        fmt::format("{}: error: none of its {} triangles has an area (corners closer together than {:.3g} "
                    "mm are one)\n  export the surface again, or check its unit",
                    soup.source, report.triangles_read, 1e3 * report.weld_distance));
  const auto uses = edge_uses(welded.triangles);
  const Orientation orientation = orient(welded.points, uses, welded.triangles);
  report.turned = orientation.turned;
  report.not_orientable = orientation.conflicts;
  result.mesh = {std::move(welded.points), std::move(welded.triangles)};
  result.facets = std::move(welded.facets);
  for (std::uint32_t& facet : result.facets) ++facet;
  measure(result.mesh, uses, report);
  return result;
}

}  // namespace pulvis
