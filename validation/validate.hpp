// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/base/failure.hpp"

namespace pulvis::validation {

struct Request {
  bool quick = false;
  std::vector<std::string> only;  ///< chapters; empty: all
  std::string out;                ///< folder for validation.html and the figures' points; empty: none
  std::string json;               ///< file; empty: none
  int threads = 0;                ///< chapters that run side by side; set before validate()
};

/// Runs the chapters, prints their table, writes page and JSON. Returns Exit::ok if every comparison with a
/// limit keeps it, Exit::target_missed if not. Throws Failure(usage) for a chapter that does not exist and
/// Failure(io) where a file cannot be written, before anything is run if its folder cannot be made.
Exit validate(const Request& request);

}  // namespace pulvis::validation
