// SPDX-License-Identifier: Apache-2.0
#include "run/wall_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/units.hpp"
#include "engine/base/failure.hpp"
#include "engine/contacts/wall_sight.hpp"
#include "run/species.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t steps_between_samples = 16;
constexpr double tile_diameters = 3.0;

/// The smallest box around each body's bounded surfaces has its middle here.
std::vector<Vec3> middles_of_bodies(const Walls& walls) {
  std::vector<Vec3> middles;
  for (std::uint32_t b = 0; b < walls.bodies.size(); ++b) {
    Vec3 low{1e300, 1e300, 1e300}, high = -low, point;
    for (const Surface& s : walls.surfaces) {
      if (s.body != b) continue;
      if (!include(s, low, high)) point = s.centre;
    }
    for (const FacetedWall& mesh : walls.meshes)
      if (walls.surfaces[mesh.first_surface].body == b) mesh.include(low, high);
    middles.push_back(low.x <= high.x ? 0.5 * (low + high) : point);
  }
  return middles;
}

/// A rotation has cycles too, but they are no shaking.
std::optional<double> period_of_shaking(const motions::Motion& motion) {
  return std::holds_alternative<motions::Rotation>(motion.kind) ? std::nullopt : motions::cycle(motion);
}

void scale(TileLoad& load, double by) {
  load.normal *= by;
  load.shear *= by;
}
void scale(WallLoad& load, double by) {
  load.force *= by;
  load.torque *= by;
}

WallWindow mean_of(const WallWindow& sums) {
  WallWindow mean = sums;
  const double by = sums.samples > 0 ? 1.0 / static_cast<double>(sums.samples) : 0.0;
  for (auto* list : {&mean.walls, &mean.bodies})
    for (WallLoad& load : *list) scale(load, by);
  for (TileLoad& load : mean.tiles) scale(load, by);
  for (auto& mesh : mean.facets)
    for (TileLoad& load : mesh) scale(load, by);
  return mean;
}

}  // namespace

WallLoads::WallLoads(const Case& c, const Simulation& simulation, double default_window)
    : case_(c),
      walls_(simulation.model().walls),
      tiling_(walls_, simulation.model().domain.min, simulation.model().domain.max,
              tile_diameters * SizeSampler(parcel_sizes(c.powders.front())).mean()),
      reference_(middles_of_bodies(walls_)),
      default_window_(default_window) {
  clear(simulation);
}

void WallLoads::clear(const Simulation& simulation) {
  mean_.reset();
  now_.current = {};
  now_.current.start = now_.current.end = simulation.time();
  now_.current.walls.resize(walls_.names.size());
  now_.current.bodies.resize(walls_.bodies.size());
  now_.current.tiles.resize(tiling_.tiles().size());
  for (const FacetedWall& mesh : walls_.meshes)
    now_.current.facets.emplace_back(mesh.mesh().triangles.size());
  now_.steps_in_window = 0;
}

void WallLoads::begin_phase(const Phase& phase, const Simulation& simulation) {
  const double dt = simulation.model().dt;
  double length = case_.measures.wall_window.value_or(default_window_);
  now_.cycles = false;
  if (!phase.motions.empty())
    if (const auto period = period_of_shaking(case_.motions[phase.motions.front()].motion)) {
      // Whole cycles: as many as come closest to the window the case states, at least one.
      const double stated = case_.measures.wall_window.value_or(*period);
      length = std::max(1.0, std::round(stated / *period)) * *period;
      now_.cycles = true;
    }
  now_.steps_per_window = static_cast<std::uint64_t>(std::max(1.0, std::round(length / dt)));
  now_.last = {};
  clear(simulation);
}

void WallLoads::go_on_from(WallRecord record) {
  const auto alike = [&](const WallWindow& w) {
    const WallWindow& own = now_.current;
    return w.walls.size() == own.walls.size() && w.bodies.size() == own.bodies.size() &&
           w.tiles.size() == own.tiles.size() &&
           std::equal(w.facets.begin(), w.facets.end(), own.facets.begin(), own.facets.end(),
                      [](const auto& a, const auto& b) { return a.size() == b.size(); });
  };
  const bool empty = record.last.samples == 0;  // no window has ended in this phase
  if (!alike(record.current) || !(empty || alike(record.last)) ||
      record.steps_in_window >= record.steps_per_window)
    throw Failure(Exit::bad_input, "its record of what walls bear is of other walls");
  mean_.reset();
  now_ = std::move(record);
}

