// SPDX-License-Identifier: Apache-2.0
#include "measures/wall_tile.hpp"

#include <fmt/format.h>

#include "engine/base/failure.hpp"

namespace pulvis::measures {

void check_number_of_tiles(double area, double edge, const std::string& name) {
  constexpr double most = 1e7;
  if (edge > 0.0 && area > 0.0 && area < most * square(edge)) return;
  throw Failure(Exit::bad_case,
                fmt::format("cannot divide the {} m^2 of \"{}\" into tiles of {} m: both must be "
                            "above zero, and the edge not too small for the wall",
                            area, name, edge));
}

}  // namespace pulvis::measures
