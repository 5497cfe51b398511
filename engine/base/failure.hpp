// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
#include <string>

namespace pulvis {

/// How the program ends; the numbers are a promise to scripts (see README).
enum class Exit : int {
  ok = 0,
  unexpected = 1,      ///< a fault of the program
  usage = 2,           ///< command line, or a results folder already in use
  bad_case = 3,        ///< the case file is invalid
  bad_input = 4,       ///< an input file is unreadable or damaged
  physics = 5,         ///< NaN, lost parcel, runaway
  io = 6,              ///< results cannot be written
  internal_check = 7,  ///< the program found itself wrong (a ledger that does not balance)
  target_missed = 8,   ///< an acceptance or calibration target
  interrupted = 75,    ///< stopped on request with a state to continue from
  cancelled = 130,     ///< Ctrl-C, results valid up to then
};

/// An error meant for the user: `what()` says what happened, where, and what to do about it.
class Failure : public std::runtime_error {
 public:
  Failure(Exit code, const std::string& message) : std::runtime_error(message), code_(code) {}
  Exit code() const { return code_; }

 private:
  Exit code_;
};

}  // namespace pulvis
