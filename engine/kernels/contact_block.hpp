// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>

#include "engine/laws/catalogue.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis::kernels {

inline constexpr int block_size = 32;  // 32 contacts x about 65 numbers: 17 KiB, half of a small first cache

using Lane = double[block_size];
struct Lanes3 {
  alignas(64) Lane x;
  alignas(64) Lane y;
  alignas(64) Lane z;
};

/// Asks memory for a thing that is needed soon, where the processor cannot foresee it.
template <class Thing>
[[gnu::always_inline]] inline void ask_for(const Thing& thing) {
  const char* const begin = reinterpret_cast<const char*>(&thing);
#pragma GCC unroll 32
  for (std::size_t at = 0; at < sizeof thing; at += 64) __builtin_prefetch(begin + at);
}

/// One contact's vector, from its lanes and into them.
PULVIS_INLINE Vec3 load(const Lanes3& lanes, int k) { return {lanes.x[k], lanes.y[k], lanes.z[k]}; }
PULVIS_INLINE void store(Lanes3& lanes, int k, const Vec3& value) {
  lanes.x[k] = value.x;
  lanes.y[k] = value.y;
  lanes.z[k] = value.z;
}

/// What the contacts of a block remember; kept from step to step where the kernels use it.
struct Springs {
  Lanes3 slide, roll;
};
/// What they remember besides, for laws that ask for it.
struct MemoryLanes {
  alignas(64) Lane plastic, adhesion, grip;
};

/// What one contact remembers; `memory` is null where laws have none.
PULVIS_INLINE laws::Past past_of(const Springs& springs, const MemoryLanes* memory, int k) {
  laws::Past past{load(springs.slide, k), load(springs.roll, k)};
  if (memory)
    past.plastic = memory->plastic[k], past.adhesion = memory->adhesion[k], past.grip = memory->grip[k];
  return past;
}
PULVIS_INLINE void put_past(Springs& springs, MemoryLanes* memory, int k, const laws::Past& past) {
  store(springs.slide, k, past.slide);
  store(springs.roll, k, past.roll);
  if (memory)
    memory->plastic[k] = past.plastic, memory->adhesion[k] = past.adhesion, memory->grip[k] = past.grip;
}

/// Contacts of one pair of species, side by side, so that a law is evaluated on many at once. SI; symbols as in
/// laws::Touch.
struct ContactBlock {
  int count = 0;
  std::uint32_t slot[block_size];  ///< only of contacts brought together from several blocks, and with walls

  Springs* springs = nullptr;     ///< in and out
  MemoryLanes* memory = nullptr;  ///< in and out; null for laws that have none

  // Gathered for parcels: the kernel derives what stands under "staged for walls" from these.
  Vec3 period;      ///< m, of the domain's periodic axes, 0 along the others
  Slide slide;      ///< of a sheared domain: see ContactKernel::images
  Lanes3 offset;    ///< x_second - x_first, of any image, end of step
  Lanes3 velocity;  ///< v_first - v_second, mid-step; walls: v_first - v_wall at the contact
  alignas(64) Lane radius_first, radius_second, mass_first, mass_second;

  // Staged for walls, derived for parcels.
  Lanes3 normal, half_normal;
  alignas(64) Lane overlap, radius, mass;            ///< delta, R*, m*
  alignas(64) Lane arm_first, arm_second;            ///< from the centre to the contact; wall: 0
  alignas(64) Lane half_arm_first, half_arm_second;  ///< the same in the middle of the step

  Lanes3 spin_first, spin_second;  ///< mid-step
  alignas(64) Lane touching;       ///< in: before this step; out: now

  // Between the stages of a law, see laws/contact_law.hpp.
  alignas(64) Lane in_reach;                                          ///< from the reach of cohesion
  alignas(64) Lane contact_size, elastic, damping_size, limit_shift;  ///< from the normal law
  Lanes3 slip;  ///< from the dashpots, as in the next line
  alignas(64) Lane closing, shared_spin, normal_force, limiting_force, tangential_damping;
  alignas(64) Lane drag;  ///< from cohesion, kg/s

