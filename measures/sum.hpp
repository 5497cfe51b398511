// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

namespace pulvis::measures {

/// Sum of term(i) for begin <= i < end by halving: the error grows with log n instead of n, and the
/// order depends on the number of terms alone, so the same terms always give the same bits.
/// `Sum` adds up by += from Sum{}: a number, a vector, a tensor.
template <class Sum, class Term>
Sum pairwise_total(std::size_t begin, std::size_t end, const Term& term) {
  constexpr std::size_t short_run = 32;  // terms; below it, halving costs more than it gains
  Sum sum{};
  if (end - begin <= short_run) {
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    return sum;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  sum = pairwise_total<Sum>(begin, middle, term);
  sum += pairwise_total<Sum>(middle, end, term);
  return sum;
}

/// Sum of term(i) for 0 <= i < count, see above.
template <class Sum, class Term>
Sum pairwise_total(std::size_t count, const Term& term) {
  return pairwise_total<Sum>(0, count, term);
}

/// The same of numbers.
template <class Term>
double pairwise_sum(std::size_t count, const Term& term) {
  return pairwise_total<double>(0, count, term);
}

}  // namespace pulvis::measures
