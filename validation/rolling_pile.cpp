// SPDX-License-Identifier: Apache-2.0
#include "validation/rolling_pile.hpp"
namespace pulvis::validation {
void rolling_pile(Findings&, Effort) {}
}  // namespace pulvis::validation
