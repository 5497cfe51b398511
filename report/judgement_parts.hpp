// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "report/judgement.hpp"

// The parts of the judgement, for judgement*.cpp alone.
namespace pulvis::report {

/// How uniform, where dense, where loose.
void judge_uniformity(const PhaseData& phase, const JudgementRules& rules, Judgement& j);
/// What changed from phase to phase.
void judge_changes(const RunData& run, const JudgementRules& rules, Judgement& j);
/// What to try next.
void advise(const RunData& run, const PhaseData& phase, const JudgementRules& rules, Judgement& j);

/// A comparison of two parts; no sentence if there is nothing to compare.
struct Difference {
  std::string sentence;
  double ratio = 0.0;  ///< of the densities; NaN: not compared
};
/// The lowest against the highest third, without the layers of cells at the floor and at the surface.
Difference thirds(const MeasuresFile& m, const JudgementRules& rules);

/// The share by which the density changed in the k-th phase, counted from 0; NaN if it is not known.
double change_in(const RunData& run, std::size_t k);
/// The same of the mass in the die; 0 if it is not known.
double mass_change_in(const RunData& run, std::size_t k);

/// The density of one part over that of another, from their porosities.
inline double density_ratio(double porosity, double other) { return (1.0 - porosity) / (1.0 - other); }

/// "2.1 %" of 0.021.
std::string percent(double share, int digits = 2);

}  // namespace pulvis::report