bool WallLoads::samples_after_next_step() const {
  const std::uint64_t next = now_.steps_in_window + 1;
  return next % steps_between_samples == 0 || next == now_.steps_per_window;
}

bool WallLoads::after_step(const Simulation& simulation) {
  const bool samples = samples_after_next_step();
  ++now_.steps_in_window;
  if (samples) sample(simulation);
  if (now_.steps_in_window < now_.steps_per_window) return false;
  now_.last = mean_of(now_.current);
  clear(simulation);
  return true;
}

void WallLoads::sample(const Simulation& simulation) {
  const NearWalls& near = simulation.walls();
  mean_.reset();
  ++now_.current.samples;
  now_.current.end = simulation.time();
  for (const std::uint32_t slot : simulation.wall_slots_by_id()) {
    if (!near.touching[slot]) continue;
    const Surface& surface = walls_.surfaces[near.surface[slot]];
    const Pose& pose = simulation.pose(surface.body);
    const Vec3& centre = simulation.state().parcels.body[near.parcel[slot]].position;
    const Load& load = near.load[slot];
    const Vec3 arm = centre - pose.now(reference_[surface.body]);
    const WallLoad on_wall{-load.force, -(cross(arm, load.force) + load.torque)};
    for (WallLoad* sum : {&now_.current.walls[surface.wall], &now_.current.bodies[surface.body]}) {
      sum->force += on_wall.force;
      sum->torque += on_wall.torque;
    }
    const WallSight sight = look(walls_, near, slot, pose.now.back(centre));
    const Vec3 force = pose.now.turn_back(on_wall.force), outward = sight.offset / sight.distance;
    const double normal = dot(force, outward);
    const auto add = [&](TileLoad& sum) {
      sum.normal += normal;
      sum.shear += force - normal * outward;
    };
    // A plane just outside the domain has no tiles, though parcels inside may touch it.
    const std::uint32_t tile = tiling_.tile_of(near.surface[slot], sight.facet, sight.nearest.point);
    if (tile != measures::WallTiling::no_tile) add(now_.current.tiles[tile]);
    if (surface.kind == Surface::Kind::patch) add(now_.current.facets[surface.mesh][sight.facet]);
  }
}

const WallWindow& WallLoads::current_mean() const {
  if (!mean_) mean_ = mean_of(now_.current);
  return *mean_;
}

std::string WallLoads::window_text() const {
  const WallWindow& w = window();
  if (w.samples == 0) return "instantaneous";
  return fmt::format("mean over {}{}", format_quantity(w.end - w.start, dimension::time),
                     now_.cycles && now_.last.samples > 0 ? ", whole cycles" : "");
}

double WallLoads::pressure(std::size_t tile) const {
  return window().tiles[tile].normal / tiling_.tiles()[tile].area;
}

double WallLoads::largest_pressure(std::uint32_t body) const {
  const WallWindow& w = window();
  double largest = 0.0;
  for (std::size_t t = 0; t < w.tiles.size(); ++t)
    if (walls_.surfaces[tiling_.tiles()[t].surface].body == body)
      largest = std::max(largest, w.tiles[t].normal / tiling_.tiles()[t].area);
  return largest;
}

double WallLoads::mean_pressure(std::uint32_t body) const {
  const WallWindow& w = window();
  double force = 0.0, area = 0.0;
  for (std::size_t t = 0; t < w.tiles.size(); ++t) {
    if (walls_.surfaces[tiling_.tiles()[t].surface].body != body || w.tiles[t].normal == 0.0) continue;
    force += w.tiles[t].normal;
    area += tiling_.tiles()[t].area;
  }
  return area > 0.0 ? force / area : 0.0;
}

}  // namespace pulvis
