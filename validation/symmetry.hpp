// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "validation/findings.hpp"

// Parts of the chapter `symmetry`.
namespace pulvis::validation {

/// Of the law of one contact: turned frames, bodies named the other way round, and numbers that are none.
void symmetry_of_laws(Findings& f);
void finite_at_zero(Findings& f);

}  // namespace pulvis::validation
