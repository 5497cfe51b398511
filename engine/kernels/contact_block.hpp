// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>

#include "engine/laws/catalogue.hpp"

namespace pulvis::kernels {

inline constexpr int block_size = 64;  // 64 contacts x about 59 numbers: 30 KiB, stays in the inner caches

using Lane = double[block_size];
struct Lanes3 {
  alignas(64) Lane x;
  alignas(64) Lane y;
  alignas(64) Lane z;
};

/// Contacts of one pair of species, side by side, so that a law is evaluated on many at once. Staged by
/// plain loads; the results go back to each contact's own slot. SI; symbols as in laws::Touch.
struct ContactBlock {
  int count = 0;
  std::uint32_t slot[block_size];

  // Staged for parcels: the kernel derives what stands under "staged for walls" from these.
  Lanes3 offset;    ///< x_second - x_first (nearest image), end of step
  Lanes3 velocity;  ///< v_first - v_second, mid-step; walls: v_first - v_wall at the contact
  alignas(64) Lane radius_first, radius_second, mass_first, mass_second;

  // Staged for walls, derived for parcels.
  Lanes3 normal, half_normal;
  alignas(64) Lane overlap, radius, mass;            ///< delta, R*, m*
  alignas(64) Lane arm_first, arm_second;            ///< from the centre to the contact; wall: 0
  alignas(64) Lane half_arm_first, half_arm_second;  ///< the same in the middle of the step

  Lanes3 spin_first, spin_second;  ///< mid-step
  alignas(64) Lane touching;       ///< in: before this step; out: now
  Lanes3 slide, roll;              ///< history, in and out
  /// Memory, in and out, for laws that remember; zeros or anything for others.
  alignas(64) Lane plastic, adhesion, grip;

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

/// A law as stages, each a loop over the block, in the order of laws/contact_law.hpp. One set of stages for each
/// part, so code grows with the sum of the parts; stages that a law does without are null.
class ContactKernel {
 public:
  using Stage = void (*)(ContactBlock& block, const double* pair_constants, double dt);

  /// Contacts of parcels.
  void parcels(ContactBlock& block, const double* pair_constants, double dt) const {
    geometry(block, pair_constants, dt);
    for (int k = 0; k < law_stages; ++k) law[k](block, pair_constants, dt);
  }
  /// Contacts of parcels with walls, staged with their geometry.
  void walls(ContactBlock& block, const double* pair_constants, double dt) const {
    if (wall_sizes) wall_sizes(block, pair_constants, dt);
    for (int k = 0; k < law_stages; ++k) law[k](block, pair_constants, dt);
  }
  void append(Stage stage) { law[law_stages++] = stage; }

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
