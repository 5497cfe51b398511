// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/insertion/overlap_grid.hpp"
#include "engine/insertion/source.hpp"

// What packs and rains share; only this room includes it.
namespace pulvis {

/// Random numbers of one source: each parcel has its own, by its number.
struct Dice {
  std::uint64_t seed;
  std::uint32_t stream;
  std::array<double, 3> operator()(std::uint64_t number, std::uint32_t draw) const {
    return uniform_triple(seed, stream, number, draw);
  }
};

/// What is there already, and how many threads may look at it.
struct Surroundings {
  const Parcels& present;
  const Box& domain;
  const ClearOfWalls& clear;
  int threads;
};

/// Where whole spheres can lie in the region of a source, under its sieve if it has one.
class Places {
 public:
  explicit Places(const SourceModel& model);

  /// The centre that three random numbers stand for. Nothing if that is no place: under a sieve, one that
  /// reaches across the rim of the region.
  std::optional<Vec3> at(double radius, const std::array<double, 3>& drawn) const;

  const Vec3& low() const { return low_; }  ///< m; corners of a box around the region
  const Vec3& high() const { return high_; }

 private:
  std::optional<Vec3> under_sieve(double radius, const std::array<double, 3>& drawn) const;

  Region region_;
  std::optional<Sieve> sieve_;
  Vec3 low_, high_;
  // Of a region under a sieve: along the fall, and the two directions of the lattice.
  Vec3 middle_, along_, across_[2];
  double height_ = 0.0, width_[2] = {0, 0};  ///< m
};

/// kg.
double mass_of(const SourceModel& model, double diameter);

/// Diameter of the next parcel, or 0 if the target is met. A mass is met to within half the smallest parcel:
/// near the end parcels that are too heavy are drawn again, and after many draws the smallest fill the rest.
double next_diameter(const SourceModel& model, const SourceState& state, const Dice& dice);

/// The parcels present that reach into the region of `places`, with room for `fresh` more of the source's.
OverlapGrid grid_of_present(const SourceModel& model, const Places& places, const Surroundings& around,
                            std::size_t fresh);

/// A parcel of the source at this place; its id is given later.
Parcel parcel_at(const SourceModel& model, const Vec3& centre, double diameter);

std::vector<Parcel> draw_pack(const SourceModel& model, SourceState& state, const Dice& dice,
                              const Surroundings& around);
/// Of a domain that is periodic all around and in which nothing is: parcels throughout, dense but without order.
std::vector<Parcel> draw_dense(const SourceModel& model, SourceState& state, const Dice& dice,
                               const Surroundings& around);
/// A rain looks for room at some steps only.
bool rain_looks_at(const SourceModel& model, const SourceState& state, std::uint64_t step, double dt);
std::vector<Parcel> draw_rain(const SourceModel& model, SourceState& state, const Dice& dice,
                              std::uint64_t step, double dt, const Surroundings& around);

}  // namespace pulvis
