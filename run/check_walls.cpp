// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "engine/contacts/near_walls.hpp"
#include "meshes/piercing.hpp"
#include "run/build_walls.hpp"
#include "run/wall_mesh.hpp"

namespace pulvis {
namespace {

constexpr double rounding = 1e-9;  // m; shapes that touch do not cut each other

std::string place_text(const Vec3& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x, 1e3 * p.y, 1e3 * p.z);
}

void check_size(const Wall& wall, const Vec3& size, double largest_diameter, Problems& problems) {
  const double width = narrowest_width(wall, size);
  if (width >= 3.0 * largest_diameter) return;
  const bool mesh = wall.shape == Wall::Shape::mesh;
  problems.add("walls." + wall.name,
               fmt::format("walls.{} is only {} wide, less than three of the largest parcels ({})\n  lower "
                           "coarse_graining, or check the units of the wall: {}",
                           wall.name, in_mm(width), in_mm(largest_diameter),
                           mesh ? fmt::format("its file may be in {}", wall.unit < 1e-3 ? "mm" : "m")
                                : "is it in mm?"),
               {"powders"});
}

/// An opening through which grains pass and parcels do not.
void check_outlet(const Wall& wall, double largest_grain, double largest_parcel, Problems& problems) {
  const double width = outlet_width(wall);
  if (width < largest_grain || width >= largest_parcel) return;
  problems.add(
      "walls." + wall.name,
      fmt::format(
          "the opening of walls.{} is {} wide: the largest grain ({}) passes, the largest parcel ({}) "
          "does not\n  lower coarse_graining, or widen the opening",
          wall.name, in_mm(width), in_mm(largest_grain), in_mm(largest_parcel)));
}

void check_within_domain(const Wall& wall, const Vec3& low, const Vec3& high, const Box& domain,
                         Problems& problems) {
  const Vec3 extent = domain.extent(), size = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    const bool apart = high[axis] < domain.min[axis] || low[axis] > domain.max[axis];
    const bool huge = size[axis] > 100.0 * norm(extent);
    if (apart || huge) {
      problems.add("walls." + wall.name,
                   fmt::format("walls.{} reaches from {} to {} along {}, the domain from {} to {}\n  {}",
                               wall.name, in_mm(low[axis]), in_mm(high[axis]), "xyz"[axis],
                               in_mm(domain.min[axis]), in_mm(domain.max[axis]),
                               wall.shape == Wall::Shape::mesh
                                   ? "check the unit and the offset of the mesh, or the domain"
                                   : "check the units of the wall, or the domain"),
                   {"domain"});
      return;
    }
    const bool beyond = low[axis] < domain.min[axis] - rounding || high[axis] > domain.max[axis] + rounding;
    if (domain.periodic[axis] && beyond && !wall.has_inside())  // those are looked at by the reader
      problems.add(
          "walls." + wall.name,
          fmt::format("walls.{} reaches beyond the domain along the periodic axis {}\n  parcels meet a "
                      "wall, not its images: keep it within the domain",
                      wall.name, "xyz"[axis]),
          {"domain"});
  }
}

/// Where the case puts each body after some time in each phase so far: the engine's way of moving, foreseen.
class Foresight {
 public:
  Foresight(const Case& c, const Walls& walls) : case_(c), walls_(walls), left_(c.motions.size()) {}

  Rigid placement(std::uint32_t body, const Phase* phase, double since) const {
    Rigid at;
    for (const std::size_t m : walls_.bodies[body].motions) {
      const bool runs =
          phase && std::find(phase->motions.begin(), phase->motions.end(), m) != phase->motions.end();
      at = (runs ? displacement(case_.motions[m].motion, since) * left_[m] : left_[m]) * at;
    }
    return at;
  }
  void end(const Phase& phase, double length) {
    for (const std::size_t m : phase.motions)
      left_[m] = displacement(case_.motions[m].motion, length) * left_[m];
  }

 private:
  const Case& case_;
  const Walls& walls_;
  std::vector<Rigid> left_;
};

