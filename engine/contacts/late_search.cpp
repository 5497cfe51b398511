// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/late_search.hpp"

namespace pulvis {
namespace {

/// A place as seen from the first crowd, so that those of that crowd stay where they are in the grid; brought into the box.
Vec3 in_grid(const ListedAt& lists, std::size_t i) {
  const Box& box = lists.box;
  Vec3 x = lists.place(i) - lists.drift[0];
  for (int axis = 0; axis < 3; ++axis) {
    if (!box.periodic[axis]) continue;
    const double length = box.max[axis] - box.min[axis];
    while (x[axis] >= box.max[axis]) x[axis] -= length;
    while (x[axis] < box.min[axis]) x[axis] += length;
  }
  return x;
}

}  // namespace

void LateSearch::look_from(std::uint32_t i, const ListedAt& lists,
                           std::vector<std::pair<std::uint32_t, std::uint32_t>>& near) {
  if (!grid_is_made_) {
    // The second crowd moves on in the grid, by no more than the crowds may come nearer.
    grid_.build(lists.box, 2.0 * (lists.widest + lists.between_crowds) + lists.reach, lists.parcels.size(),
                [&](std::size_t k) { return in_grid(lists, k); });
    grid_is_made_ = true;
  }
  const NearestImage nearest = NearestImage::of(lists.box);
  const Vec3 place = lists.place(i);
  const kernels::Leeway& leeway = lists.leeway;
  const double own = lists.parcels.body[i].radius + leeway.margin[i] + lists.reach;
  const auto compare = [&](std::uint32_t k) {
    const Vec3 d = nearest(lists.place(k) - place);
    const double far = own + lists.parcels.body[k].radius + leeway.margin[k] +
                       (leeway.crowd[k] != leeway.crowd[i] ? lists.between_crowds_left : 0.0);
    if (k != i && dot(d, d) < far * far) near.push_back({i, k});
  };
  const std::span<const std::uint32_t> order = grid_.order();
  grid_.for_ranges_around(grid_.cell_at(in_grid(lists, i)), [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t at = first; at < last; ++at) compare(order[at]);
  });
  for (const std::uint32_t k : moved_) compare(k);
  moved_.push_back(i);
}

}  // namespace pulvis
