// SPDX-License-Identifier: Apache-2.0
#include "run/measure_results.hpp"

#include <nlohmann/json.hpp>

#include "output/result_json.hpp"
#include "run/measures_json.hpp"

namespace pulvis {
namespace {

std::vector<std::string> columns_of(const std::vector<Measure>& list) {
  std::vector<std::string> columns{"time_s", "phase"};
  for (const Measure& m : list) columns.push_back(column_of(m));
  return columns;
}

}  // namespace

std::string column_of(const Measure& measure) {
  if (measure.unit == "1") return measure.name;
  std::string unit;
  for (const char letter : measure.unit) {
    if (letter == '^') continue;
    unit += letter == '/' || letter == ' ' ? '_' : letter;
  }
  return measure.name + "_" + unit;
}

void MeasureResults::log(double time, const std::string& phase, const std::vector<Measure>& list) {
  if (!log_) {
    const std::string file = folder_.file("measures.csv");
    if (length_ > 0)
      log_.emplace(CsvLog::continued(file, columns_of(list), length_));
    else
      log_.emplace(file, columns_of(list));
  }
  std::vector<CsvCell> cells{time, std::string_view(phase)};
  for (const Measure& m : list) cells.push_back(m.value ? CsvCell(*m.value) : CsvCell(std::string_view()));
  log_->add(cells);
}

std::uint64_t MeasureResults::sync() { return log_ ? log_->sync() : length_; }

std::string MeasureResults::write_phase(double time, const std::string& phase,
                                        const std::vector<Measure>& list, const std::optional<DieSurvey>& die,
                                        const std::vector<FlowSince>& flow) {
  folder_.folder("measures");
  const std::string name = "measures/after-" + phase + ".json";
  write_json(folder_.file(name), measures_json(time, phase, list, die, flow));
  return name;
}

}  // namespace pulvis
