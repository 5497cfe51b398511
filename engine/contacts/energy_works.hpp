// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "engine/contacts/contact_classes.hpp"
#include "engine/contacts/near_pairs.hpp"
#include "engine/contacts/near_walls.hpp"
#include "engine/kernels/energy_block.hpp"
#include "engine/math/exact_sum.hpp"

namespace pulvis {

/// Where everything is that the energy of contacts depends on, at the end of a step.
struct ContactView {
  const NearPairs& near_pairs;
  const NearWalls& near_walls;
  const Parcels& parcels;
  const Walls& walls;
  std::span<const Pose> poses;       ///< of the step that ended
  std::span<const Pose> next_poses;  ///< of the step that comes
  const ContactClasses& classes;
  NearestImage nearest;
  double dt;
  int threads;
};

/// Energy that contacts store, lose and bring in, step by step: looks at each contact once more after the step, from
/// what it was before. Sums are exact, so the same for any order and any number of threads.
class EnergyWorks {
 public:
  EnergyWorks(const ContactClasses& classes, int most_threads, SumGrid grid);

  bool splits_contacts() const;

  /// To be called when the lists are those of the step, before contacts are evaluated.
  void before_contacts(const NearPairs& pairs, const NearWalls& walls);
  /// To be called before the second half kick: velocities are those of the middle of the step.
  void before_kick(const Parcels& parcels) { middle_ = parcels.body; }
  /// What the contacts of the step did.
  kernels::EnergySums after_step(const ContactView& view);
  /// What all contacts store now, J; those of laws that state no energy nothing.
  double stored(const ContactView& view);

 private:
  struct Scratch {
    std::vector<kernels::EnergyBlock> block;  ///< one per contact class
    kernels::EnergySums sums;
    std::vector<std::uint32_t> source;  ///< of one parcel's slots: where what each remembered stood
  };
  void pairs(const ContactView& view, std::size_t from, std::size_t to, Scratch& scratch) const;
  void walls(const ContactView& view, std::uint32_t parcel, Scratch& scratch) const;
  void stage_pair(const ContactView& view, std::size_t slot, kernels::EnergyBlock& b) const;
  void stage_wall(const ContactView& view, std::uint32_t slot, std::uint32_t source,
                  kernels::EnergyBlock& b) const;
  void find_sources(const ContactView& view, std::uint32_t begin, std::uint32_t end, Scratch& scratch) const;
  void flush(const ContactView& view, std::size_t contact_class, bool walls, Scratch& scratch) const;

  std::vector<kernels::EnergyKernel> kernel_;
  SumGrid grid_;
  std::vector<Scratch> scratch_;
  std::vector<Parcel> middle_;
  Pasts pasts_;
  std::vector<std::uint8_t> touching_, wall_touching_;
  std::vector<laws::History> wall_history_;
  Memories wall_memory_;
  bool ends_all_ = false;  ///< as if every contact ended now: see `stored`
};

}  // namespace pulvis
