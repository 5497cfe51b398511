// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

namespace pulvis {

enum class SizeKind { single, uniform, normal, lognormal, table };

/// How the diameters of grains are distributed. Normal and lognormal laws are truncated, not clipped: no
/// grains pile up at the cut-offs. All but the table are by number.
struct SizeLaw {
  SizeKind kind = SizeKind::single;
  double diameter = 0.0;            ///< m; single: the diameter; normal: mean; lognormal: median (both uncut)
  double standard_deviation = 0.0;  ///< m; normal, before truncation
  double geometric_deviation = 1.0;  ///< -; lognormal: exp(standard deviation of ln d), before truncation
  double smallest = 0.0;             ///< m; cut-off; uniform: lower end
  double largest = 0.0;              ///< m; cut-off; uniform: upper end
  bool by_mass = false;              ///< table: shares are of mass, not of number
  std::vector<double> diameters{};   ///< m; table, ascending
  std::vector<double> shares{};      ///< -; table, of the same length, any sum
};

/// Draws diameters from a size law, one uniform number each through the inverse of the cumulative
/// distribution: cut-offs are exact, nothing is rejected, and a grain's diameter depends on its number only.
class SizeSampler {
 public:
  /// Throws Failure (Exit::bad_case) for a law that no grain can follow, saying why.
  explicit SizeSampler(SizeLaw law);

  /// Diameter (m) of the grain `number`; uses draw 0 of its stream (see base/random.hpp).
  double diameter(std::uint64_t seed, std::uint32_t stream, std::uint64_t number) const;

  double smallest() const { return smallest_; }  ///< m; no grain is smaller
  double largest() const { return largest_; }    ///< m; no grain is larger
  double mean() const { return mean_; }          ///< m; number mean, after truncation
  double mean_cube() const {
    return mean_cube_;
  }  ///< m^3; number mean of d^3: times pi/6 it is the mean volume
  double median_by_mass() const { return median_by_mass_; }  ///< m; d50: half the mass is in smaller grains

 private:
  void prepare_single(double diameter);
  void prepare_table();
  void prepare_continuous();
  void integrate_moments(double low, double high);
  double diameter_at(double t) const;
  double density_at(double t) const;

  SizeLaw law_;
  double smallest_ = 0.0, largest_ = 0.0;
  double mean_ = 0.0, mean_cube_ = 0.0, median_by_mass_ = 0.0;

  // Normal and lognormal: share of the uncut law below the cut-offs, counted from the side of the nearer
  // tail (`reflected_` if that is the upper one), where the numbers are small and therefore precise.
  double log_deviation_ = 0.0;
  double share_low_ = 0.0, share_high_ = 1.0;
  bool reflected_ = false;
  std::vector<double> cumulative_;  ///< table: number share up to and including each diameter
};

}  // namespace pulvis