  // Results.
  Lanes3 force;                        ///< on the first
  Lanes3 torque_first, torque_second;  ///< about the centres
};

/// A block with springs and memory of its own.
struct SeparateBlock : ContactBlock {
  SeparateBlock() : ContactBlock(), own_springs(), own_memory() {
    springs = &own_springs, memory = &own_memory;
  }
  SeparateBlock(const SeparateBlock& other)
      : ContactBlock(other), own_springs(other.own_springs), own_memory(other.own_memory) {
    springs = &own_springs, memory = &own_memory;
  }
  SeparateBlock& operator=(const SeparateBlock&) = delete;

  Springs own_springs;
  MemoryLanes own_memory;
};

/// Up to block_size near pairs.
struct SomePairs {
  int count;
  const std::uint32_t *first, *second;  ///< indices of parcels
  const std::uint8_t* touching;         ///< before this step
  int ahead;  ///< memory is asked for the parcels of so many more that stand behind a whole block
};

/// Where what a pair does to its two parcels lies among the loads, by the first of its numbers: to make that of the number of
/// a load takes as many instructions as to write it.
struct Places {
  static constexpr std::uint32_t numbers = sizeof(Load) / sizeof(double);  ///< of a load
  std::uint32_t first, second;
};

/// A law as stages, each a loop over the block, in the order of laws/contact_law.hpp. One set of stages for each
/// part, so code grows with the sum of the parts; stages that a law does without are null.
class ContactKernel {
 public:
  using Stage = void (*)(ContactBlock& block, const double* pair_constants, double dt);

  /// Fills a block with pairs, but for what they remember.
  using Gather = void (*)(ContactBlock& block, const Parcel* parcels, const SomePairs& pairs);
  /// Whether any contact of the block exists or is nearer than `approach` (m).
  using Look = bool (*)(const ContactBlock& block, double approach);
  /// Finds those of the pairs that exist or are nearer than `approach` (m), up to rounding: writes their numbers from 0
  /// on to `met`, ascending, and returns how many. Looks at places and radii alone.
  using Glance = int (*)(const SomePairs& pairs, const Parcel* parcels, const Images& images, double approach,
                         std::uint8_t* met);
  /// Brings the results to each contact's places among the loads, whether it touches to touching[k], and the force on its
  /// first to force[k] unless that is null.
  using Scatter = void (*)(const ContactBlock& block, const Places* places, Load* load,
                           std::uint8_t* touching, Vec3* force);

  /// Contacts of parcels, gathered.
  void parcels(ContactBlock& block, const double* pair_constants, double dt) const {
    geometry(block, pair_constants, dt);
    evaluate(block, pair_constants, dt);
  }
  /// The law alone, where the geometry is known.
  void evaluate(ContactBlock& block, const double* pair_constants, double dt) const {
    for (int k = 0; k < law_stages; ++k) law[k](block, pair_constants, dt);
  }
  /// Contacts of parcels with walls, staged with their geometry.
  void walls(ContactBlock& block, const double* pair_constants, double dt) const {
    if (wall_sizes) wall_sizes(block, pair_constants, dt);
    evaluate(block, pair_constants, dt);
  }
  void append(Stage stage) { law[law_stages++] = stage; }

  Gather gather = nullptr;
  Look any_in_reach = nullptr;
  Glance glance = nullptr;
  Scatter scatter = nullptr;
  /// Of a sheared domain, before the geometry: offset and velocity of the image nearest along the gradient axis.
  Stage images = nullptr;
  Stage geometry = nullptr, wall_sizes = nullptr;

 private:
  Stage law[8] = {};
  int law_stages = 0;
};

/// Instruction sets the kernels are compiled for.
enum class InstructionSet { baseline, avx2, avx512 };

/// The best this processor has, or what PULVIS_INSTRUCTION_SET (baseline, avx2, avx512) asks for if that is
/// less. All give the same bits.
InstructionSet instruction_set();
const char* name_of(InstructionSet);

/// Kernel of a law. `set` must be one the processor has.
ContactKernel contact_kernel(const laws::Law& law, InstructionSet set);

}  // namespace pulvis::kernels
