// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include "meshes/triangle_soup.hpp"

namespace pulvis {

/// Reads a text STL from `input`, which stands at its first byte. Throws Failure(bad_input) as "PATH:LINE:
/// ...".
TriangleSoup read_stl_text(std::istream& input, const std::string& path, std::uint64_t most_triangles);

/// Whether a file of these first bytes means to be a text STL: "solid" after blanks and a byte-order mark.
bool begins_with_solid(std::string_view first_bytes);

/// Bytes of a file made fit to be shown: at most 40, others than printable ones as "\x00".
std::string shown(std::string_view bytes);

}  // namespace pulvis
