// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "output/figure.hpp"
#include "run/preflight.hpp"

namespace pulvis {

/// What `pulvis law` is asked for.
struct LawRequest {
  std::vector<std::string> pair;  ///< none, or two names of materials or powders; none: every pair
  std::vector<double> speeds;     ///< m/s; none: parts of the characteristic speed
};

struct LawReport {
  std::string text;                   ///< a table for each pair: real grain and simulated parcel side by side
  std::vector<std::string> warnings;  ///< those of `pulvis check` on these pairs
  std::vector<Figure> figures;        ///< load-unload curves, two a pair
};

/// What the law of a case makes of single contacts, by d50 spheres. Throws Failure(Exit::usage) for a pair that
/// does not exist or whose two cannot meet.
LawReport law_report(const Case& c, const Assembly& assembly, const Forecast& forecast,
                     const LawRequest& request);

/// Reads "0.1 m/s"; throws Failure(Exit::usage) if it is no positive speed.
double speed_from(const std::string& text);

/// Writes the figures and their points into a folder, which is made. Throws Failure(Exit::io).
void write_curves(const std::string& folder, const LawReport& report);

}  // namespace pulvis
