// SPDX-License-Identifier: Apache-2.0
#include "measures/below_surface.hpp"

namespace pulvis::measures {

void find_pieces(const Box& box, const FreeSurface& surface, std::vector<Box>& pieces) {
  pieces.clear();
  const Division &first = surface.along_first, &second = surface.along_second;
  bool all_below = true;
  for (std::size_t j = second.at(box.min.y); j <= second.at(box.max.y); ++j)
    for (std::size_t i = first.at(box.min.x); i <= first.at(box.max.x); ++i) {
      const double height = surface.height(i, j);
      const Box piece{{greatest(box.min.x, first.edge(i)), greatest(box.min.y, second.edge(j)), box.min.z},
                      {least(box.max.x, first.edge(i + 1)), least(box.max.y, second.edge(j + 1)),
                       least(box.max.z, height)}};
      // Box and column may share an edge and nothing else: such a column has no say.
      if (!(piece.min.x < piece.max.x && piece.min.y < piece.max.y)) continue;
      all_below = all_below && height >= box.max.z;
      if (piece.min.z < piece.max.z) pieces.push_back(piece);
    }
  if (all_below) pieces.assign(1, box);
}

std::vector<Sphere> spheres_in_die(std::span<const Sphere> spheres, const DieFrame& frame) {
  std::vector<Sphere> local;
  local.reserve(spheres.size());
  for (const Sphere& sphere : spheres) {
    const Vec3 centre = frame.to_local(sphere.centre);
    local.push_back({centre, frame.within_side_wall(centre) ? sphere.radius : 0.0});
  }
  return local;
}

}  // namespace pulvis::measures
