// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "run/assemble.hpp"

namespace pulvis {

/// A number of the grain and of the parcel in its stead, which is as soft as the parcel.
struct Counterpart {
  std::string name;
  double grain = 0.0, parcel = 0.0;
  double growth =
      0.0;  ///< power of alpha with which it goes where the similarity keeps the dimensionless group
  std::string grain_text, parcel_text;

  /// Parcel over alpha^growth times grain; 1: kept. 0 where the grain has none.
  double ratio(double alpha) const;
  bool is_kept(double alpha) const;  ///< to 1 %
};

/// What coarse graining makes of the contacts of one pair.
struct PairGraining {
  std::string pair;
  std::vector<Counterpart> numbers;
};

/// What coarse graining makes of a case.
struct Graining {
  double factor = 1.0;  ///< of all powders
  std::vector<PairGraining> pairs;
  std::vector<Counterpart> whole;  ///< time step, number, inertial number
  std::vector<std::string> warnings;
};

/// `parcels` that the case will have, `bed_stress` (Pa) at its bottom.
Graining graining(const Case& c, const Assembly& assembly, double parcels, double bed_stress);

/// The table for `pulvis check`, and what the similarity keeps; empty where parcels are grains.
std::string graining_text(const Case& c, const Graining& g);

}  // namespace pulvis