double foreseen_length(const Case& c, const Phase& phase) {
  switch (phase.until) {
    case Phase::Until::time:
      return phase.duration;
    case Phase::Until::cycles:
      return length_of_cycles(c.motions[phase.motions.front()].motion, phase.cycles).value_or(0.0);
    case Phase::Until::motions: {
      double length = 0.0;
      for (const std::size_t m : phase.motions)
        length = std::max(length, duration(c.motions[m].motion).value_or(0.0));
      return length;
    }
    default:
      return phase.time_limit;
  }
}

TriangleMesh moved(const TriangleMesh& mesh, const Rigid& by) {
  TriangleMesh result = mesh;
  for (Vec3& p : result.points) p = by(p);
  return result;
}

/// What repeats is looked at for a few cycles, all else for its whole length, s.
double span_worth_looking(const motions::Motion& motion, double length) {
  if (std::holds_alternative<motions::SquareWave>(motion.kind)) return length;  // swells for many cycles
  return length_of_cycles(motion, 4.0).value_or(length);
}

/// Looks for bodies that pierce each other. Names the first pair only once.
class Keeper {
 public:
  Keeper(const Case& c, const Walls& walls, const Box& domain, Problems& problems)
      : case_(c), walls_(walls), problems_(problems), reported_(walls.bodies.size() * walls.bodies.size()) {
    for (std::uint32_t b = 0; b < walls.bodies.size(); ++b)
      mesh_.push_back(triangles_of_body(walls, b, domain));
  }

  std::size_t triangles() const {
    std::size_t count = 0;
    for (const TriangleMesh& m : mesh_) count += m.triangles.size();
    return count;
  }

  /// Of pairs in which `counts(a, b)` says so.
  template <class Counts>
  void look(const Foresight& foresight, const Phase* phase, double since, Counts&& counts) {
    std::vector<TriangleMesh> now(mesh_.size());
    for (std::uint32_t b = 0; b < mesh_.size(); ++b)
      now[b] = moved(mesh_[b], foresight.placement(b, phase, since));
    for (std::uint32_t a = 0; a < mesh_.size(); ++a)
      for (std::uint32_t b = a + 1; b < mesh_.size(); ++b) {
        if (reported_[a * mesh_.size() + b] || !counts(a, b)) continue;
        const auto piercing = first_piercing(now[a], now[b], rounding);
        if (!piercing) continue;
        reported_[a * mesh_.size() + b] = true;
        report(a, b, phase, since, piercing->place);
      }
  }

 private:
  void report(std::uint32_t a, std::uint32_t b, const Phase* phase, double since, const Vec3& place) {
    const std::string &one = walls_.bodies[a].name, &other = walls_.bodies[b].name;
    const auto first =
        std::find_if(case_.walls.begin(), case_.walls.end(), [&](const Wall& w) { return w.body == other; });
    const std::string when = phase == nullptr || since == 0.0
                                 ? std::string(phase ? "where the phase \"" + phase->name + "\" begins"
                                                     : "where the case puts them")
                                 : fmt::format("{} after the phase \"{}\" begins",
                                               format_quantity(since, dimension::time), phase->name);
    std::vector<std::string> parts;
    for (const Wall& w : case_.walls) {
      if (w.body != one && w.body != other) continue;
      parts.push_back("walls." + w.name);
      for (const std::size_t m : w.motions) parts.push_back("motions." + case_.motions[m].name);
    }
    problems_.add(
        "walls." + first->name,
        fmt::format("{} and {} cut into each other at {}, {}\n  move one of them, mend its motion, or give "
                    "them the same body if they belong together",
                    one, other, place_text(place), when),
        parts);
  }

  const Case& case_;
  const Walls& walls_;
  Problems& problems_;
  std::vector<TriangleMesh> mesh_;
  std::vector<bool> reported_;
};

bool is_absent(const Case& c, const Walls& walls, std::uint32_t body, const Phase& phase) {
  return std::any_of(phase.without.begin(), phase.without.end(),
                     [&](std::size_t w) { return c.walls[w].body == walls.bodies[body].name; });
}

