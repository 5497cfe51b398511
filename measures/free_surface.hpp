// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "measures/container.hpp"
#include "measures/grid.hpp"
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// The free surface of the powder as a map of heights above the die's floor, in coordinates of the die
/// (DieFrame). Heights may exceed the die: powder heaped above it.
struct FreeSurface {
  Division along_first, along_second;  ///< columns along the first and second axis of the die
  std::vector<double> heights;         ///< m above the floor; index = first + second * along_first.count()
  std::vector<double> areas;           ///< m^2; part of each column inside the die, seen from above
  std::size_t cluster_size = 0;        ///< spheres in the largest contact cluster of the die
  double mean = 0.0;                   ///< m; mean height, weighted by area; 0 for an empty die
  double roughness = 0.0;  ///< m; standard deviation of height, weighted by area; 0 for an empty die
  double slope_first = 0.0, slope_second = 0.0;  ///< -; of the plane that fits best, rising along the axes
  double tilt = 0.0;                             ///< rad; of that plane against the die's floor

  double height(std::size_t first, std::size_t second) const {
    return heights[first + second * along_first.count()];
  }
};

/// Usual edge of a column in mean parcel diameters.
constexpr double column_diameters = 2.0;

/// Height map in columns whose edges come as close to `column_edge` (m) as a whole number of them across the
/// die allows.
///
/// The powder that counts is the largest contact cluster of the spheres whose centre is in the die or
/// straight above it: what flies, and clumps not joined to the bed, do not. Contacts with walls join nothing.
/// The height of a column is the highest point (centre + radius) of the spheres of that cluster whose centre
/// lies in the column; the floor, 0, if there is none.
///
/// Mean and roughness are weighted by the columns' areas inside the die; columns of which less than half is
/// inside (there are such only in a cylinder) are left out of them.
///
/// The plane h = c + s_1 x + s_2 y through the middles (x, y) of the same columns has the least
/// sum A (height - h)^2, A being their areas; tilt = atan(sqrt(s_1^2 + s_2^2)). A direction along which there
/// is one column only has slope 0.
///
/// Of clusters of the same size the one with the sphere first in the list wins: for a result that does not
/// depend on storage, give the spheres in the order of their ids. Give no periodic images.
FreeSurface free_surface(std::span<const Sphere> spheres, std::span<const Contact> contacts,
                         const Container& container, double column_edge);

/// Throws std::invalid_argument if the surface has not the columns of this die.
void check_surface(const FreeSurface& surface, const DieFrame& frame);

/// Volume inside the die below the free surface, m^3: the sum over the columns of what lies inside the die up
/// to min(height, height of the die). Columns of which less than half is inside, whose height says nothing,
/// are as high as the others are in the mean. std::invalid_argument if the surface is that of another die.
double filled_volume(const FreeSurface& surface, const Container& container);

}  // namespace pulvis::measures
