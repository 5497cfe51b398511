// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/insertion/drawing.hpp"

namespace pulvis {
namespace {

constexpr int most_rounds = 2000;
constexpr double deepest_overlap = 0.01;  // over the sum of two radii: where pushing apart may end
constexpr double relaxation =
    0.25;  // of an overlap, by each of two in a round; 1/2 would end it if they were alone

/// Spheres of a box that is periodic all around, which push each other apart. In serial, in order of their numbers.
class Crowd {
 public:
  Crowd(const Box& box, const std::vector<double>& diameters, const Dice& dice, std::uint64_t first_number)
      : box_(box), periods_(NearestImage::of(box)), diameters_(diameters), centre_(diameters.size()) {
    const Vec3 extent = box.extent();
    for (std::size_t k = 0; k < centre_.size(); ++k) {
      const auto drawn = dice(first_number + k, 1);
      centre_[k] = box.min + Vec3{drawn[0] * extent.x, drawn[1] * extent.y, drawn[2] * extent.z};
    }
    const double edge = *std::max_element(diameters.begin(), diameters.end());
    for (int axis = 0; axis < 3; ++axis)
      cells_[axis] = std::clamp(static_cast<int>(extent[axis] / edge), 1, 1024);
  }

  /// One round; returns the largest overlap over the sum of the radii.
  double push_apart() {
    sort_into_cells();
    move_.assign(centre_.size(), {});
    double deepest = 0.0;
    for (std::uint32_t k = 0; k < centre_.size(); ++k) deepest = greatest(deepest, push(k));
    for (std::size_t k = 0; k < centre_.size(); ++k) centre_[k] = inside(centre_[k] + move_[k]);
    return deepest;
  }
  const Vec3& centre(std::size_t k) const { return centre_[k]; }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  Vec3 inside(Vec3 x) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double length = box_.max[axis] - box_.min[axis];
      if (x[axis] >= box_.max[axis]) x[axis] -= length;
      if (x[axis] < box_.min[axis]) x[axis] += length;
      x[axis] = least(greatest(x[axis], box_.min[axis]), box_.max[axis]);
    }
    return x;
  }
  int cell_along(const Vec3& x, int axis) const {
    const double share = (x[axis] - box_.min[axis]) / (box_.max[axis] - box_.min[axis]);
    return std::clamp(static_cast<int>(share * cells_[axis]), 0, cells_[axis] - 1);
  }
  std::size_t cell(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(cells_[0]) +
           static_cast<std::size_t>(i);
  }
  void sort_into_cells() {
    first_.assign(cell(0, 0, cells_[2]), none);
    next_.resize(centre_.size());
    for (auto k = static_cast<std::uint32_t>(centre_.size()); k-- > 0;) {
      std::uint32_t& first =
          first_[cell(cell_along(centre_[k], 0), cell_along(centre_[k], 1), cell_along(centre_[k], 2))];
      next_[k] = first;
      first = k;
    }
  }
  /// The cells next to a sphere along an axis, each once.
  std::pair<std::array<int, 3>, int> around(const Vec3& x, int axis) const {
    const int all = cells_[axis], at = cell_along(x, axis);
    if (all < 3) return {{0, 1, 2}, all};
    return {{(at + all - 1) % all, at, (at + 1) % all}, 3};
  }
  double push(std::uint32_t k) {
    const auto [is, i_count] = around(centre_[k], 0);
    const auto [js, j_count] = around(centre_[k], 1);
    const auto [ls, l_count] = around(centre_[k], 2);
    double deepest = 0.0;
    for (int l = 0; l < l_count; ++l)
      for (int j = 0; j < j_count; ++j)
        for (int i = 0; i < i_count; ++i)
          for (std::uint32_t other =
                   first_[cell(is[static_cast<std::size_t>(i)], js[static_cast<std::size_t>(j)],
                               ls[static_cast<std::size_t>(l)])];
               other != none; other = next_[other])
            if (other > k) deepest = greatest(deepest, push(k, other));
    return deepest;
  }
  double push(std::uint32_t k, std::uint32_t other) {
    const Vec3 apart = periods_(centre_[other] - centre_[k]);
    const double touch = 0.5 * (diameters_[k] + diameters_[other]);
    if (dot(apart, apart) >= touch * touch) return 0.0;
    const double distance = norm(apart);
    const Vec3 direction = distance > 0.0 ? apart / distance : Vec3{1, 0, 0};
    const Vec3 share = (relaxation * (touch - distance)) * direction;
    move_[k] -= share;
    move_[other] += share;
    return (touch - distance) / touch;
  }

  Box box_;
  NearestImage periods_;
  const std::vector<double>& diameters_;
  std::vector<Vec3> centre_, move_;
  int cells_[3];
  std::vector<std::uint32_t> first_, next_;
};

}  // namespace

/// Centres are thrown into the box at random and push each other apart until nowhere more than a hundredth of two
/// radii overlaps, or to the end of all rounds: near and above random close packing some overlap is left.
std::vector<Parcel> draw_dense(const SourceModel& m, SourceState& state, const Dice& dice,
                               const Surroundings& around) {
  const std::uint64_t first_number = state.count;
  std::vector<double> diameters;
  while (const double diameter = next_diameter(m, state, dice)) {
    diameters.push_back(diameter);
    ++state.count;
    state.mass += mass_of(m, diameter);
  }
  state.done = true;
  if (diameters.empty()) return {};
  Crowd crowd(around.domain, diameters, dice, first_number);
  for (int round = 0; round < most_rounds && crowd.push_apart() > deepest_overlap; ++round) {
  }
  std::vector<Parcel> parcels;
  parcels.reserve(diameters.size());
  for (std::size_t k = 0; k < diameters.size(); ++k)
    parcels.push_back(parcel_at(m, crowd.centre(k), diameters[k]));
  return parcels;
}

}  // namespace pulvis
