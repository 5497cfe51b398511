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

/// What a range of pairs of one contact class is evaluated with. Parts of the work that go on at once have each their own
/// number `part`.
struct StepOfPairs {
  const Parcels& parcels;
  const ContactClass& contact;
  const Images& images;
  double dt;  ///< s
  int part;
};

/// Pairs apart that meet, brought together from their blocks.
struct Meeting {
  kernels::SeparateBlock block;
  std::uint32_t first[kernels::block_size], second[kernels::block_size];  ///< parcels
  std::uint8_t touching[kernels::block_size];
};

/// Evaluates all contacts of a step in blocks of one contact class each: close pairs where their slots
/// stand; pairs apart that meet, and contacts with walls, after they were brought together. Which block a contact shares changes nothing: each result depends
/// on its own contact alone.
class ContactEvaluator {
 public:
  /// `approach` is the widest gap at which a contact can begin, m.
  ContactEvaluator(int most_threads, std::size_t classes, double approach);

  // The slots [from, to) of one group, which are whole blocks.
  /// Close pairs, where they stand.
  void pairs_close(NearPairs& near, std::size_t from, std::size_t to, const StepOfPairs& step);
  /// Those of pairs apart that meet, brought together.
  void pairs_apart(NearPairs& near, std::size_t from, std::size_t to, const StepOfPairs& step);
  /// Those of pairs that were listed late, which can be of any class; those that belong to the part.
  void pairs_late(NearPairs& near, const ContactClasses& classes, const StepOfPairs& step);
  /// What pairs do to some parcels, but for those apart; and what all near pairs do to one.
  void sum_close(const NearPairs& near, const kernels::SomeParcels& some, Load* sum) const {
    parcel_kernel_.sum_of_pairs({near.load.data(), near.runs.data()}, some, sum);
  }
  static Load sum_all(NearPairs& near, const Parcels& parcels, std::uint32_t parcel);
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
    Meeting meeting;
    std::vector<kernels::SeparateBlock> block;  ///< of walls, one per contact class
    std::vector<std::size_t> cursors;
    std::vector<Crossing> crossings;
    std::vector<WallSight> sights;     ///< of one parcel, per slot
    std::vector<std::uint32_t> owner;  ///< of one parcel, per slot: see settle_edges
  };
  Meeting& meeting(const StepOfPairs& step);
  template <class Found>
  void glance(const NearPairs& near, std::size_t begin, int count, const StepOfPairs& step,
              Found&& found) const;
  void settle_edges(NearWalls& near, std::uint32_t parcel, const Parcel& p, const Walls& walls,
                    std::span<const Pose> poses, Scratch& scratch) const;

  std::vector<Scratch> scratch_;
  kernels::ParcelKernel parcel_kernel_;
  double approach_ = 0.0;
};

}  // namespace pulvis
