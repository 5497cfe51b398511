// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pulvis::report {

/// A number that a run measured, SI.
struct Scalar {
  std::string name;
  double value = 0.0;  ///< NaN: nothing to measure
  std::string unit, window;
};

/// The die that was measured, in its own frame: first, second, third (up).
struct Die {
  std::string shape;
  std::vector<double> size;  ///< m
};

/// Cells of a grid in the die; index = i + n0 (j + n1 k). NaN where there is no value.
struct PorosityGrid {
  std::array<std::size_t, 3> cells{};
  std::array<double, 3> spacing{};  ///< m
  std::vector<double> values, volume;
};

/// Porosity of slices across an axis of the die: "first", "second", "third".
struct PorosityProfile {
  std::string axis;
  std::vector<double> position, porosity, volume;  ///< m, -, m^3
};

/// Heights of a histogram's bars; one edge more than bars.
struct Histogram {
  std::vector<double> edges, heights;
};

/// A part of the die.
struct Part {
  std::string name;
  double porosity = 0.0, porosity_std = 0.0, volume = 0.0;  ///< -, -, m^3
  double density = 0.0, coordination = 0.0;                 ///< kg/m^3, -
};

/// Columns above the die's floor; index = i + n0 j.
struct FreeSurface {
  std::array<std::size_t, 2> columns{};
  std::array<double, 2> spacing{};                 ///< m
  std::vector<double> heights;                     ///< m
  double mean = 0.0, roughness = 0.0, tilt = 0.0;  ///< m, m, rad
};

struct Layers {
  std::vector<double> height, density, vertical_stress, speed;  ///< m, kg/m^3, Pa, m/s
};

/// measures/after-PHASE.json: what was measured at the end of a phase. Blocks that could not be are absent.
struct MeasuresFile {
  std::string phase;
  double time = 0.0;  ///< s
  std::optional<Die> die;
  std::vector<Scalar> scalars;
  std::optional<PorosityGrid> porosity;
  std::vector<PorosityProfile> profiles;
  std::optional<Histogram> porosity_histogram;
  std::vector<Part> parts;
  std::optional<FreeSurface> surface;
  std::vector<double> coordination;              ///< number of parcels by their number of contacts
  std::optional<Histogram> forces;               ///< density of the contact force over its mean
  double mean_force = 0.0, pulling_share = 0.0;  ///< N, -
  std::optional<Layers> layers;
  double mean_diameter = 0.0;  ///< m; NaN if it was not measured

  const PorosityProfile* profile(const std::string& axis) const;
  const Part* part(const std::string& name) const;
};

/// Nothing if there is no such file. Throws Failure(Exit::bad_input) naming file and entry if it is damaged or of
/// another version.
std::optional<MeasuresFile> read_measures(const std::string& path);

}  // namespace pulvis::report
