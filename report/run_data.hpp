// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "report/csv_table.hpp"
#include "report/measures_file.hpp"

namespace pulvis::report {

/// A phase of a run, with all that was measured at its end.
struct PhaseData {
  std::string name;
  double start = 0.0, end = 0.0;  ///< s
  std::string ended_by;
  std::vector<Scalar> measures;
  std::optional<MeasuresFile> detail;
  std::optional<CsvTable> wall_pressure;

  /// NaN if it was not measured.
  double measure(const std::string& name) const;
};

/// A key of the case as the run used it.
struct Key {
  std::string name, value, origin, comment{};
};

/// A run folder as it was read.
struct RunData {
  std::string folder, label;  ///< label: what figures and tables call it
  std::string title, version;
  bool ended = false;  ///< completed; else `reason` says what became of it
  std::string reason;
  std::vector<PhaseData> phases;
  std::vector<std::pair<std::string, std::string>> numbers;  ///< the run's own numbers, in words
  double parcels = 0.0, wall_time = 0.0;                     ///< -, s; NaN: unknown
  double largest_overlap = 0.0;                              ///< over the radius; NaN: unknown
  std::vector<std::string> notes, warnings;
  std::vector<Key> keys;
  std::optional<Case> the_case;
  std::string case_problem;  ///< why there is none
  std::optional<CsvTable> log, series;
  std::vector<std::string> missing;  ///< files that a complete run has, with what they are for

  /// The last phase of which anything was measured; none if there is none.
  const PhaseData* last() const;
  std::optional<Die> die() const;
  std::string file(const std::string& name) const { return folder + "/" + name; }
  const Key* key(const std::string& name) const;
};

/// Reads the folder of a run that has ended, or as much as there is of one that has not. Throws
/// Failure(Exit::bad_input) if it is no run folder or a file in it is damaged, naming the file.
RunData read_run(const std::string& folder);

}  // namespace pulvis::report
