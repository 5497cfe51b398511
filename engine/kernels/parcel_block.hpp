// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>

#include "engine/kernels/contact_block.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis::kernels {

/// Where the loads of one parcel's contacts lie, in the order they are added in.
struct Run {
  std::uint32_t begin, count;
};
/// Loads of contacts, and the run of each parcel.
struct LoadsOfPairs {
  const Load* load;
  const Run* run;
};

// Kernels read these whole and take them apart in lanes.
static_assert(sizeof(Parcel) == 12 * sizeof(double) && offsetof(Parcel, radius) == 3 * sizeof(double) &&
              offsetof(Parcel, velocity) == 4 * sizeof(double) &&
              offsetof(Parcel, mass) == 7 * sizeof(double) && offsetof(Parcel, spin) == 8 * sizeof(double) &&
              offsetof(Parcel, id) == 11 * sizeof(double));
static_assert(sizeof(Load) == 6 * sizeof(double) && offsetof(Load, torque) == 3 * sizeof(double));

/// Up to block_size parcels of the store: `count` from `first` on, or, where there is a `list`, those it names.
struct SomeParcels {
  std::size_t count;
  std::size_t first;
  const std::uint32_t* list = nullptr;  ///< ascending
  PULVIS_INLINE std::size_t operator[](std::size_t k) const { return list ? list[k] : first + k; }
};

/// Sums what pairs do to each of these parcels.
using SumOfPairs = void (*)(const LoadsOfPairs& pairs, const SomeParcels& some, Load* sum);

/// What the first half of a step noticed.
struct StepNotice {
  bool outside = false;   ///< a position is outside the box, or it or a spin is not a finite number
  bool too_fast = false;  ///< a parcel moved more than half its radius in one step
  bool wrapped = false;   ///< a parcel came back at the other end of a periodic axis
  /// All that left the margins the lists were made for stand in [left_from, left_to) of the store.
  std::size_t left_from = SIZE_MAX, left_to = 0;

  PULVIS_INLINE bool any_left() const { return left_from < left_to; }
  PULVIS_INLINE void forget_left() { left_from = SIZE_MAX, left_to = 0; }
  PULVIS_INLINE void note_left(std::size_t from, std::size_t to) {
    left_from = from < left_from ? from : left_from;
    left_to = to > left_to ? to : left_to;
  }
};

/// Most of the powder moves in one or two crowds, a bed and the rain on it: what a crowd does together brings none of it
/// nearer to another, and margins do not count it.
inline constexpr int crowds = 2;
/// A vector for each.
struct OfCrowds {
  Vec3 of[crowds];
  PULVIS_INLINE Vec3& operator[](std::size_t crowd) { return of[crowd]; }
  PULVIS_INLINE const Vec3& operator[](std::size_t crowd) const { return of[crowd]; }
};

using Drift = OfCrowds;  ///< m

/// What tells whether near lists are still good for each parcel.
struct Leeway {
  Vec3* reference;            ///< m, where it was when it was listed, less what its crowd had drifted then
  const double* margin;       ///< m, how far it may be from there and its crowd's drift
  const std::uint8_t* crowd;  ///< 0 or 1
};

/// What takes parcels from the end of one step to the middle of the next where nothing turns and nothing is sheared.
struct PlainStep {
  Vec3 low, high;    ///< m, of the domain
  bool periodic[3];  ///< axes
  Vec3 gravity;      ///< m/s^2
  double dt;         ///< s
  Drift drift;       ///< since lists were made
};

/// The second half of one step and the first half of the next, as finish and begin_one in engine/dynamics/integrate.cpp
/// make them for one parcel. `load`: of these parcels, what acts on them but for gravity. The other arrays are those of
/// all parcels.
using MoveParcels = void (*)(const PlainStep& step, const SomeParcels& some, const Load* load,
                             Parcel* parcels, const Leeway& leeway, StepNotice& notice);

struct ParcelKernel {
  SumOfPairs sum_of_pairs;
  MoveParcels move;
};
ParcelKernel parcel_kernel(InstructionSet set);

}  // namespace pulvis::kernels
