// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "case/overrides.hpp"
#include "validation/findings.hpp"

namespace pulvis::study {

using Json = nlohmann::ordered_json;

/// What the command line says about a study.
struct Options {
  bool quick = false;              ///< minutes instead of up to hours
  std::vector<double> factors;     ///< of coarse graining; empty: the study's own
  int seeds = 0;                   ///< seeds 1 to this, for studies with chance in them; 0: the study's own
  std::string case_file;           ///< only for studies that take one
  std::vector<Override> settings;  ///< for that case
};

/// One independent computation of a study.
struct Point {
  std::string
      name;       ///< of its folder: letters, digits, dots, hyphens; no two points of a study have the same
  Json settings;  ///< all that its computation depends on
};

/// What the computation of a point is given. It runs in a process of its own.
struct Work {
  const Json& settings;
  std::string folder;  ///< its own; what an interrupted computation left there is still in it
  int threads;         ///< that it may use
};

/// A point that has been computed.
struct Done {
  Point point;
  Json result;  ///< what compute() gave
};

/// A list of points and what follows from them. To add one: see CONTRIBUTING.
struct Study {
  const char* name;   ///< for the command line
  const char* title;  ///< of its page
  const char* text;   ///< what is computed, what it is set against, and how
  bool takes_case;    ///< a case file of the user's

  /// The points, those that take longest first. Must give the same points for the same options: an interrupted study
  /// is gone on with by them. Throws Failure(usage or bad_case) for options that make no sense.
  std::vector<Point> (*points)(const Options&);
  /// Computes one point. Its numbers must be finite. What takes more than a second looks at signal_to_stop(), and
  /// throws Stopped when it is not 0; see run_of_case for runs.
  Json (*compute)(const Work&);
  /// Draws conclusions from all points, in the order of points(): rows with and without limits, figures.
  void (*conclude)(const std::vector<Done>&, validation::Findings&);
};

/// All studies, for the command line.
const std::vector<Study>& studies();

/// Thrown by a computation that was asked to stop; what it left in its folder is kept.
struct Stopped {};

}  // namespace pulvis::study
