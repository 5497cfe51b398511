// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/scalar.hpp"

// Four doubles at once, by the compiler's own vectors: each lane is what plain arithmetic gives.
namespace pulvis {

// Vectors of this size have another calling convention where a processor has no registers for them; everything that
// takes one is inlined.
#pragma GCC diagnostic ignored "-Wpsabi"
using Four = double __attribute__((vector_size(32)));

/// Four numbers from any place in memory.
PULVIS_INLINE Four four_at(const double* from) {
  Four v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
PULVIS_INLINE void put_four(double* to, const Four& v) { __builtin_memcpy(to, &v, sizeof v); }

}  // namespace pulvis
