// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>

#include "meshes/triangle_soup.hpp"

// STL files. The format has no unit, no shared corners and no rule for its first word: half of the programs
// that write binary files begin them with "solid". What a file is, its size and its bytes decide, not its
// name.
namespace pulvis {

/// The most triangles whose corners 32-bit indices can still tell apart.
inline constexpr std::uint64_t most_stl_triangles = 0xFFFFFFFFu / 3;

/// Reads a binary or a text file; several `solid` blocks of one file are one soup. The normals in the file
/// are not read: the order of the corners says the same, and programs write zeros and NaN there.
/// Throws Failure(bad_input) with the place for anything that is not a complete STL file of finite corners.
TriangleSoup read_stl(const std::string& path, std::uint64_t most_triangles = most_stl_triangles);

enum class StlForm {
  binary,  ///< corners rounded to 32 bits
  text,    ///< corners to the last bit
};

/// Writes `soup` under a temporary name, then renames; `name` stands in the header. Throws Failure(io).
void write_stl(const std::string& path, const TriangleSoup& soup, StlForm form,
               const std::string& name = "pulvis");

}  // namespace pulvis
