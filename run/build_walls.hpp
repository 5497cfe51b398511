// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/walls/bodies.hpp"
#include "run/problems.hpp"
#include "run/species.hpp"

namespace pulvis {

/// The walls of a case as the engine takes them, and what reading their meshes brought to light.
struct BuiltWalls {
  Walls walls;
  std::vector<std::string> notes;     ///< a line for each mesh: size, triangles, what was mended
  std::vector<std::string> warnings;  ///< holes and the like
};

/// Makes the walls; reads meshes. Walls::names are those of Case::walls, in their order. Throws
/// Failure(bad_input) for a file that is no STL.
BuiltWalls build_walls(const Case& c, const std::vector<Species>& species, double largest_radius);

/// The smallest box around a wall where its file has it; false if it has no bounds (a plane).
bool bounds_of_wall(const Walls& walls, std::size_t wall, Vec3& low, Vec3& high);

/// Widths of what powder could be in, m; the narrowest of a flat wall does not count. `size`: of its bounds.
double narrowest_width(const Wall& wall, const Vec3& size);
/// Width of the hole of a disc or the narrow end of a cone, m; 0 where there is none.
double outlet_width(const Wall& wall);

/// Walls against parcels and the domain: too narrow, out of reach, across a periodic end.
void check_walls(const Case& c, const Walls& walls, double largest_radius, Problems& problems);

/// Refuses walls that cut through a source's region: parcels would appear on both sides.
void check_walls_in_region(const Case& c, const Source& source, const Walls& walls, const Box& domain,
                           Problems& problems);

/// Refuses bodies that go through each other, where the case puts them or on their ways.
void check_bodies_keep_apart(const Case& c, const Walls& walls, const Box& domain, double dt,
                             Problems& problems);

/// Refuses walls that move more than 5 % of the smallest radius in a step.
void check_wall_speeds(const Case& c, const Walls& walls, double dt, double smallest_radius,
                       Problems& problems);

/// Largest speed that any wall can reach in a phase, m/s.
double peak_wall_speed(const Case& c, const Walls& walls, const Phase& phase);

}  // namespace pulvis
