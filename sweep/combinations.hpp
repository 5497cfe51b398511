// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/overrides.hpp"

namespace pulvis::sweep {

/// A key of the case and the values it is to have, one after the other.
struct Factor {
  std::string key;
  std::vector<std::string> values;
};

/// Reads "powders.mo.coarse_graining=50,100"; commas within quotes and brackets belong to a value. Throws
/// Failure(Exit::usage) if that is no key with values, or a value stands there twice.
Factor factor_from(const std::string& text);

/// What is to be run: every case with every value of every factor and every seed.
struct Choice {
  std::vector<std::string> cases;  ///< files
  std::vector<Factor> factors;
  int seeds = 0;                 ///< seeds 1 to this; 0: each case has its own
  std::vector<Override> common;  ///< for all runs
};

/// One run.
struct Member {
  std::string name;  ///< made of the case's name and what is varied; the name of its folder
  std::string case_file;
  std::vector<Override> varied;    ///< what it has of each factor, the seed last
  std::vector<Override> settings;  ///< all it is run with: the common ones and then these
};

/// All combinations, the seed changing last, so that a sweep that is stopped has something of everything. No two
/// have the same name. Throws Failure(Exit::usage) if a case or a key is given twice.
std::vector<Member> combinations(const Choice& choice);

}  // namespace pulvis::sweep