/// Planes have no end: where they stand still, it is no fault that others cut them.
bool is_plane_at_rest(const Case& c, const Walls& walls, std::uint32_t body) {
  return walls.bodies[body].motions.empty() &&
         std::all_of(c.walls.begin(), c.walls.end(), [&](const Wall& w) {
           return w.body != walls.bodies[body].name || w.shape == Wall::Shape::plane;
         });
}

bool moves_in(const Walls& walls, std::uint32_t body, const Phase& phase) {
  return std::any_of(walls.bodies[body].motions.begin(), walls.bodies[body].motions.end(),
                     [&](std::size_t m) {
                       return std::find(phase.motions.begin(), phase.motions.end(), m) != phase.motions.end();
                     });
}

/// Upper bound of a body's speed in a phase, m/s, from the corners of a box around it.
double body_speed(const Case& c, const Walls& walls, std::uint32_t body, const Phase& phase) {
  Vec3 low{1e300, 1e300, 1e300}, high = -low;
  for (std::size_t w = 0; w < c.walls.size(); ++w) {
    if (c.walls[w].body != walls.bodies[body].name) continue;
    Vec3 wall_low, wall_high;
    const bool bounded = bounds_of_wall(walls, w, wall_low, wall_high);
    if (!bounded) wall_low = c.domain.min, wall_high = c.domain.max;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], wall_low[axis]);
      high[axis] = std::max(high[axis], wall_high[axis]);
    }
  }
  double speed = 0.0;
  for (const std::size_t m : walls.bodies[body].motions) {
    if (std::find(phase.motions.begin(), phase.motions.end(), m) == phase.motions.end()) continue;
    const motions::Peaks peaks = motions::peaks(c.motions[m].motion);
    double farthest = 0.0;
    for (unsigned k = 0; k < 8; ++k) {
      const Vec3 corner{k & 1u ? high.x : low.x, k & 2u ? high.y : low.y, k & 4u ? high.z : low.z};
      const Vec3 arm = corner - peaks.point;
      farthest = std::max(farthest, norm(arm - dot(arm, peaks.axis) * peaks.axis));
    }
    speed += peaks.speed + (peaks.rate > 0.0 ? peaks.rate * farthest : 0.0);
  }
  return speed;
}

}  // namespace

double narrowest_width(const Wall& wall, const Vec3& size) {
  double width[3] = {size.x, size.y, size.z};
  std::sort(width, width + 3);
  switch (wall.shape) {
    case Wall::Shape::box:
      return width[0];
    case Wall::Shape::cylinder:
      return std::min(2.0 * wall.region.radius, wall.region.height);
    case Wall::Shape::cone:
      return std::min(2.0 * std::max(wall.radius, wall.other_radius), wall.height);
    case Wall::Shape::sphere:
      return 2.0 * wall.radius;
    case Wall::Shape::mesh:
      return width[1];
    default:
      return 1e300;
  }
}

double outlet_width(const Wall& wall) {
  if (wall.shape == Wall::Shape::disc) return 2.0 * wall.other_radius;
  if (wall.shape == Wall::Shape::cone) return 2.0 * std::min(wall.radius, wall.other_radius);
  return 0.0;
}

void check_walls(const Case& c, const Walls& walls, double largest_radius, Problems& problems) {
  Box domain{c.domain.min, c.domain.max, {c.domain.periodic[0], c.domain.periodic[1], c.domain.periodic[2]}};
  for (std::size_t w = 0; w < c.walls.size(); ++w) {
    Vec3 low, high;
    if (!bounds_of_wall(walls, w, low, high)) continue;
    check_outlet(c.walls[w], 2.0 * largest_radius / c.powders.front().coarse_graining, 2.0 * largest_radius,
                 problems);
    check_size(c.walls[w], high - low, 2.0 * largest_radius, problems);
    check_within_domain(c.walls[w], low, high, domain, problems);
  }
}

