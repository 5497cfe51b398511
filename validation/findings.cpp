// SPDX-License-Identifier: Apache-2.0
#include "validation/findings.hpp"

#include <algorithm>
#include <cmath>

namespace pulvis::validation {

Row& Findings::compare(std::string name, std::string source, double reference, double value, Compare how,
                       std::optional<double> limit) {
  const double deviation = how == Compare::relative   ? std::fabs(value / reference - 1.0)
                           : how == Compare::absolute ? std::fabs(value - reference)
                           : how == Compare::bound    ? std::fabs(value)
                           : value < reference        ? reference - value
                                                      : 0.0 * value;
  rows_.push_back({std::move(name), std::move(source), reference, value, deviation, limit, {}});
  return rows_.back();
}

bool Findings::passed() const {
  return !rows_.empty() && std::all_of(rows_.begin(), rows_.end(), [](const Row& r) { return r.passed(); });
}

}  // namespace pulvis::validation
