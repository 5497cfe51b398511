// SPDX-License-Identifier: Apache-2.0
#include "measures/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "measures/sum.hpp"

namespace pulvis::measures {

ContactForces contact_forces(std::span<const double> normal_forces) {
  ContactForces result;
  result.count = normal_forces.size();
  std::size_t pushing = 0, pulling = 0;
  for (const double force : normal_forces) {
    if (!std::isfinite(force)) throw std::invalid_argument("contact_forces: a force is not finite");
    if (force > 0.0) ++pushing;
    if (force < 0.0) ++pulling;
  }
  const auto count = static_cast<double>(result.count);
  if (result.count > 0) result.pulling_share = static_cast<double>(pulling) / count;
  if (pushing == 0) return result;

  const double sum =
      pairwise_sum(result.count, [&](std::size_t i) { return std::max(normal_forces[i], 0.0); });
  result.mean = sum / static_cast<double>(pushing);
  std::vector<std::size_t> bins(force_bins, 0);
  for (const double force : normal_forces) {
    const double bin = std::floor(std::abs(force) / *result.mean / force_bin_width);
    ++bins[static_cast<std::size_t>(std::min(bin, static_cast<double>(force_bins - 1)))];
  }
  for (std::size_t k = 0; k <= force_bins; ++k)
    result.edges.push_back(static_cast<double>(k) * force_bin_width);
  for (const std::size_t contacts : bins)
    result.density.push_back(static_cast<double>(contacts) / (count * force_bin_width));
  return result;
}

}  // namespace pulvis::measures
