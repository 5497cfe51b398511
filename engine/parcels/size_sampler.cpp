// SPDX-License-Identifier: Apache-2.0
#include "engine/parcels/size_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/failure.hpp"
#include "engine/base/random.hpp"
#include "engine/math/functions.hpp"
#include "engine/math/scalar.hpp"

namespace pulvis {
namespace {

void require(bool condition, const char* message) {
  if (!condition) throw Failure(Exit::bad_case, std::string("size distribution: ") + message);
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

double cube(double a) { return a * a * a; }

/// Gauss's rule with three points: exact for polynomials of degree five.
template <typename Function>
double integral(const Function& function, double from, double to) {
  const double centre = 0.5 * (from + to), half = 0.5 * (to - from);
  const double offset = half * root(0.6);
  return half * (5.0 * function(centre - offset) + 8.0 * function(centre) + 5.0 * function(centre + offset)) /
         9.0;
}

/// Beyond 38 standard deviations a normal density is zero in double precision. A lognormal law's mass
/// is centred 3 ln(geometric deviation) above its median; that stays inside for deviations up to 1e4.
constexpr double end_of_normal = 38.0;

}  // namespace

SizeSampler::SizeSampler(SizeLaw law) : law_(std::move(law)) {
  switch (law_.kind) {
    case SizeKind::single:
      prepare_single(law_.diameter);
      break;
    case SizeKind::table:
      prepare_table();
      break;
    case SizeKind::uniform:
    case SizeKind::normal:
    case SizeKind::lognormal:
      prepare_continuous();
      break;
  }
}

void SizeSampler::prepare_single(double diameter) {
  require(positive(diameter), "the diameter must be positive");
  law_.kind = SizeKind::single;
  law_.diameter = smallest_ = largest_ = mean_ = median_by_mass_ = diameter;
  mean_cube_ = cube(diameter);
}

void SizeSampler::prepare_table() {
  const auto& diameters = law_.diameters;
  const auto& shares = law_.shares;
  require(!diameters.empty(), "the table is empty");
  require(diameters.size() == shares.size(), "the table needs one share for each diameter");
  require(positive(diameters.front()) && positive(diameters.back()), "diameters must be positive");
  require(std::is_sorted(diameters.begin(), diameters.end()), "diameters of the table must ascend");
  for (const double share : shares) {
    require(std::isfinite(share) && share >= 0.0, "shares of the table must not be negative");
  }

  // Ratios to the largest diameter keep the cubes far from underflow.
  const double unit = diameters.back();
  std::vector<double> masses;
  double number = 0.0, length = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double ratio = diameters[i] / unit;
    const double count = law_.by_mass ? shares[i] / cube(ratio) : shares[i];
    masses.push_back(law_.by_mass ? shares[i] : shares[i] * cube(ratio));
    cumulative_.push_back(number += count);
    length += count * ratio;
    mass += masses.back();
    if (count > 0.0 && smallest_ == 0.0) smallest_ = diameters[i];
    if (count > 0.0) largest_ = diameters[i];
  }
  require(positive(number), "the shares of the table add up to nothing");
  for (double& share : cumulative_) share /= number;
  mean_ = unit * (length / number);
  mean_cube_ = cube(unit) * (mass / number);

