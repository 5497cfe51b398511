// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "report/run_data.hpp"

namespace pulvis::report {

/// The limits between words, all in one place; the page prints them below what was said.
struct JudgementRules {
  double very_uniform = 0.02, fairly_uniform = 0.05, uneven = 0.10;  ///< scatter of the density over its mean
  double same_density = 0.005;  ///< parts whose densities differ by less count as equally dense
  double worth_mending = 0.03;  ///< a difference of density between parts from which to try something
  double enough_powder = 0.10;  ///< a part with a smaller share of the volume is not compared
  double changed = 0.002;       ///< a phase that changes the density by less changed nothing
  double same_mass = 0.01;      ///< phases that add or take out more are not compared
  double tilted = 0.0524;       ///< rad (3 degrees)
  double few_parcels = 15.0;    ///< parcels across the die's narrowest side
  double soft = 0.05;           ///< largest overlap over the radius
  double not_full = 0.95;       ///< fill ratio
  double moving = 1e-3;         ///< kinetic energy per parcel over m g d, as in `until = "rest"`
};

/// What the numbers say, in plain sentences, each with its number.
struct Judgement {
  std::vector<std::string> uniformity;  ///< how uniform, where dense, where loose, the surface
  std::vector<std::string> changes;     ///< from phase to phase
  std::vector<std::string> to_try;
  std::vector<std::pair<std::string, std::string>> rules;  ///< word or advice, and its limit
};

Judgement judge(const RunData& run, const JudgementRules& rules = {});

}  // namespace pulvis::report
