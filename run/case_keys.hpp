// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"

namespace pulvis {

/// A key on which the course of a run depends.
struct CaseKey {
  std::string key;      ///< "materials.steel.density"
  std::string value;    ///< as written, for people
  std::string meaning;  ///< the same however it was written; of a file, a checksum of what is in it
};

/// All keys of a case except those that a run may be resumed with changed: `title` and those of `[output]`,
/// which say only how often something is written. Throws Failure(bad_input) if a file that the case names
/// cannot be read.
std::vector<CaseKey> deciding_keys(const Case& c);

/// A line for each key that is not the same: "powders.mo.coarse_graining was 100, is 50".
std::vector<std::string> differences(const std::vector<CaseKey>& before, const std::vector<CaseKey>& now);

}  // namespace pulvis