  // The median by mass is the diameter at which the running mass reaches one half.
  double running = 0.0;
  for (std::size_t i = 0; i < masses.size() && 2.0 * running < mass; ++i) {
    running += masses[i];
    median_by_mass_ = diameters[i];
  }
}

void SizeSampler::prepare_continuous() {
  require(positive(law_.smallest) && positive(law_.largest), "the cut-offs must be positive");
  require(law_.smallest <= law_.largest, "the smallest diameter is above the largest");
  if (law_.smallest == law_.largest) return prepare_single(law_.smallest);
  smallest_ = law_.smallest;
  largest_ = law_.largest;
  if (law_.kind == SizeKind::uniform) return integrate_moments(smallest_, largest_);

  // Without spread either law has one diameter, or none.
  require(positive(law_.diameter), "the diameter must be positive");
  const bool normal = law_.kind == SizeKind::normal;
  const double deviation = normal ? law_.standard_deviation : law_.geometric_deviation - 1.0;
  require(std::isfinite(deviation) && deviation >= 0.0, normal
                                                            ? "the standard deviation must not be negative"
                                                            : "the geometric deviation must be at least 1");
  if (deviation == 0.0) {
    require(smallest_ <= law_.diameter && law_.diameter <= largest_, "the diameter is outside the cut-offs");
    return prepare_single(law_.diameter);
  }

  // Cut-offs in standard deviations from the middle of the uncut law, and the shares below them.
  if (!normal) log_deviation_ = logarithm(law_.geometric_deviation);
  const auto deviations_of = [&](double diameter) {
    return normal ? (diameter - law_.diameter) / deviation
                  : logarithm(diameter / law_.diameter) / log_deviation_;
  };
  const double low = deviations_of(smallest_), high = deviations_of(largest_);
  reflected_ = low > 0.0;
  share_low_ = normal_cumulative(reflected_ ? -high : low);
  share_high_ = normal_cumulative(reflected_ ? -low : high);
  require(share_high_ - share_low_ > 1e-9,
          "hardly any grain (less than one in 1e9) lies between the cut-offs");
  integrate_moments(std::max(low, -end_of_normal), std::min(high, end_of_normal));
}

/// Diameter as a function of the variable the law is simple in: the diameter itself (uniform) or the
/// standard normal variable.
double SizeSampler::diameter_at(double t) const {
  switch (law_.kind) {
    case SizeKind::normal:
      return law_.diameter + law_.standard_deviation * t;
    case SizeKind::lognormal:
      return law_.diameter * exponential(log_deviation_ * t);
    default:
      return t;
  }
}

/// Density by number of that variable, up to a factor.
double SizeSampler::density_at(double t) const {
  return law_.kind == SizeKind::uniform ? 1.0 : exponential(-0.5 * t * t);
}

/// Moments and the median by mass from panels of the variable t; at most 0.02 standard deviations wide, which
/// leaves errors near 1e-13. Ratios to the largest diameter keep the cubes far from underflow.
void SizeSampler::integrate_moments(double low, double high) {
  constexpr int panels = 4096;
  const auto edge = [&](int panel) { return low + (high - low) * panel / panels; };
  const auto ratio_at = [&](double t) { return diameter_at(t) / largest_; };
  const auto mass_at = [&](double t) { return density_at(t) * cube(ratio_at(t)); };
  double number = 0.0, length = 0.0, mass = 0.0;
  std::vector<double> mass_below = {0.0};
  for (int panel = 0; panel < panels; ++panel) {
    const double from = edge(panel), to = edge(panel + 1);
    number += integral([&](double t) { return density_at(t); }, from, to);
    length += integral([&](double t) { return density_at(t) * ratio_at(t); }, from, to);
    mass_below.push_back(mass += integral(mass_at, from, to));
  }
  mean_ = largest_ * (length / number);
  mean_cube_ = cube(largest_) * (mass / number);

  // Half the mass lies below some point of the panel where the running mass passes one half: bisection.
  const auto upper = std::upper_bound(mass_below.begin(), mass_below.end() - 1, 0.5 * mass);
  const auto panel = static_cast<int>(upper - mass_below.begin()) - 1;
  double from = edge(panel), to = edge(panel + 1);
  for (int step = 0; step < 50; ++step) {
    const double middle = 0.5 * (from + to);
    const double below = mass_below[panel] + integral(mass_at, edge(panel), middle);
    (below < 0.5 * mass ? from : to) = middle;
  }
  median_by_mass_ = std::clamp(diameter_at(0.5 * (from + to)), smallest_, largest_);
}

double SizeSampler::diameter(std::uint64_t seed, std::uint32_t stream, std::uint64_t number) const {
  if (law_.kind == SizeKind::single) return law_.diameter;
  const double share = uniform(seed, stream, number, 0);
  if (law_.kind == SizeKind::uniform) return std::min(smallest_ + (largest_ - smallest_) * share, largest_);
  if (law_.kind == SizeKind::table) {
    const auto entry = std::upper_bound(cumulative_.begin(), cumulative_.end(), share);  // the last is 1
    return law_.diameters[entry - cumulative_.begin()];
  }
  const double normal = inverse_normal(share_low_ + (share_high_ - share_low_) * share);
  return std::clamp(diameter_at(reflected_ ? -normal : normal), smallest_, largest_);
}

}  // namespace pulvis
