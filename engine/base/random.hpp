// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace pulvis {

/// 128 random bits that depend on the arguments only: not on threads, on the order of the calls, or on what
/// was drawn before. `seed` is the case's, `stream` tells the users of random numbers apart (one for sizes,
/// one for places, ...), `number` is what is drawn for (a grain's permanent number), and `draw` counts the
/// draws for it.
/// Generator: Philox4x32-10 (Salmon et al., SC11, doi 10.1145/2063384.2063405).
inline std::array<std::uint64_t, 2> random_bits(std::uint64_t seed, std::uint32_t stream,
                                                std::uint64_t number, std::uint32_t draw) {
  const auto lower = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto upper = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
  const r123::Philox4x32::ctr_type counter = {{lower(number), upper(number), draw, stream}};
  const r123::Philox4x32::key_type key = {{lower(seed), upper(seed)}};
  const auto words = r123::Philox4x32{}(counter, key);
  const auto pair = [&](int k) { return static_cast<std::uint64_t>(words[k]) << 32 | words[k + 1]; };
  return {pair(0), pair(2)};
}

/// A random number in [0, 1) with 53 random bits.
inline double uniform(std::uint64_t seed, std::uint32_t stream, std::uint64_t number, std::uint32_t draw) {
  return static_cast<double>(random_bits(seed, stream, number, draw)[0] >> 11) * 0x1p-53;
}

/// Three random numbers in [0, 1) with 42 random bits each, for the price of one.
inline std::array<double, 3> uniform_triple(std::uint64_t seed, std::uint32_t stream, std::uint64_t number,
                                            std::uint32_t draw) {
  const auto [first, second] = random_bits(seed, stream, number, draw);
  const std::uint64_t rest = (first & 0x3fffff) << 20 | (second & 0xfffff);
  return {static_cast<double>(first >> 22) * 0x1p-42, static_cast<double>(second >> 22) * 0x1p-42,
          static_cast<double>(rest) * 0x1p-42};
}

}  // namespace pulvis
