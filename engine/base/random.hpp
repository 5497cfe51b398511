// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Random123/philox.h>

#include <cstdint>

namespace pulvis {

/// A random number in [0, 1) with 53 random bits that depends on its arguments only: not on threads, on the
/// order of the calls, or on what was drawn before. `seed` is the case's, `stream` tells the users of random
/// numbers apart (one for sizes, one for places, ...), `number` is what is drawn for (a grain's permanent
/// number), and `draw` counts the draws for it.
/// Generator: Philox4x32-10 (Salmon et al., SC11, doi 10.1145/2063384.2063405).
inline double uniform(std::uint64_t seed, std::uint32_t stream, std::uint64_t number, std::uint32_t draw) {
  const auto lower = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto upper = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
  const r123::Philox4x32::ctr_type counter = {{lower(number), upper(number), draw, stream}};
  const r123::Philox4x32::key_type key = {{lower(seed), upper(seed)}};
  const auto words = r123::Philox4x32{}(counter, key);
  const std::uint64_t bits = static_cast<std::uint64_t>(words[0]) << 32 | words[1];
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace pulvis
