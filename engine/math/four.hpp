// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

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

/// Four whole numbers from 0 to 255.
PULVIS_INLINE Four four_of_bytes(const std::uint8_t* from) {
  using Bytes = std::uint8_t __attribute__((vector_size(4)));
  using Wholes = std::int32_t __attribute__((vector_size(16)));
  Bytes bytes;
  __builtin_memcpy(&bytes, from, sizeof bytes);
  return __builtin_convertvector(__builtin_convertvector(bytes, Wholes), Four);
}

using Two = double __attribute__((vector_size(16)));
PULVIS_INLINE Two two_at(const double* from) {
  Two v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
PULVIS_INLINE void put_two(double* to, const Two& v) { __builtin_memcpy(to, &v, sizeof v); }
PULVIS_INLINE Two first_two(const Four& v) { return __builtin_shufflevector(v, v, 0, 1); }
PULVIS_INLINE Two last_two(const Four& v) { return __builtin_shufflevector(v, v, 2, 3); }

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

/// What comparisons of four give: all bits of a lane, or none.
using FourTruths = decltype(Four{} < Four{});
PULVIS_INLINE bool any(const FourTruths& t) { return (t[0] | t[1] | t[2] | t[3]) != 0; }

/// Four vectors.
struct Four3 {
  Four x, y, z;
};
/// Four vectors that stand in a row.
PULVIS_INLINE Four3 three_lanes(const double* from) {
  const Four a = four_at(from), b = four_at(from + 4), c = four_at(from + 8);  // xyzx yzxy zxyz
  const Four ab_x = __builtin_shufflevector(a, b, 0, 3, 6, 6),
             ab_y = __builtin_shufflevector(a, b, 1, 4, 7, 7),
             ab_z = __builtin_shufflevector(a, b, 2, 5, 5, 5);
  return {__builtin_shufflevector(ab_x, c, 0, 1, 2, 5), __builtin_shufflevector(ab_y, c, 0, 1, 2, 6),
          __builtin_shufflevector(ab_z, c, 0, 1, 4, 7)};
}
PULVIS_INLINE Four3 operator+(const Four3& a, const Four3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
PULVIS_INLINE Four3 operator-(const Four3& a, const Four3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
PULVIS_INLINE Four3 operator+(const Vec3& a, const Four3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
PULVIS_INLINE Four3 operator*(const Four& s, const Four3& a) { return {s * a.x, s * a.y, s * a.z}; }
PULVIS_INLINE Four3 operator*(const Four& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
PULVIS_INLINE Four3 operator*(double s, const Four3& a) { return {s * a.x, s * a.y, s * a.z}; }
PULVIS_INLINE Four dot(const Four3& a, const Four3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace pulvis
