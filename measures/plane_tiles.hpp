// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "engine/walls/surface.hpp"
#include "measures/cell_tiles.hpp"
#include "measures/polygon.hpp"

namespace pulvis::measures {

/// What the box from `low` to `high` cuts out of a plane, in the frame of its body. Less than three corners:
/// nothing. A plane on a face of the box lies in it.
Polygon plane_in_box(const Surface& plane, const Vec3& low, const Vec3& high);

/// Tiles of that polygon, or nothing if it has no area: an even grid along perpendicular(normal) and the
/// direction at right angles to it, which is that of the edges if the plane is parallel to an axis. Pieces
/// below half of edge^2 are joined with neighbours. u and v count from the plane's point.
std::optional<CellTiles> plane_tiles(const Surface& plane, const Vec3& low, const Vec3& high, double edge);

}  // namespace pulvis::measures
