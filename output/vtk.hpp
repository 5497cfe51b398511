// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// How a field of doubles is stored: six digits are enough to look at and halve the file.
enum class Stored { single_precision, double_precision };

/// A named array with one value (or `components` values) per point or cell. Integers keep their type; a
/// span of Vec3 has three components. NaN is allowed and means "no value here".
struct Field {
  std::string name;
  std::variant<std::span<const double>, std::span<const Vec3>, std::span<const std::int32_t>,
               std::span<const std::uint32_t>, std::span<const std::int64_t>>
      values;
  int components = 1;  ///< of the number spans; Vec3 always has three
  Stored stored = Stored::single_precision;
};

/// Triangles that share points (m).
struct SurfaceMesh {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A grid of equal cells: lower corner and cell edges (m), cells per axis. Cell (i, j, k) has the index
/// i + cells[0] * (j + cells[1] * k).
struct Grid {
  Vec3 origin;
  Vec3 spacing;
  std::array<int, 3> cells{};
};

// Files for ParaView and VTK: XML with appended raw data, UInt64 headers and zlib blocks. Positions are
// stored in double precision. `time` (s) goes into the file as TimeValue. Each file is written completely or
// not at all. All throw Failure(Exit::io) if the file cannot be written and std::invalid_argument if the
// length of a field does not fit.

/// Parcels: one vertex cell per point, `fields` per point.
void write_points_vtp(const std::string& path, std::span<const Vec3> points, std::span<const Field> fields,
                      double time);

/// Walls: `fields` per triangle.
void write_surface_vtp(const std::string& path, const SurfaceMesh& mesh, std::span<const Field> fields,
                       double time);

/// A field on a grid: `fields` per cell.
void write_grid_vti(const std::string& path, const Grid& grid, std::span<const Field> fields, double time);

}  // namespace pulvis
