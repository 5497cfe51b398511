// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "sweep/combinations.hpp"

namespace pulvis::sweep {

/// What identifies one run of a sweep in sweep.json.
struct RecordedRun {
  std::string name;
  std::string case_file;  ///< absolute; it may be given from elsewhere the next time
  std::vector<Override> varied;
  std::string
      checksum;  ///< of all keys on which the course of the run depends, files that the case names too
};

/// Reads each run's case as it will be run, before any is started. Throws as read_case does, naming the run.
std::vector<RecordedRun> record_of(const std::vector<Member>& members);

/// sweep.json. Throw Failure(Exit::io), and Failure(Exit::bad_input) for a file that is no such record.
void write_record(const std::string& file, const std::vector<RecordedRun>& runs);
std::vector<RecordedRun> read_record(const std::string& file);

/// A line for each run that is in one list only, or is another run in the other.
std::vector<std::string> differences(const std::vector<RecordedRun>& before,
                                     const std::vector<RecordedRun>& now);

}  // namespace pulvis::sweep
