// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/math/region.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"
#include "engine/parcels/size_sampler.hpp"

namespace pulvis {

/// Square openings on a square lattice across the face of a region, one of them in the middle.
struct Sieve {
  double pitch = 0.0, opening = 0.0;  ///< m: from middle to middle, and edge of an opening
};

/// Where parcels come from. Sizes are those of parcels (already coarse-grained). SI.
struct SourceModel {
  enum class Kind { pack, rain, list };
  std::string name;
  Kind kind = Kind::pack;
  std::uint32_t species = 0;
  double density = 0.0;  ///< kg/m^3
  std::optional<SizeSampler> sizes;
  Region region;      ///< whole spheres appear inside it
  Vec3 velocity;      ///< m/s
  double rate = 0.0;  ///< kg/s; rain
  /// Whole spheres appear over one of its openings only. It lies across `fall_axis` of a box, and across the
  /// axis of a cylinder.
  std::optional<Sieve> sieve;
  std::optional<std::uint64_t> target_count;
  std::optional<double> target_mass;  ///< kg, met to within half the smallest parcel
  std::vector<Parcel> list;           ///< kind list: the parcels themselves
};

struct SourceState {
  bool open = false;
  bool done = false;
  std::uint64_t opened = 0;      ///< step
  double mass_at_opening = 0.0;  ///< kg
  std::uint64_t count = 0;       ///< parcels given so far; also the number of the next one
  double mass = 0.0;             ///< kg given so far
};

/// Whether a sphere (centre, radius) touches no wall where the walls stand now. Several threads may ask.
using ClearOfWalls = std::function<bool(const Vec3&, double)>;
inline bool nothing_in_the_way(const Vec3&, double) { return true; }

/// The axis along which a velocity points most; z if there is none.
int fall_axis(const Vec3& velocity);

/// Parcels a source gives at this step in order of their numbers, none if none is due. `state` is updated.
/// Positions, sizes and attempts are drawn from counters (seed, source, number of the parcel): neither the
/// number of threads nor the order of `present` changes a bit. The large parcels of a pack are placed first.
/// Throws Failure(bad_case) if a pack does not fit, saying how full the region is and what would fit, or if a
/// parcel is wider than the region or the openings of its sieve.
std::vector<Parcel> draw_parcels(const SourceModel& model, SourceState& state, std::uint64_t seed,
                                 std::uint32_t stream, std::uint64_t step, double dt, const Parcels& present,
                                 const Box& domain, const ClearOfWalls& clear = nothing_in_the_way,
                                 int threads = 1);

/// Steps between two looks at a rain.
std::uint64_t rain_interval(const SourceModel& model, double dt);

/// Whether a source may give parcels at a step.
bool is_due(const SourceModel& model, const SourceState& state, std::uint64_t step, double dt);

}  // namespace pulvis
