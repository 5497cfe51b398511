// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "meshes/mending.hpp"

namespace pulvis {

/// "die.stl: 10 x 8 x 9 mm, 1,234 triangles, watertight (320 mm^3); mended: 1 sliver removed, 12 turned
/// round".
std::string describe(const MeshReport& report, const std::string& name);

/// What powder could escape through or a picture be wrong about, a line each: holes, edges of more than two
/// triangles, surfaces of one side only, slivers that stayed. Empty for a sound mesh.
std::vector<std::string> warnings_of(const MeshReport& report, const std::string& name);

}  // namespace pulvis
