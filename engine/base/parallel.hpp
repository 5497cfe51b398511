// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <omp.h>

#include <cstddef>

namespace pulvis {

inline constexpr std::size_t too_few_for_threads = 256;  ///< waking a thread costs more than this many items

/// Calls body(begin, end, thread) on `threads` contiguous, equal shares of [0, count). Bodies must not throw
/// and must write only what belongs to their share, so that results do not depend on the number of threads.
template <class Body>
void parallel_shares(std::size_t count, int threads, Body&& body) {
  if (threads <= 1 || count < too_few_for_threads) {
    body(std::size_t{0}, count, 0);
    return;
  }
#pragma omp parallel num_threads(threads)
  {
    // The runtime may give fewer threads than asked for.
    const auto team = static_cast<std::size_t>(omp_get_num_threads());
    const auto me = static_cast<std::size_t>(omp_get_thread_num());
    body(count * me / team, count * (me + 1) / team, static_cast<int>(me));
  }
}

/// Calls body(part) for each part of [0, parts), each by a thread of its own where there are that many. Bodies must not
/// throw and must write only what belongs to their part.
template <class Body>
void parallel_parts(int parts, Body&& body) {
  if (parts <= 1) {
    for (int part = 0; part < parts; ++part) body(part);
    return;
  }
#pragma omp parallel for num_threads(parts) schedule(static, 1)
  for (int part = 0; part < parts; ++part) body(part);
}

}  // namespace pulvis
