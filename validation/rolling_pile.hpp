// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "validation/chapters.hpp"

namespace pulvis::validation {

/// The last of the rolling tests: a heap whose container is taken away.
void rolling_pile(Findings& f, Effort effort);

}  // namespace pulvis::validation