void check_walls_in_region(const Case& c, const Source& source, const Walls& walls, const Box& domain,
                           Problems& problems) {
  const auto number = static_cast<std::size_t>(&source - c.sources.data());
  const auto is_there = [&](std::uint32_t body) {  // in a phase that opens the source
    return std::any_of(c.phases.begin(), c.phases.end(), [&](const Phase& p) {
      const bool opens = std::find(p.sources.begin(), p.sources.end(), number) != p.sources.end();
      return opens && !is_absent(c, walls, body, p);
    });
  };
  const TriangleMesh region = triangles_of(source.region);
  const auto check = [&](const TriangleMesh& mesh, const std::string& name) {
    if (!first_piercing(region, mesh, rounding)) return;
    problems.add(
        fmt::format("sources.{}.region", source.name),
        fmt::format("the wall {} passes through sources.{}.region; parcels would appear in the wall\n"
                    "  keep the region on one side of it",
                    name, source.name),
        {"walls." + name.substr(0, name.find('.'))});
  };
  for (const Surface& s : walls.surfaces)
    if (s.kind != Surface::Kind::patch && is_there(s.body)) check(triangles_of(s, domain), s.name);
  for (const FacetedWall& mesh : walls.meshes)
    if (is_there(walls.surfaces[mesh.first_surface].body))
      check(mesh.mesh(), walls.names[walls.surfaces[mesh.first_surface].wall]);
}

void check_bodies_keep_apart(const Case& c, const Walls& walls, const Box& domain, double dt,
                             Problems& problems) {
  Keeper keeper(c, walls, domain, problems);
  Foresight foresight(c, walls);
  // As many looks as take seconds at most, for dies of few and of many triangles.
  const double looks = std::clamp(4e5 / static_cast<double>(keeper.triangles() + 1), 16.0, 256.0);
  for (const Phase& phase : c.phases) {
    const auto present = [&](std::uint32_t a, std::uint32_t b) {
      const bool both_at_rest = walls.bodies[a].motions.empty() && walls.bodies[b].motions.empty();
      if (both_at_rest && (is_plane_at_rest(c, walls, a) || is_plane_at_rest(c, walls, b))) return false;
      return !is_absent(c, walls, a, phase) && !is_absent(c, walls, b, phase);
    };
    keeper.look(foresight, &phase, 0.0, present);
    const double length = foreseen_length(c, phase);
    double span = 0.0;
    for (const std::size_t m : phase.motions)
      span = std::max(span, span_worth_looking(c.motions[m].motion, length));
    span = std::min(span, length);
    const bool any_moves = !phase.motions.empty();
    for (double k = 1.0; any_moves && k <= looks; k += 1.0)
      keeper.look(foresight, &phase, span * k / looks, [&](std::uint32_t a, std::uint32_t b) {
        return present(a, b) && (moves_in(walls, a, phase) || moves_in(walls, b, phase));
      });
    foresight.end(phase, std::max(std::round(length / dt), 1.0) * dt);
  }
}

void check_wall_speeds(const Case& c, const Walls& walls, double dt, double smallest_radius,
                       Problems& problems) {
  for (std::uint32_t b = 0; b < walls.bodies.size(); ++b) {
    double speed = 0.0;
    std::size_t last = 0;  // the motion that carries the others
    for (const Phase& phase : c.phases) {
      speed = std::max(speed, body_speed(c, walls, b, phase));
      for (const std::size_t m : walls.bodies[b].motions)
        if (std::find(phase.motions.begin(), phase.motions.end(), m) != phase.motions.end()) last = m;
    }
    const double leap = speed * dt;
    if (leap <= 0.05 * smallest_radius) continue;
    problems.add("motions." + c.motions[last].name,
                 fmt::format("the body {} moves {} in one time step, more than 5 % of the smallest radius "
                             "({})\n  lower the speed of its motions (amplitude, frequency, rate), or "
                             "time.fraction",
                             walls.bodies[b].name, in_mm(leap), in_mm(smallest_radius)),
                 {"time", "powders", "materials", "contact", "pairs"});
  }
}

double peak_wall_speed(const Case& c, const Walls& walls, const Phase& phase) {
  double speed = 0.0;
  for (std::uint32_t b = 0; b < walls.bodies.size(); ++b)
    speed = std::max(speed, body_speed(c, walls, b, phase));
  return speed;
}

}  // namespace pulvis
