// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "measures/container.hpp"
#include "measures/free_surface.hpp"
#include "measures/grid.hpp"
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// Porosity (share of the volume not filled by solid) in cells of the die, in coordinates of the die.
/// Index of a cell: first + cells[0] * (second + cells[1] * third); a corner of the first cell is `origin`.
struct PorosityField {
  Vec3 origin;                               ///< m; in the coordinates of the container
  std::array<Vec3, 3> axes{};                ///< unit vectors of the grid; x, y, z for a box with up = +z
  Vec3 spacing;                              ///< m; edges of a cell
  std::array<std::size_t, 3> cells{};        ///< number along each axis
  std::vector<double> values;                ///< -; NaN in cells that are left out
  std::vector<double> counted_volume;        ///< m^3; the part of the cell that counts, 0 in cells left out
  std::optional<double> mean;                ///< -; weighted by counted volume; none if no cell counts
  std::optional<double> standard_deviation;  ///< -; of the cells' values, weighted likewise
  double total_volume = 0.0;                 ///< m^3; sum of the counted volumes
  double total_solid = 0.0;                  ///< m^3; solid in them; mean = 1 - total_solid / total_volume
};

/// Usual edge of a cell in mean parcel diameters.
constexpr double cell_diameters = 3.0;

/// Porosity in cells whose edges come as close to `cell_edge` (m) as a whole number of them along each axis
/// of the die allows.
///
/// A cell counts with the part of it that lies inside the die and below the free surface, that is the sum of
/// its pieces: cell and column of the surface, up to the height of the column. The solid in it is the sum
/// over all spheres of the exact volumes they share with the same pieces. A cell of which less than half
/// counts is left out: it has no value and weighs nothing in mean and spread.
///
///   porosity_c = 1 - solid_c / volume_c,   mean = sum volume_c porosity_c / sum volume_c,
///   standard deviation = sqrt( sum volume_c (porosity_c - mean)^2 / sum volume_c ).
///
/// Where spheres overlap, the overlap counts twice. In a cylinder the cells are not bent: the piece's volume
/// is cut by the side wall exactly, the spheres (those with their centre within the wall) by the cell alone,
/// so what they press into the side wall counts as solid; in a box it does not.
/// Where the die is periodic, add the images of spheres across its faces (periodic_images.hpp) to `spheres`.
///
/// `surface` must be that of the same container (else std::invalid_argument). Same bits for any number of
/// threads.
PorosityField porosity(std::span<const Sphere> spheres, const FreeSurface& surface,
                       const Container& container, double cell_edge);

/// Share of a box filled by spheres, overlap counting twice: the sum of sphere_box_volume over the volume of
/// the box. A plain check for everything above. Throws std::invalid_argument for an empty box.
double solid_fraction_in_box(std::span<const Sphere> spheres, const Box& box);

}  // namespace pulvis::measures
