// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "report/compare.hpp"

using namespace pulvis::report;

namespace {

TEST(Statistic, IsTheMeanAndTheDeviationOfTheSample) {
  const Statistic s = statistic_of({2.0, 4.0, 9.0, std::nan("")});
  EXPECT_EQ(s.count, 3u);
  EXPECT_DOUBLE_EQ(s.mean, 5.0);
  EXPECT_DOUBLE_EQ(s.deviation, std::sqrt((9.0 + 1.0 + 16.0) / 2.0));
  EXPECT_TRUE(std::isnan(statistic_of({1.0}).deviation));
  EXPECT_EQ(statistic_of({}).count, 0u);
}

// By hand: s1^2 = s2^2 = 1, error sqrt(1/3 + 1/3); Student's limit for 4 degrees of freedom is 2.776.
TEST(Verdict, GoesByTheStandardErrorOfTheDifference) {
  const Verdict near = compare_means(statistic_of({1, 2, 3}), statistic_of({3, 4, 5}));
  EXPECT_DOUBLE_EQ(near.error, std::sqrt(2.0 / 3.0));
  EXPECT_DOUBLE_EQ(near.limit, 2.776);
  EXPECT_FALSE(near.beyond);  // 2/0.816 = 2.45
  const Verdict far = compare_means(statistic_of({1, 2, 3}), statistic_of({4, 5, 6}));
  EXPECT_TRUE(far.judged);
  EXPECT_TRUE(far.beyond);  // 3.67
  EXPECT_DOUBLE_EQ(far.difference, 3.0);
}

// By hand: e1 = 1/3, e2 = (500/3)/4; 42^2/((1/3)^2/2 + 41.667^2/3) = 3.05 degrees of freedom.
TEST(Verdict, LetsEachGroupHaveItsOwnScatter) {
  const Verdict v = compare_means(statistic_of({1, 2, 3}), statistic_of({0, 10, 20, 30}));
  EXPECT_DOUBLE_EQ(v.error, std::sqrt(42.0));
  EXPECT_DOUBLE_EQ(v.limit, 3.182);
  EXPECT_FALSE(v.beyond);  // 13/6.48 = 2.0
}

TEST(Verdict, UsesTheScatterOfOneGroupForASingleRun) {
  const Verdict v = compare_means(statistic_of({1, 2, 3}), statistic_of({20}));
  EXPECT_TRUE(v.judged);
  EXPECT_DOUBLE_EQ(v.error, std::sqrt(4.0 / 3.0));
  EXPECT_DOUBLE_EQ(v.limit, 4.303);
  EXPECT_TRUE(v.beyond);
}

TEST(Verdict, IsNotGivenForTwoSingleRuns) {
  EXPECT_FALSE(compare_means(statistic_of({1}), statistic_of({2})).judged);
  EXPECT_FALSE(compare_means(statistic_of({}), statistic_of({2, 3, 4})).judged);
}

// The distribution function of Student's law by integration of its density: 97.5 % lie below the limit.
TEST(StudentLimit, LeavesFivePerCentOutside) {
  for (const std::size_t n : {1u, 2u, 3u, 7u, 15u, 30u}) {
    const double nu = static_cast<double>(n), limit = student_limit(n);
    const double norm =
        std::tgamma(0.5 * (nu + 1.0)) / (std::sqrt(nu * std::acos(-1.0)) * std::tgamma(0.5 * nu));
    double sum = 0.0;
    const int parts = 200'000;
    for (int k = 0; k < parts; ++k) {
      const double t = limit * (k + 0.5) / parts;
      sum += norm * std::pow(1.0 + t * t / nu, -0.5 * (nu + 1.0)) * limit / parts;
    }
    EXPECT_NEAR(0.5 + sum, 0.975, 1e-5 * (n == 1 ? 10 : 5)) << n;
  }
  EXPECT_TRUE(std::isinf(student_limit(0)));
  EXPECT_EQ(student_limit(1000), student_limit(30));
}

TEST(Groups, JoinRunsThatDifferOnlyInSeedTitleAndOutput) {
  const auto run = [](const char* label, std::vector<Key> keys) {
    RunData r;
    r.label = label;
    r.keys = std::move(keys);
    return r;
  };
  const std::vector<RunData> runs{
      run("a", {{"seed", "1", ""}, {"title", "x", ""}, {"time.fraction", "0.5", ""}}),
      run("b", {{"seed", "1", ""}, {"time.fraction", "0.2", ""}}),
      run("c", {{"seed", "2", ""}, {"time.fraction", "0.5", ""}, {"output.interval", "1", ""}}), run("d", {}),
      run("e", {})};
  const std::vector<Group> groups = groups_of(runs);
  ASSERT_EQ(groups.size(), 4u);
  EXPECT_EQ(groups[0].runs, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(groups[1].runs, (std::vector<std::size_t>{1}));
  EXPECT_EQ(groups[1].label, "b");
}

}  // namespace
