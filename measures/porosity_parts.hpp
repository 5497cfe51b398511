// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measures/porosity.hpp"

namespace pulvis::measures {

/// Porosity by layers of cells along one axis of the die, the lowest first.
struct PorosityProfile {
  std::vector<double> position;  ///< m from the die's origin; the layer's middle
  std::vector<double> porosity;  ///< -; NaN where nothing counts
  std::vector<double> volume;    ///< m^3; counted volume of the layer
};

/// Profiles along the first, second and third axis: of each layer of cells 1 - (sum of solid)/(sum of counted
/// volume), that is the mean of the cells' porosities weighted by their volumes.
std::array<PorosityProfile, 3> porosity_profiles(const PorosityField& field);

/// How the porosity is spread over the counted volume: share of it in cells with edges[i] <= porosity <
/// edges[i + 1]. Shares sum to 1. Empty without a counted cell.
struct PorosityHistogram {
  std::vector<double> edges;  ///< -; multiples of the width, one more than shares
  std::vector<double> share;  ///< -
};
constexpr double usual_porosity_width = 0.01;

/// Throws std::invalid_argument for a width that is not in [1e-6, 1e6].
PorosityHistogram porosity_histogram(const PorosityField& field, double width = usual_porosity_width);

/// A named part of the die: a box in coordinates of the die (DieFrame).
struct Part {
  std::string name;
  Box box;  ///< m
};

/// The six halves: "lower half", "upper half" (third axis), "first lower half", "first upper half" (lower
/// and higher coordinate along the first axis), "second lower half", "second upper half".
std::array<Part, 6> halves(const Container& container);

/// What a part of the die holds.
struct PartPorosity {
  double volume = 0.0;             ///< m^3; of the part inside the die and below the free surface
  double solid = 0.0;              ///< m^3; of spheres in it
  double mass = 0.0;               ///< kg; of the spheres, each with the share of its volume that is in it
  std::optional<double> porosity;  ///< -; 1 - solid/volume; none without volume
  std::optional<double>
      standard_deviation;         ///< -; over cells of the field; none if none has its middle there
  std::optional<double> density;  ///< kg/m^3; apparent density, mass/volume; none without volume
};

/// Porosity of a part of the die, exactly: volume and solid are those of the pieces that porosity() uses (see
/// there: overlaps count twice; the side wall of a cylinder cuts the volume, not the spheres), but cut by the
/// part instead of by cells, and however small.
///
/// The spread is sqrt( sum V (p - q)^2 / sum V ) over the counted cells of `field` (counted volume V, porosity
/// p) whose middle lies in the part, edges belonging to it, q being their own mean: a layer of cells that is
/// cut in the middle counts for both halves.
///
/// `masses` (kg) belong to `spheres` one by one, or are empty: then mass and density are 0. Give periodic
/// images with the masses of what they are images of. std::invalid_argument if numbers differ or the surface
/// or the field is that of another die. Same bits for any number of threads.
PartPorosity part_porosity(std::span<const Sphere> spheres, std::span<const double> masses,
                           const FreeSurface& surface, const Container& container, const PorosityField& field,
                           const Box& part);

/// 1 for each sphere whose centre lies in the die and in the part, 0 for the others. A face of the part
/// belongs to what lies above it, so that two halves share no sphere.
std::vector<std::uint8_t> centres_in_part(std::span<const Sphere> spheres, const Container& container,
                                          const Box& part);

}  // namespace pulvis::measures
