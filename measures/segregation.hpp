// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "measures/container.hpp"
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// How unevenly sizes are spread over the die.
struct Segregation {
  std::size_t spheres = 0;              ///< whose centre is in the die
  std::optional<double> mean_diameter;  ///< m; weighted by mass; none without mass
  std::optional<double> upper, lower;   ///< m; the same of the upper and of the lower half of the mass
  std::optional<double> index;          ///< -; (upper - lower)/mean; positive: large ones on top
  std::optional<double> intensity;      ///< -; 0 mixed at random, 1 wholly unmixed; see below

  std::size_t cells = 0;    ///< cells with a sphere in them
  double of_spheres = 0.0;  ///< m^2; s_0^2, variance of the diameters
  double of_cells = 0.0;    ///< m^2; s^2, variance of the cells' mean diameters
  double at_random = 0.0;   ///< m^2; s_r^2, what s^2 is in the mean over all orders of the same spheres
};

/// Usual edge of a cell in mean parcel diameters: some 40 spheres each.
constexpr double segregation_cell_diameters = 4.0;

/// Index: the spheres whose centre is in the die, sorted by height (of equals the first in the list lies
/// lower), are cut where half of their mass lies below; the sphere at the cut belongs to both in parts.
/// d_upper, d_lower and d_mean are mass-weighted means of the diameters d; the index lies in (-2, 2).
///
/// Intensity: over cells whose edges come as close to `cell_edge` (m) as a whole number along each axis of the
/// die allows, sphere by centre, N spheres in K cells, n_c with the mean diameter d_c in each, m the mean of all:
///   s^2 = sum_c n_c (d_c - m)^2 / N,   s_0^2 = sum_i (d_i - m)^2 / N,   s_r^2 = s_0^2 (K - 1)/(N - 1),
///   intensity = max(0, (s^2 - s_r^2)/(s_0^2 - s_r^2)).
/// s_r^2 is exactly the mean of s^2 over all ways to put the same spheres in the same places. This is one less
/// Lacey's index of mixing (P. M. C. Lacey, Journal of Applied Chemistry 4 (1954) 257-268,
/// doi:10.1002/jctb.5010040504), for sizes instead of two kinds. It tells something where cells hold many
/// spheres; s^2 scatters about s_r^2 by sqrt(2/K) of it. 0 for equal sizes; none if no cell holds two spheres.
///
/// Throws std::invalid_argument unless there is one mass (kg) for each sphere, Failure for a bad edge.
Segregation segregation(std::span<const Sphere> spheres, std::span<const double> masses,
                        const Container& container, double cell_edge);

}  // namespace pulvis::measures
