// SPDX-License-Identifier: Apache-2.0
#include "measures/contact_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "packings.hpp"

namespace pulvis::measures {
namespace {

TEST(ContactForces, OfAFewAreThoseOnPaper) {
  const std::vector<double> forces{1.0, 3.0, -2.1, 0.0, 40.0};  // pushing mean 44/3
  const ContactForces result = contact_forces(forces);
  EXPECT_EQ(result.count, 5u);
  EXPECT_DOUBLE_EQ(result.mean.value(), 44.0 / 3);
  EXPECT_EQ(result.pulling_share, 0.2);
  ASSERT_EQ(result.density.size(), 60u);
  ASSERT_EQ(result.edges.size(), 61u);
  EXPECT_NEAR(result.edges.back(), 6.0, 1e-12);
  EXPECT_DOUBLE_EQ(result.density[0], 2 / 0.5);   // 0 and 1 N
  EXPECT_DOUBLE_EQ(result.density[1], 1 / 0.5);   // 2.1 N
  EXPECT_DOUBLE_EQ(result.density[2], 1 / 0.5);   // 3 N
  EXPECT_DOUBLE_EQ(result.density[27], 1 / 0.5);  // 40 N
}

TEST(ContactForces, OfAnExponentialDistributionAreExponential) {
  // P(F) = exp(-F/<F>)/<F>; of n = 2e6 draws a bin holds n p +- sqrt(n p (1-p)), and the mean is off by n^-1/2.
  const std::size_t n = 2'000'000;
  packings::Uniform uniform(3);
  std::vector<double> forces(n);
  for (double& force : forces) force = -2e-4 * std::log(1.0 - uniform(0, 1));
  const ContactForces result = contact_forces(forces);
  EXPECT_NEAR(result.mean.value() / 2e-4, 1.0, 4 / std::sqrt(n));
  double integral = 0.0;
  for (std::size_t k = 0; k < force_bins; ++k) {
    const bool last = k + 1 == force_bins;  // that takes the tail too
    const double share = std::exp(-result.edges[k]) - (last ? 0.0 : std::exp(-result.edges[k + 1]));
    const double error = 5 * std::sqrt(share * (1 - share) / n) + 4 * share * result.edges[k] / std::sqrt(n);
    EXPECT_NEAR(result.density[k] * force_bin_width, share, error) << k;
    integral += result.density[k] * force_bin_width;
  }
  EXPECT_NEAR(integral, 1.0, 1e-12);
}

TEST(ContactForces, HaveNoMeanWhereNothingPushes) {
  EXPECT_FALSE(contact_forces({}).pulling_share.has_value());
  const std::vector<double> pulls{-1.0, -2.0};
  const ContactForces result = contact_forces(pulls);
  EXPECT_EQ(result.pulling_share, 1.0);
  EXPECT_FALSE(result.mean.has_value());
  EXPECT_TRUE(result.density.empty());
  const std::vector<double> bad{1.0, std::nan("")};
  EXPECT_THROW(contact_forces(bad), std::invalid_argument);
}

}  // namespace
}  // namespace pulvis::measures
