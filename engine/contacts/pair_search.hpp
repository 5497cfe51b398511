// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/contacts/contact_classes.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

/// Two parcels that are near, by their indices in the store.
struct FoundPair {
  std::uint32_t first, second;
  std::uint32_t group;  ///< their contact class, and all classes more if they are apart: see NearPairs
};

/// Who is looked for: parcels, which of them are near, and where their images are.
struct PairSearch {
  const Parcels& parcels;
  const ContactClasses& classes;
  std::span<const double> margin;  ///< m, per parcel
  double reach;                    ///< m, of contacts that hold beyond touching
  const Box& box;
  const Slide& slide;
  std::span<const std::uint8_t> crowd{};  ///< per parcel, 0 or 1; none where there is one crowd
  double between_crowds = 0.0;  ///< m, by which crowds may come nearer besides; 0: all are of the first

  std::uint8_t crowd_of(std::size_t parcel) const { return crowd.empty() ? std::uint8_t{0} : crowd[parcel]; }
};

/// All pairs whose gap is below both margins and the reach, and between crowds that more, each once, in no order to rely on.
std::vector<FoundPair> find_pairs(const PairSearch& wanted, int threads);

}  // namespace pulvis
