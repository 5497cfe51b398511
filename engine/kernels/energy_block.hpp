// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "engine/kernels/contact_block.hpp"
#include "engine/math/exact_sum.hpp"

namespace pulvis::kernels {

/// What the ledger of energy takes of a contact in a step, J. NOTATION.md, "Energy ledger", says how each is reckoned.
enum class EnergyTerm {
  // Stored at the end of the step.
  elastic,
  cohesive,
  sliding_spring,
  rolling_spring,
  twisting_spring,
  // Lost: work taken by forces over the whole kick at the end of the step.
  normal_dashpot,
  tangential_dashpot,
  rolling_dashpot,
  twisting_dashpot,
  liquid,
  unsplit_normal,
  unsplit_cohesion,
  unsplit_friction,  ///< of laws of sliding and rolling without a spring
  // Brought in, by the same sum.
  walls,
  // Lost in the step.
  sliding,
  rolling,
  twisting,
  touch,
  separation,
  forgotten_springs,
  // Brought in in the step.
  sliding_stiffness,
  rolling_stiffness,
  changed_contacts,
  count
};
inline constexpr std::size_t energy_terms = static_cast<std::size_t>(EnergyTerm::count);

/// Contacts of one pair of species, as the ledger of energy sees them after a step: their state before it and after it,
/// and the velocities in its middle and at its end.
struct EnergyBlock {
  int count = 0;

  // Gathered for pairs; walls are staged with what `geometry` makes of it.
  Vec3 period;
  Lanes3 offset;                   ///< x_second - x_first, of any image, end of step
  Lanes3 linear, end_linear;       ///< v_first - v_second, mid-step and end
  Lanes3 spin_first, spin_second;  ///< mid-step
  Lanes3 end_spin_first, end_spin_second;
  alignas(64) Lane radius_first, radius_second, mass_first, mass_second;

  Lanes3 normal, half_normal;
  Lanes3 velocity, end_velocity;  ///< of the first against the second at the contact, mid-step and end
  Lanes3 spin, end_spin;          ///< relative
  alignas(64) Lane overlap, overlap_before, radius, mass, shared_spin;

  alignas(64) Lane touching_before, touching;
  Springs before;
  MemoryLanes memory_before;

  // From part to part of a law.
  alignas(64) Lane size, size_before, elastic, damping_size, limit_shift;
  Lanes3 slip;
  alignas(64) Lane closing, limiting_force, tangential_damping;

  alignas(64) double term[energy_terms][block_size];
};

/// Exact sums over contacts, in any order.
class EnergySums {
 public:
  void add(const EnergySums& other) {
    for (std::size_t t = 0; t < energy_terms; ++t) of[t] += other.of[t];
  }
  std::array<Quanta, energy_terms> of{};
};

/// What a law's contacts store, lose and gain, as stages like those of ContactKernel.
class EnergyKernel {
 public:
  using Stage = void (*)(EnergyBlock& block, const double* pair_constants, double dt);
  using Sum = void (*)(const EnergyBlock& block, std::uint32_t terms, const SumGrid& grid, EnergySums& sums);

  void append(Stage stage) { law[law_stages++] = stage; }
  void use(EnergyTerm term) { terms |= 1u << static_cast<unsigned>(term); }

  void pairs(EnergyBlock& block, const double* pair_constants, double dt, const SumGrid& grid,
             EnergySums& sums) const {
    geometry(block, pair_constants, dt);
    evaluate(block, pair_constants, dt, grid, sums);
  }
  void walls(EnergyBlock& block, const double* pair_constants, double dt, const SumGrid& grid,
             EnergySums& sums) const {
    evaluate(block, pair_constants, dt, grid, sums);
    sum(block, 1u << static_cast<unsigned>(EnergyTerm::walls), grid, sums);
  }

  /// Whether the law states what its contacts store: else the work of some of its forces is one line.
  bool splits_contacts() const {
    const auto has = [&](EnergyTerm t) { return (terms >> static_cast<unsigned>(t) & 1u) != 0; };
    return !has(EnergyTerm::unsplit_normal) && !has(EnergyTerm::unsplit_cohesion);
  }

  Stage geometry = nullptr;
  Sum sum = nullptr;

 private:
  void evaluate(EnergyBlock& block, const double* pair_constants, double dt, const SumGrid& grid,
                EnergySums& sums) const {
    for (int k = 0; k < law_stages; ++k) law[k](block, pair_constants, dt);
    sum(block, terms, grid, sums);
  }

  Stage law[8] = {};
  int law_stages = 0;
  std::uint32_t terms = 0;  ///< which the law has
};

/// Energy kernel of a law. `set` must be one the processor has; all give the same bits.
EnergyKernel energy_kernel(const laws::Law& law, InstructionSet set);

}  // namespace pulvis::kernels
