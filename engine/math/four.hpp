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

/// Rows become columns: that moves numbers and computes none, so it is the same on every processor.
PULVIS_INLINE void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// Four numbers of each of four records, from `part` on, as four lanes; and back.
struct Quartet {
  Four a, b, c, d;
};
PULVIS_INLINE Quartet quartet(const double* const (&record)[4], int part) {
  Quartet q{four_at(record[0] + part), four_at(record[1] + part), four_at(record[2] + part),
            four_at(record[3] + part)};
  transpose(q.a, q.b, q.c, q.d);
  return q;
}
PULVIS_INLINE void put_quartet(double* const (&record)[4], int part, Quartet q) {
  transpose(q.a, q.b, q.c, q.d);
  put_four(record[0] + part, q.a);
  put_four(record[1] + part, q.b);
  put_four(record[2] + part, q.c);
  put_four(record[3] + part, q.d);
}

}  // namespace pulvis
