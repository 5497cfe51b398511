// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

// What a measure would be with real grains, from runs with parcels.
//
// With parcels alpha times larger than grains, a measure is taken to be f(alpha) = f(1) + C (alpha^p - 1): the number
// of parcels across the die is the only thing that changes, and walls and surfaces act over some parcels' width. With
// three factors or more the order p is that which the last three show, found as in I. B. Celik et al., Procedure for
// estimation and reporting of uncertainty due to discretization in CFD applications, J. Fluids Eng. 130 (2008) 078001,
// doi:10.1115/1.2960953, for ratios that need not be equal. Where their differences do not exceed the scatter of the
// seeds, or no p from 1/2 to 3 fits, p = 1 is assumed: an effect of layers one parcel thick.
namespace pulvis::study {

/// A measure at one factor: its mean over the seeds.
struct Sample {
  double factor = 1.0, mean = 0.0;
  double standard_error = 0.0;  ///< of the mean; 0 with one seed
};

struct Extrapolation {
  double value = 0.0;   ///< at factor 1
  double order = 1.0;   ///< p
  double growth = 0.0;  ///< C
  bool order_observed = false;
  double coarse_graining_error = 0.0;  ///< of the finest sample: safety factor times |f(finest) - f(1)|
  double scatter = 0.0;                ///< two standard errors of `value`, from those of the samples
  /// Of `value`: root of the squares of both.
  double error() const;
};

/// Largest order that is believed, smallest, and safety factors with an order that was observed or assumed (as in the
/// grid convergence index, P. J. Roache, J. Fluids Eng. 116 (1994) 405-413, doi:10.1115/1.2910291).
constexpr double lowest_order = 0.5, highest_order = 3.0, observed_safety = 1.25, assumed_safety = 3.0;

/// From two samples or more, each with another factor. Throws std::invalid_argument for fewer.
Extrapolation extrapolate(std::vector<Sample> samples);

}  // namespace pulvis::study
