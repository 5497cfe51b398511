// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

namespace pulvis::measures {

/// Sum of term(i) for begin <= i < end by halving: the error grows with log n instead of n, and the
/// order depends on the number of terms alone, so the same terms always give the same bits.
template <class Term>
double pairwise_sum(std::size_t begin, std::size_t end, const Term& term) {
  constexpr std::size_t short_run = 32;  // terms; below it, halving costs more than it gains
  if (end - begin <= short_run) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    return sum;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  return pairwise_sum(begin, middle, term) + pairwise_sum(middle, end, term);
}

/// Sum of term(i) for 0 <= i < count, see above.
template <class Term>
double pairwise_sum(std::size_t count, const Term& term) {
  return pairwise_sum(0, count, term);
}

}  // namespace pulvis::measures
