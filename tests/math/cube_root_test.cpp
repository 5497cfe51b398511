// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/math/scalar.hpp"
#include "tests/math/ulp.hpp"

using pulvis::cube_root;
using pulvis::validation::between;
using pulvis::validation::error_in_ulp;

namespace {

/// Numbers over the whole range, and many over one period of the exponent's remainder.
std::vector<double> sample() {
  std::vector<double> numbers = {0.0, 1e-307, 5e307, 1.0, 8.0};
  for (int i = 0; i < 300000; ++i) {
    numbers.push_back(i % 2 ? std::exp2(between(-1019.0, 1022.0, i)) : between(1.0, 8.0, i));
  }
  return numbers;
}

TEST(CubeRoot, AgreesWithLongDoubleToOneUlp) {
  double worst = 0.0;
  for (const double a : sample()) {
    worst = std::max(worst, error_in_ulp(cube_root(a), std::cbrt(static_cast<long double>(a))));
  }
  EXPECT_LT(worst, 1.0);
}

TEST(InverseCubeRoot, AgreesWithLongDoubleToElevenTenthsOfAnUlp) {
  double worst = 0.0;
  for (const double a : sample())
    if (a > 0.0)
      worst = std::max(
          worst, error_in_ulp(pulvis::inverse_cube_root(a), 1.0L / std::cbrt(static_cast<long double>(a))));
  EXPECT_LT(worst, 1.1);
}

TEST(CubeRoot, IsExactForCubesOfWholeNumbers) {
  for (int i = 0; i <= 1000; ++i) EXPECT_EQ(cube_root(1.0 * i * i * i), i);
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
// One loop, compiled for each set of vector instructions.
#define PULVIS_ROOTS(name, instructions)                                                               \
  [[gnu::target(instructions), gnu::noinline]] void name(const double* a, double* result, int count) { \
    _Pragma("omp simd") for (int i = 0; i < count; ++i) result[i] = cube_root(a[i]);                   \
  }
PULVIS_ROOTS(roots_sse2, "sse2")
PULVIS_ROOTS(roots_avx2, "avx2,fma")
PULVIS_ROOTS(roots_avx512, "avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512")

template <typename Roots>
void expect_same_bits(Roots roots) {
  const auto numbers = sample();
  std::vector<double> result(numbers.size());
  roots(numbers.data(), result.data(), static_cast<int>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(result[i], cube_root(numbers[i])) << numbers[i];
}

TEST(CubeRoot, GivesTheSameBitsInSse2Vectors) { expect_same_bits(roots_sse2); }

TEST(CubeRoot, GivesTheSameBitsInAvx2Vectors) {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "no AVX2 here";
  expect_same_bits(roots_avx2);
}

TEST(CubeRoot, GivesTheSameBitsInAvx512Vectors) {
  const bool here = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  if (!here) GTEST_SKIP() << "no AVX-512 here";
  expect_same_bits(roots_avx512);
}
#endif

}  // namespace
