// SPDX-License-Identifier: Apache-2.0
#include "engine/parcels/size_sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "engine/base/failure.hpp"

using pulvis::SizeKind;
using pulvis::SizeLaw;
using pulvis::SizeSampler;

namespace {

constexpr double micro = 1e-6;
constexpr std::uint64_t seed = 42;
constexpr std::uint32_t stream = 3;

SizeLaw normal_law(double mean, double deviation, double smallest, double largest) {
  return {.kind = SizeKind::normal,
          .diameter = mean,
          .standard_deviation = deviation,
          .smallest = smallest,
          .largest = largest};
}

SizeLaw lognormal_law(double median, double deviation, double smallest, double largest) {
  return {.kind = SizeKind::lognormal,
          .diameter = median,
          .geometric_deviation = deviation,
          .smallest = smallest,
          .largest = largest};
}

SizeLaw table_law(bool by_mass, std::vector<double> diameters, std::vector<double> shares) {
  return {.kind = SizeKind::table,
          .by_mass = by_mass,
          .diameters = std::move(diameters),
          .shares = std::move(shares)};
}

const SizeLaw molybdenum = lognormal_law(4.6 * micro, 1.4, 2.0 * micro, 9.0 * micro);

std::vector<double> drawn(const SizeSampler& sampler, int count) {
  std::vector<double> diameters;
  for (int number = 0; number < count; ++number) diameters.push_back(sampler.diameter(seed, stream, number));
  return diameters;
}

double cube(double a) { return a * a * a; }

/// Integral by the trapezium rule, deliberately plain: it is what the sampler's own quadrature is held
/// against.
long double trapezium(const std::function<long double(long double)>& function, long double from,
                      long double to) {
  constexpr int steps = 100000;
  const long double width = (to - from) / steps;
  long double sum = 0.5L * (function(from) + function(to));
  for (int i = 1; i < steps; ++i) sum += function(from + i * width);
  return sum * width;
}

/// Density by number at a diameter, uncut and without its factor; the C library is the judge here.
long double density(const SizeLaw& law, long double d) {
  if (law.kind == SizeKind::uniform) return 1.0L;
  const long double z =
      law.kind == SizeKind::normal
          ? (d - law.diameter) / law.standard_deviation
          : std::log(d / law.diameter) / std::log(static_cast<long double>(law.geometric_deviation));
  return std::exp(-0.5L * z * z) / (law.kind == SizeKind::lognormal ? d : 1.0L);
}

/// Integral of d^order times the density between the smallest diameter and `to`.
long double moment(const SizeLaw& law, int order, long double to) {
  return trapezium([&](long double d) { return std::pow(d, order) * density(law, d); }, law.smallest, to);
}

struct NamedLaw {
  std::string name;
  SizeLaw law;
  friend std::ostream& operator<<(std::ostream& out, const NamedLaw& named) { return out << named.name; }
};

class ContinuousLaws : public ::testing::TestWithParam<NamedLaw> {};

TEST_P(ContinuousLaws, HaveTheMomentsOfTheirDensity) {
  const SizeLaw law = GetParam().law;
  const SizeSampler sampler(law);
  const long double number = moment(law, 0, law.largest), mass = moment(law, 3, law.largest);
  EXPECT_NEAR(sampler.mean() / static_cast<double>(moment(law, 1, law.largest) / number), 1.0, 1e-7);
  EXPECT_NEAR(sampler.mean_cube() / static_cast<double>(mass / number), 1.0, 1e-7);
  EXPECT_NEAR(static_cast<double>(moment(law, 3, sampler.median_by_mass()) / mass), 0.5, 1e-7);
}

TEST_P(ContinuousLaws, DrawSamplesOfThoseMoments) {
  constexpr int count = 200000;
  const SizeSampler sampler(GetParam().law);
  double sum = 0.0, squares = 0.0, cubes = 0.0, sixths = 0.0;
  for (const double d : drawn(sampler, count)) {
    sum += d;
    squares += d * d;
    cubes += cube(d);
    sixths += cube(d) * cube(d);
  }
  const double mean = sum / count, mean_cube = cubes / count;
  EXPECT_NEAR(mean, sampler.mean(), 4.0 * std::sqrt((squares / count - mean * mean) / count));
  EXPECT_NEAR(mean_cube, sampler.mean_cube(),
              4.0 * std::sqrt((sixths / count - mean_cube * mean_cube) / count));
}

TEST_P(ContinuousLaws, FollowTheirCumulativeDistribution) {
  constexpr int count = 100000;
  const SizeLaw law = GetParam().law;
  const auto diameters = drawn(SizeSampler(law), count);
  const long double number = moment(law, 0, law.largest);
  for (const double part : {0.1, 0.25, 0.5, 0.75, 0.9}) {
    const double d = law.smallest + part * (law.largest - law.smallest);
    const auto below = std::count_if(diameters.begin(), diameters.end(), [d](double x) { return x < d; });
    const double share = std::min(1.0, static_cast<double>(moment(law, 0, d) / number));
    EXPECT_NEAR(static_cast<double>(below) / count, share,
                4.0 * std::sqrt(share * (1.0 - share) / count) + 1e-9);
  }
}

TEST_P(ContinuousLaws, StayBetweenTheirCutOffsAndReachThem) {
  const SizeLaw law = GetParam().law;
  const SizeSampler sampler(law);
  EXPECT_EQ(sampler.smallest(), law.smallest);
  EXPECT_EQ(sampler.largest(), law.largest);
  const auto diameters = drawn(sampler, 100000);
  EXPECT_GE(*std::min_element(diameters.begin(), diameters.end()), law.smallest);
  EXPECT_LE(*std::max_element(diameters.begin(), diameters.end()), law.largest);
  // Truncated, not clipped: no pile of grains at either end.
  EXPECT_LE(std::count(diameters.begin(), diameters.end(), law.smallest), 1);
  EXPECT_LE(std::count(diameters.begin(), diameters.end(), law.largest), 1);
}

const std::vector<NamedLaw> continuous_laws = {
    {"Uniform", {.kind = SizeKind::uniform, .smallest = 1.0 * micro, .largest = 5.0 * micro}},
    {"Normal", normal_law(50 * micro, 10 * micro, 20 * micro, 80 * micro)},
    {"NormalOneSided", normal_law(50 * micro, 10 * micro, 45 * micro, 200 * micro)},
    {"NormalUpperTail", normal_law(50 * micro, 10 * micro, 90 * micro, 95 * micro)},
    {"NormalLowerTail", normal_law(50 * micro, 10 * micro, 5 * micro, 10 * micro)},
    {"Lognormal", molybdenum},
    {"LognormalWide", lognormal_law(1e-4, 2.5, 1e-5, 1e-3)},
};
INSTANTIATE_TEST_SUITE_P(Sizes, ContinuousLaws, ::testing::ValuesIn(continuous_laws),
                         [](const auto& law) { return law.param.name; });

TEST(SizeSampler, HasTheClosedFormsOfAnUncutLognormalLaw) {
  const double sigma = std::log(1.3);
  const SizeSampler sampler(lognormal_law(1e-3, 1.3, 1e-9, 1e3));
  EXPECT_NEAR(sampler.mean() / (1e-3 * std::exp(0.5 * sigma * sigma)), 1.0, 1e-12);
  EXPECT_NEAR(sampler.mean_cube() / (1e-9 * std::exp(4.5 * sigma * sigma)), 1.0, 1e-12);
  EXPECT_NEAR(sampler.median_by_mass() / (1e-3 * std::exp(3.0 * sigma * sigma)), 1.0, 1e-12);
}

TEST(SizeSampler, HasTheClosedFormsOfAUniformLaw) {
  const SizeSampler sampler({.kind = SizeKind::uniform, .smallest = 1.0, .largest = 3.0});
  EXPECT_NEAR(sampler.mean(), 2.0, 1e-13);
  EXPECT_NEAR(sampler.mean_cube(), 10.0, 1e-12);                       // (3^4 - 1) / (4 * 2)
  EXPECT_NEAR(sampler.median_by_mass(), std::pow(41.0, 0.25), 1e-13);  // d^4 - 1 = (3^4 - 1) / 2
}

TEST(SizeSampler, DrawsATableInItsSharesByNumber) {
  constexpr int count = 100000;
  const SizeSampler sampler(table_law(false, {1.0, 2.0, 4.0}, {2.0, 5.0, 3.0}));
  const auto diameters = drawn(sampler, count);
  const auto grains_of = [&](double diameter) {
    return static_cast<double>(std::count(diameters.begin(), diameters.end(), diameter));
  };
  EXPECT_NEAR(grains_of(1.0), 0.2 * count, 4.0 * std::sqrt(0.16 * count));
  EXPECT_NEAR(grains_of(2.0), 0.5 * count, 4.0 * std::sqrt(0.25 * count));
  EXPECT_NEAR(grains_of(4.0), 0.3 * count, 4.0 * std::sqrt(0.21 * count));
  EXPECT_NEAR(sampler.mean(), 2.4, 1e-15);
  EXPECT_NEAR(sampler.mean_cube(), 0.2 + 0.5 * 8 + 0.3 * 64, 1e-14);
  EXPECT_EQ(sampler.median_by_mass(), 4.0);
}

TEST(SizeSampler, DrawsATableInItsSharesByMass) {
  constexpr int count = 400000;
  const std::vector<double> sizes = {10 * micro, 20 * micro, 30 * micro}, shares = {0.2, 0.5, 0.3};
  const SizeSampler sampler(table_law(true, sizes, shares));
  const auto diameters = drawn(sampler, count);
  double mass = 0.0;
  for (const double d : diameters) mass += cube(d);
  for (int i = 0; i < 3; ++i) {
    const auto grains = std::count(diameters.begin(), diameters.end(), sizes[i]);
    EXPECT_NEAR(static_cast<double>(grains) * cube(sizes[i]) / mass, shares[i], 0.01);
  }
  EXPECT_NEAR(mass / count / sampler.mean_cube(), 1.0, 0.01);
  EXPECT_EQ(sampler.median_by_mass(), 20 * micro);
  // number of grains of each size per unit of mass: 0.2/1, 0.5/8, 0.3/27
  const double counts[] = {0.2, 0.5 / 8, 0.3 / 27};
  const double grains = counts[0] + counts[1] + counts[2];
  EXPECT_NEAR(sampler.mean() / micro, (10 * counts[0] + 20 * counts[1] + 30 * counts[2]) / grains, 1e-13);
}

TEST(SizeSampler, LeavesOutTableRowsWithoutShare) {
  const SizeSampler sampler(table_law(false, {1.0, 2.0, 3.0, 4.0}, {0.0, 1.0, 1.0, 0.0}));
  EXPECT_EQ(sampler.smallest(), 2.0);
  EXPECT_EQ(sampler.largest(), 3.0);
  for (const double d : drawn(sampler, 1000)) EXPECT_TRUE(d == 2.0 || d == 3.0);
}

TEST(SizeSampler, OfOneSizeDrawsThatSize) {
  const double d = 4.6 * micro;
  const SizeLaw laws[] = {
      {.kind = SizeKind::single, .diameter = d},
      {.kind = SizeKind::uniform, .smallest = d, .largest = d},
      normal_law(d, 1e-7, d, d),
      normal_law(d, 0.0, 0.5 * d, 2.0 * d),
      lognormal_law(d, 1.4, d, d),
      lognormal_law(d, 1.0, 0.5 * d, 2.0 * d),
      table_law(true, {d}, {7.0}),
  };
  for (const auto& law : laws) {
    const SizeSampler sampler(law);
    EXPECT_EQ(sampler.diameter(seed, stream, 5), d);
    EXPECT_EQ(sampler.smallest(), d);
    EXPECT_EQ(sampler.largest(), d);
    EXPECT_DOUBLE_EQ(sampler.mean(), d);
    EXPECT_DOUBLE_EQ(sampler.mean_cube(), cube(d));
    EXPECT_EQ(sampler.median_by_mass(), d);
  }
}

TEST(SizeSampler, GivesEachGrainItsDiameterWhateverWasDrawnBefore) {
  const SizeSampler one(molybdenum), other(molybdenum);
  drawn(other, 10);
  for (const std::uint64_t number : {0ULL, 1ULL, 99ULL, 1ULL << 40}) {
    EXPECT_EQ(one.diameter(seed, stream, number), other.diameter(seed, stream, number));
    EXPECT_NE(one.diameter(seed, stream, number), one.diameter(seed + 1, stream, number));
    EXPECT_NE(one.diameter(seed, stream, number), one.diameter(seed, stream + 1, number));
  }
}

// If any of these bits changes, results computed earlier cannot be repeated.
TEST(SizeSampler, GivesTheSameBitsOnEveryMachine) {
  const SizeSampler sampler(molybdenum);
  EXPECT_EQ(sampler.diameter(seed, stream, 0), 0x1.59d2f02b6f2ap-18);
  EXPECT_EQ(sampler.median_by_mass(), 0x1.94bb52370ce35p-18);
}

TEST(SizeSampler, RefusesLawsThatNoGrainCanFollow) {
  const double d = 1e-4, nan = std::numeric_limits<double>::quiet_NaN();
  const SizeLaw laws[] = {
      {.kind = SizeKind::single, .diameter = 0.0},
      {.kind = SizeKind::single, .diameter = nan},
      {.kind = SizeKind::uniform, .smallest = 2 * d, .largest = d},
      {.kind = SizeKind::uniform, .smallest = 0.0, .largest = d},
      normal_law(d, -1e-5, d, 2 * d),
      normal_law(d, nan, d, 2 * d),
      normal_law(d, 0.0, 2 * d, 3 * d),
      normal_law(d, 1e-6, 2 * d, 3 * d),  // a hundred standard deviations away
      lognormal_law(-d, 1.4, d, 2 * d),
      lognormal_law(d, 0.9, d, 2 * d),
      table_law(false, {}, {}),
      table_law(false, {d}, {1.0, 2.0}),
      table_law(false, {2 * d, d}, {1.0, 2.0}),
      table_law(false, {d, 2 * d}, {1.0, -1.0}),
      table_law(false, {d, 2 * d}, {0.0, 0.0}),
      table_law(false, {0.0, d}, {1.0, 1.0}),
  };
  for (const auto& law : laws) {
    try {
      SizeSampler sampler(law);
      ADD_FAILURE() << "accepted law " << &law - laws;
    } catch (const pulvis::Failure& failure) {
      EXPECT_EQ(failure.code(), pulvis::Exit::bad_case);
    }
  }
}

}  // namespace
