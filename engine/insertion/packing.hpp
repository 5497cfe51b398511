// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "engine/insertion/drawing.hpp"
#include "engine/insertion/filled_map.hpp"

namespace pulvis {

/// Finds places for all spheres of a pack, in rounds. In each, the largest spheres that have no place draw
/// some, which are held against what lies there, in parallel; then those that are free are taken one after
/// the other, unless one taken in the same round is in the way: the first try of each sphere, then the second,
/// and so on, each along space. Nothing of this depends on the number of threads.
class Packing {
 public:
  /// Places for spheres of these diameters, numbered from `first_number` on.
  Packing(const SourceModel& model, const Dice& dice, const Surroundings& around, std::uint64_t first_number,
          const std::vector<double>& diameters);

  /// False if no place was found for one of them in `hopeless` tries in a row.
  bool place_all();
  static constexpr std::uint64_t hopeless = 500000;

  std::size_t placed() const { return placed_; }
  double solid() const { return solid_; }  ///< m^3 placed
  const Places& places() const { return places_; }
  const Vec3& centre(std::size_t k) const { return centre_[k]; }

 private:
  /// A place that a sphere of the window tries in this round.
  struct Try {
    Vec3 centre;
    double radius;
    std::uint32_t turn, block, sphere;  ///< turn: which of the sphere's tries in this round
  };

  void sort_by_size();
  void fill_window();
  void renew_map();
  std::uint32_t block_of(const Vec3& centre) const;
  void find_places();
  std::vector<Try> tries_along_space(std::size_t begin, std::size_t end) const;
  std::size_t take_places();

  const Dice& dice_;
  const Surroundings& around_;
  std::uint64_t first_number_;
  const std::vector<double>& diameters_;
  Places places_;
  OverlapGrid grid_;
  std::vector<std::uint32_t> rank_, tried_, window_;  ///< spheres: largest first; tries of each; in turn
  std::size_t next_ = 0;                              ///< first rank that was never in the window
  std::size_t goal_ = 0;                              ///< tries in this round
  std::size_t each_ = 0;                              ///< of each sphere of the window
  std::vector<Try> free_;                             ///< places found in this round
  std::vector<Vec3> centre_;
  std::vector<bool> has_place_;
  std::size_t placed_ = 0;
  double solid_ = 0.0;

  std::size_t blocks_[3];  ///< along each axis
  Vec3 blocks_per_metre_;

  std::optional<FilledMap> map_;
  double map_least_ = 1e300;   ///< m; diameter it is or would be made for
  std::size_t in_map_ = 0;     ///< spheres of the grid
  std::uint64_t refused_ = 0;  ///< places of this size class
};

}  // namespace pulvis
