// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/base/failure.hpp"
#include "engine/simulation/simulation.hpp"
#include "run/measuring.hpp"
#include "run/wall_results.hpp"

namespace pulvis {

/// How a phase went.
struct PhaseRecord {
  std::string name;
  double start = 0.0, end = 0.0;  ///< s
  std::string ended_by;
  std::vector<Measure> measures;
  std::vector<WallForce> walls;
};

/// How a run went.
struct RunSummary {
  Exit exit = Exit::ok;
  std::string reason;
  std::uint64_t resumes = 0;  ///< how often it was gone on with
  std::uint64_t particle_steps = 0;
  std::vector<PhaseRecord> phases;
  std::vector<std::string> notes;  ///< on meshes and motions
  std::vector<std::string> warnings;
};

/// What stands in result.json while the run goes on, and if it is killed.
RunSummary not_ended(RunSummary summary);
void add_warning(RunSummary& summary, const std::string& text);
/// `overlap` is the largest over the radius.
void warn_of_overlap(double overlap, RunSummary& summary);
/// Escapes that are an error need no warning: they are the reason for the end.
void warn_of_escapes(const Case& c, const State& state, RunSummary& summary);
/// "t = 0.1 s, position (...) m, speed ... m/s"
std::string text_of(const Escape& e);

/// What is printed at the end of a run, with the places of its results.
void print_summary(const Case& c, const std::string& folder, const RunSummary& summary,
                   const Simulation& simulation);

}  // namespace pulvis
