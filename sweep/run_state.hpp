// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace pulvis::sweep {

/// How far a run in a folder is.
enum class Standing {
  new_run,     ///< nothing is there
  broken_off,  ///< something is there, but nothing to go on from
  resumable,   ///< there is a checkpoint
  complete,
};

Standing standing_of(const std::string& folder);

/// What stands in its result.json; an empty object if there is none that can be read.
nlohmann::ordered_json result_in(const std::string& folder);

/// The line of a log, from `start` bytes on, that says why a run ended: the last one by the program itself, or
/// the last at all.
std::string telling_line(const std::string& log, std::uint64_t start);

}  // namespace pulvis::sweep
