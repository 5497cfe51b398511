// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "output/csv.hpp"
#include "output/run_folder.hpp"
#include "run/flow_meters.hpp"
#include "run/measuring.hpp"

namespace pulvis {

/// Files on what is measured: measures.csv, a line for each look, and measures/after-PHASE.json. Their form:
/// docs/measures-format.md.
class MeasureResults {
 public:
  /// Goes on with measures.csv as it was when it had `length` bytes; 0: a new one, when there is a line.
  MeasureResults(const RunFolder& folder, std::uint64_t length) : folder_(folder), length_(length) {}

  /// The list must have the same measures in each call.
  void log(double time, const std::string& phase, const std::vector<Measure>& list);
  /// Brings measures.csv to the disk; its length in bytes, 0 if there is none yet.
  std::uint64_t sync();
  /// Returns the name of the file in the folder.
  std::string write_phase(double time, const std::string& phase, const std::vector<Measure>& list,
                          const std::optional<DieSurvey>& die, const std::vector<FlowSince>& flow);

 private:
  const RunFolder& folder_;
  std::uint64_t length_;
  std::optional<CsvLog> log_;
};

/// "fill_mass_kg": the measure with its unit, as a column's name.
std::string column_of(const Measure& measure);

}  // namespace pulvis
