// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "run/assemble.hpp"
#include "run/graining.hpp"

namespace pulvis {

/// One pair of species seen before the run, for spheres of the d50 size, as single_contact finds it from the law;
/// `_real` is the powder's grain, the rest the parcel.
struct PairForecast {
  std::string first, second;
  double pull_off_real = 0.0, pull_off = 0.0;  ///< N: grain with real modulus; parcel as simulated
  double bond_real = 0.0, bond = 0.0;          ///< pull-off over weight of the d50 grain; parcel
  double sticking_speed_real = 0.0, sticking_speed = 0.0;  ///< m/s
  double own_overlap = 0.0;      ///< over the radius, where parcels rest under their own attraction
  double resting_overlap = 0.0;  ///< over the radius, under the bed's weight and its own adhesion
  double impact_overlap = 0.0;   ///< over the radius, of an undamped collision at the characteristic speed
  // Coefficient of restitution of parcels at the characteristic speed; without damping, the largest that any
  // dashpot could show.
  double restitution = 1.0, restitution_shown = 1.0, undamped_restitution = 1.0;
  double restitution_in_steps = 1.0;  ///< at the time step of the case
  bool coheres = false;               ///< has an attraction, even one without a pull-off force of its own
  bool holds = true;                  ///< false: the attraction exceeds the stiffness at any overlap
};

struct Forecast {
  double parcels = 0.0;     ///< expected
  double memory = 0.0;      ///< bytes, expected peak of the program
  double bed_stress = 0.0;  ///< Pa: weight of the bed over its base, rough
  Graining graining;
  std::vector<PairForecast> pairs;
  std::vector<std::string> warnings;
};

/// The peaks of a motion, in words: what a shaker or a drive has to give.
std::string motion_line(const Motion& motion);

Forecast forecast(const Case& c, const Assembly& assembly);

/// What `pulvis check` prints.
std::string check_report(const Case& c, const Assembly& assembly, const Forecast& forecast);

}  // namespace pulvis
