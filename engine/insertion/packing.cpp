// SPDX-License-Identifier: Apache-2.0
#include "engine/insertion/packing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "engine/base/parallel.hpp"

namespace pulvis {
namespace {

// Tries of a round: more while few find a place, so that threads seldom stop for each other; few while many
// do, so that those of one round are seldom in each other's way.
constexpr std::size_t fewest_tries = 4096, most_tries = 1 << 17, most_of_one = 256, placed_per_try = 8;
// Spheres are tried together with others of nearly their size only: the small ones find places so much more
// easily that none would be left for the large.
constexpr double size_class = 0.9;

constexpr double block_diameters = 4.0;
constexpr double most_blocks = 65536.0;

}  // namespace

Packing::Packing(const SourceModel& model, const Dice& dice, const Surroundings& around,
                 std::uint64_t first_number, const std::vector<double>& diameters)
    : dice_(dice),
      around_(around),
      first_number_(first_number),
      diameters_(diameters),
      places_(model),
      grid_(grid_of_present(model, places_, around, diameters.size())),
      rank_(diameters.size()),
      tried_(diameters.size(), 0),
      centre_(diameters.size()),
      has_place_(diameters.size(), false) {
  sort_by_size();
  const Vec3 extent = places_.high() - places_.low();
  const double per_axis = std::cbrt(most_blocks);
  for (int axis = 0; axis < 3; ++axis) {
    const double wish = extent[axis] / (block_diameters * model.sizes->largest());
    blocks_[axis] = static_cast<std::size_t>(std::clamp(wish, 1.0, per_axis));
    blocks_per_metre_[axis] = static_cast<double>(blocks_[axis]) / extent[axis];
  }
}

void Packing::sort_by_size() {
  std::iota(rank_.begin(), rank_.end(), 0u);
  std::sort(rank_.begin(), rank_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return diameters_[a] != diameters_[b] ? diameters_[a] > diameters_[b] : a < b;
  });
}

bool Packing::place_all() {
  std::uint64_t in_vain = 0;
  for (;;) {
    fill_window();
    if (window_.empty()) return true;
    renew_map();
    find_places();
    const std::size_t tries = each_ * window_.size(), taken = take_places();
    refused_ += tries - taken;
    if (16 * taken < tries) goal_ *= 2;
    if (4 * taken > tries) goal_ /= 2;
    in_vain = taken > 0 ? 0 : in_vain + tries;
    if (in_vain >= hopeless) return false;
  }
}

/// The window: the largest without a place, all of one size class, as many as a round can try.
void Packing::fill_window() {
  goal_ = std::clamp(goal_, std::clamp(placed_ / placed_per_try, fewest_tries, most_tries), most_tries);
  while (next_ < rank_.size() && window_.size() < goal_) {
    if (!window_.empty() && diameters_[rank_[next_]] < size_class * diameters_[window_.front()]) break;
    window_.push_back(rank_[next_++]);
  }
  if (window_.empty()) return;
  each_ = std::max(
      {std::min(goal_ / window_.size(), most_of_one), fewest_tries / window_.size(), std::size_t{1}});
}

/// A map costs about as much as trying a few places for each sphere in it. It holds for the size class in
/// the window; where it lags behind the grid, it only lets more places through.
void Packing::renew_map() {
  const double least = size_class * diameters_[window_.front()];
  if (least < map_least_) map_.reset(), refused_ = 0;
  map_least_ = least;
  if (!map_ && refused_ > 3 * grid_.size()) {
    map_.emplace(places_.low(), places_.high(), 0.5 * least);
    in_map_ = 0;
  }
  if (!map_ || grid_.size() - in_map_ <= grid_.size() / 32) return;
  map_->add(grid_, in_map_, around_.threads);
  in_map_ = grid_.size();
}

std::uint32_t Packing::block_of(const Vec3& centre) const {
  std::size_t index = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const double at = (centre[axis] - places_.low()[axis]) * blocks_per_metre_[axis];
    index = index * blocks_[axis] +
            static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(blocks_[axis]) - 1.0));
  }
  return static_cast<std::uint32_t>(index);
}

void Packing::find_places() {
  std::vector<std::vector<Try>> found(static_cast<std::size_t>(around_.threads));
  parallel_shares(window_.size() * each_, around_.threads,
                  [&](std::size_t begin, std::size_t end, int thread) {
                    for (const Try& t : tries_along_space(begin, end))
                      if (!(map_ && map_->filled(t.centre)) && !grid_.overlaps(t.centre, t.radius) &&
                          around_.clear(t.centre, t.radius))
                        found[static_cast<std::size_t>(thread)].push_back(t);
                  });
  free_.clear();
  for (const auto& share : found) free_.insert(free_.end(), share.begin(), share.end());
  std::sort(free_.begin(), free_.end(), [](const Try& a, const Try& b) {
    return std::tie(a.turn, a.block, a.sphere) < std::tie(b.turn, b.block, b.sphere);
  });
}

/// A share of the tries, along space: what lies there is then in the cache already.
std::vector<Packing::Try> Packing::tries_along_space(std::size_t begin, std::size_t end) const {
  std::vector<Try> drawn;
  drawn.reserve(end - begin);
  std::vector<std::uint32_t> start(blocks_[0] * blocks_[1] * blocks_[2] + 1, 0);
  for (std::size_t t = begin; t < end; ++t) {
    const std::uint32_t k = window_[t / each_];
    const auto turn = static_cast<std::uint32_t>(t % each_);
    const double radius = 0.5 * diameters_[k];
    const auto centre = places_.at(radius, dice_(first_number_ + k, 1 + tried_[k] + turn));
    if (!centre) continue;
    drawn.push_back({*centre, radius, turn, block_of(*centre), k});
    ++start[drawn.back().block + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Try> sorted(drawn.size());
  for (const Try& t : drawn) sorted[start[t.block]++] = t;
  return sorted;
}

/// Returns how many found a place.
std::size_t Packing::take_places() {
  const std::size_t before = placed_, round = grid_.size();  // earlier ones, the tries were held against
  for (const Try& t : free_) {
    if (has_place_[t.sphere] || grid_.overlaps(t.centre, t.radius, round)) continue;
    grid_.add(t.centre, t.radius);
    centre_[t.sphere] = t.centre;
    has_place_[t.sphere] = true;
    solid_ += sphere_volume(t.radius);
    ++placed_;
  }
  for (const std::uint32_t k : window_) tried_[k] += static_cast<std::uint32_t>(each_);
  std::erase_if(window_, [&](std::uint32_t k) { return has_place_[k]; });
  return placed_ - before;
}

}  // namespace pulvis
