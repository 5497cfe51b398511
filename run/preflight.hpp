// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "run/assemble.hpp"

namespace pulvis {

/// One pair of species seen before the run, for parcels of the d50 size; grain values in brackets of
/// `pulvis check` are the real powder's.
struct PairForecast {
  std::string first, second;
  double pull_off_real = 0.0, pull_off = 0.0;  ///< N: grain with real modulus; parcel as simulated
  double bond_real = 0.0, bond = 0.0;          ///< pull-off over weight of the d50 grain; parcel
  double sticking_speed_real = 0.0, sticking_speed = 0.0;  ///< m/s
  double resting_overlap = 0.0;  ///< over the radius, under the bed's weight and its own adhesion
  double impact_overlap = 0.0;   ///< over the radius, at the characteristic speed
};

struct Forecast {
  double parcels = 0.0;     ///< expected
  double memory = 0.0;      ///< bytes, expected peak of the program
  double bed_stress = 0.0;  ///< Pa: weight of the bed over its base, rough
  std::vector<PairForecast> pairs;
  std::vector<std::string> warnings;
};

/// The peaks of a motion, in words: what a shaker or a drive has to give.
std::string motion_line(const Motion& motion);

Forecast forecast(const Case& c, const Assembly& assembly);

/// What `pulvis check` prints.
std::string check_report(const Case& c, const Assembly& assembly, const Forecast& forecast);

}  // namespace pulvis
