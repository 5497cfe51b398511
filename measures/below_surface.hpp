// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "measures/container.hpp"
#include "measures/free_surface.hpp"
#include "measures/shapes.hpp"

// What lies inside the die and below the free surface, in coordinates of the die: what porosity is taken of.
namespace pulvis::measures {

/// The part of a box below the free surface, as boxes: one for each column that is not empty there. Deep in
/// the bed that is the box itself.
void find_pieces(const Box& box, const FreeSurface& surface, std::vector<Box>& pieces);

/// Spheres in coordinates of the die; those outside its side wall have radius 0 and so no solid.
std::vector<Sphere> spheres_in_die(std::span<const Sphere> spheres, const DieFrame& frame);

}  // namespace pulvis::measures
