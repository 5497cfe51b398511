// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>
#include <vector>

namespace pulvis::measures {

/// Sizes of contact forces. F_n is the normal force of a contact, positive pushing apart.
struct ContactForces {
  std::size_t count = 0;                ///< contacts
  std::optional<double> mean;           ///< N; of the F_n > 0; none if nothing pushes
  std::optional<double> pulling_share;  ///< -; contacts with F_n < 0 over all; none without contacts
  std::vector<double> edges;            ///< -; of the bins of |F_n| / mean, one more than `density`
  std::vector<double> density;          ///< -; probability density of |F_n| / mean, see below
};

/// Mean and distribution of normal forces in N. The probability density counts all contacts, pulling ones by
/// their size, in units of the mean pushing force:
///   density_k = n_k / (n width),  n_k contacts with edges_k <= |F_n|/mean < edges_(k+1),
/// in bins of `force_bin_width` from 0 to `force_bins` of them; the last takes all that is larger too, so that
/// sum density_k width = 1 always. Empty if nothing pushes. std::invalid_argument for a force that is not
/// finite.
constexpr double force_bin_width = 0.1;
constexpr std::size_t force_bins = 60;
ContactForces contact_forces(std::span<const double> normal_forces);

}  // namespace pulvis::measures
