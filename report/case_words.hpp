// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "report/run_data.hpp"

namespace pulvis::report {

/// A line of a table in words: what, and what it is.
using Words = std::vector<std::pair<std::string, std::string>>;

/// Powder, die, walls, contact law and process of a case.
Words case_words(const Case& c);

/// What a phase does and when it ends.
std::string phase_words(const Case& c, const Phase& phase);

/// A motion by the keys that the case has for it: "sine: frequency 10 Hz, ...".
std::string motion_words(const RunData& run, const std::string& motion);

/// What the simulation replaces by something else, and what that keeps: coarse graining, softening, no air,
/// spheres.
std::vector<std::string> simplifications(const Case& c);

/// Keys that the case marks by ASSUMED in the comment beside them, with value and comment.
struct Assumed {
  std::string key, value, comment;
};
std::vector<Assumed> assumed_values(const RunData& run);

}  // namespace pulvis::report
