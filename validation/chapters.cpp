// SPDX-License-Identifier: Apache-2.0
#include "validation/chapters.hpp"

namespace pulvis::validation {

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> all{
      {"jkr", "Adhesion after Johnson, Kendall and Roberts",
       "The force curve at sixteen overlaps against the equations solved with 30 digits; the pull-off force, "
       "the "
       "work of separation and the sticking speed against closed forms.",
       jkr},
  };
  return all;
}

}  // namespace pulvis::validation
