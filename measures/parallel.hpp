// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>

namespace pulvis::measures {

/// Calls body(i) for 0 <= i < count on all threads. Each call writes only what belongs to its own i, so the
/// number of threads changes no bit of the result; `body` must not throw.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  const auto end = static_cast<std::int64_t>(count);
#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t i = 0; i < end; ++i) body(static_cast<std::size_t>(i));
}

}  // namespace pulvis::measures
