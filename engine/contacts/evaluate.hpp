// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "engine/contacts/contact_classes.hpp"
#include "engine/contacts/near_pairs.hpp"
#include "engine/contacts/near_walls.hpp"
#include "engine/contacts/wall_sight.hpp"
#include "engine/kernels/parcel_block.hpp"

namespace pulvis {

/// A parcel whose centre passed through a surface during a step.
struct Crossing {
  std::uint32_t parcel;  ///< index in the store
  std::uint32_t surface;
};

/// Evaluates all contacts of a step in blocks of one contact class each: near pairs where their slots stand,
/// contacts with walls after they were staged. Which block a contact shares changes nothing: each result depends
/// on its own contact alone.
class ContactEvaluator {
 public:
  /// `approach` is the widest gap at which a contact can begin, m.
  ContactEvaluator(int most_threads, std::size_t classes, double approach);

  /// The block of near pairs of a group that begins with slot `begin`. Parts of the work that go on at once have each
  /// their own number `part`.
  void block(NearPairs& near, const Parcels& parcels, const ContactClass& contact, std::size_t group,
             std::size_t begin, const Images& images, double dt, int part);
  /// What pairs do to some parcels, but for those apart; and what all near pairs do to one.
  void sum_close(const NearPairs& near, const kernels::SomeParcels& some, Load* sum) const {
    parcel_kernel_.sum_of_pairs({near.load.data(), near.begin.data(), near.summand.data()}, some, sum);
  }
  static Load sum_all(const NearPairs& near, std::size_t parcel);
  /// Takes parcels from the end of one step to the middle of the next.
  kernels::MoveParcels move() const { return parcel_kernel_.move; }
  /// How far a part of the work is in the slots of each group: for whoever leads it.
  std::vector<std::size_t>& cursors(int part) { return scratch_[static_cast<std::size_t>(part)].cursors; }
  /// Fills `crossings`, ascending in the parcel's index.
  void walls(NearWalls& near, const Parcels& parcels, const Walls& walls, std::span<const Pose> poses,
             const ContactClasses& classes, double dt, int threads, std::vector<Crossing>& crossings);

 private:
  struct Scratch {
    kernels::ContactBlock pairs;
    std::vector<kernels::SeparateBlock> block;  ///< of walls, one per contact class
    std::vector<std::size_t> cursors;
    std::vector<Crossing> crossings;
    std::vector<WallSight> sights;     ///< of one parcel, per slot
    std::vector<std::uint32_t> owner;  ///< of one parcel, per slot: see settle_edges
  };
  void settle_edges(NearWalls& near, std::uint32_t parcel, const Parcel& p, const Walls& walls,
                    std::span<const Pose> poses, Scratch& scratch) const;

  std::vector<Scratch> scratch_;
  kernels::ParcelKernel parcel_kernel_;
  double approach_ = 0.0;
};

}  // namespace pulvis
