// SPDX-License-Identifier: Apache-2.0
#include "sweep/result_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "output/csv.hpp"
#include "sweep/run_state.hpp"

namespace pulvis::sweep {
namespace {

using Json = nlohmann::ordered_json;

struct Row {
  const Member* member;
  std::string state;
  Json result;

  std::optional<double> number(const char* key) const { return number_of(result, key); }
  std::optional<double> measure(const std::string& name) const {
    if (!result.contains("measures") || !result["measures"].contains(name)) return {};
    return number_of(result["measures"][name], "value");
  }

 private:
  static std::optional<double> number_of(const Json& json, const char* key) {
    if (!json.is_object() || !json.contains(key) || !json[key].is_number()) return {};
    return json[key].get<double>();
  }
};

std::string text_of(const Outcome& outcome) {
  switch (outcome.state) {
    case Outcome::State::complete:
      return "complete";
    case Outcome::State::failed:
      return fmt::format("failed ({})", outcome.exit);
    case Outcome::State::stopped:
      return "stopped";
    case Outcome::State::not_started:
      return "not started";
  }
  return "";
}

std::vector<Row> rows_of(const std::vector<Member>& members, const std::vector<Task>& tasks,
                         const std::vector<Outcome>& outcomes) {
  std::vector<Row> rows;
  for (std::size_t k = 0; k < members.size(); ++k) {
    // What a run left that has not ended would look like its result.
    const bool complete = outcomes[k].state == Outcome::State::complete;
    rows.push_back(
        {&members[k], text_of(outcomes[k]), complete ? result_in(tasks[k].folder) : Json::object()});
  }
  return rows;
}

// In the order in which they first stand.
std::vector<std::string> measures_of(const std::vector<Row>& rows, std::vector<std::string>& columns) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const Row& row : rows) {
    if (!row.result.contains("measures")) continue;
    for (const auto& [name, measure] : row.result["measures"].items()) {
      if (!seen.insert(name).second) continue;
      names.push_back(name);
      std::string unit = measure.is_object() ? measure.value("unit", "1") : "1";
      for (char& c : unit)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))) c = '_';
      columns.push_back(unit == "1" ? name : name + "_" + unit);
    }
  }
  return names;
}

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : "-"; }

}  // namespace

std::string table_text(const std::vector<Member>& members, const std::vector<Task>& tasks,
                       const std::vector<Outcome>& outcomes) {
  const std::vector<Row> rows = rows_of(members, tasks, outcomes);
  // The name says what was varied.
  std::vector<std::vector<std::string>> lines{
      {"run", "state", "parcels", "time s", "porosity", "std", "mass g", "height mm", "pressure kPa"}};
  const auto scaled = [](std::optional<double> value, double factor) {
    return cell(value ? std::optional(*value * factor) : std::nullopt);
  };
  for (const Row& row : rows) {
    const auto parcels = row.number("particles");
    lines.push_back({row.member->name, row.state, parcels ? fmt::format("{:.0f}", *parcels) : "-",
                     cell(row.number("wall_time_s")), cell(row.measure("porosity_mean")),
                     cell(row.measure("porosity_std")), scaled(row.measure("fill_mass"), 1e3),
                     scaled(row.measure("free_surface_height_mean"), 1e3),
                     scaled(row.measure("wall_pressure_max"), 1e-3)});
  }
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t column = 0; column < line.size(); ++column) {
      std::size_t width = 0;
      for (const auto& other : lines) width = std::max(width, other[column].size());
      text += column < 2
                  ? fmt::format("{:<{}}  ", line[column], width)
                  : fmt::format("{:>{}}{}", line[column], width, column + 1 == line.size() ? "\n" : "  ");
    }
  }
  return text;
}

void write_table(const std::string& file, const std::vector<Member>& members, const std::vector<Task>& tasks,
                 const std::vector<Outcome>& outcomes) {
  const std::vector<Row> rows = rows_of(members, tasks, outcomes);
  std::vector<std::string> columns{"run", "case"};
  const std::size_t factors = members.empty() ? 0 : members.front().varied.size();
  for (std::size_t k = 0; k < factors; ++k) columns.push_back(members.front().varied[k].key);
  columns.insert(columns.end(), {"state", "parcels", "wall_time_s"});
  const std::vector<std::string> measures = measures_of(rows, columns);
  CsvTable table(columns);
  for (const Row& row : rows) {
    std::vector<CsvCell> cells{row.member->name, row.member->case_file};
    const auto append = [&](const std::optional<double>& value) {
      cells.push_back(value ? CsvCell(*value) : CsvCell(std::string_view()));
    };
    for (const Override& o : row.member->varied) cells.push_back(o.value);
    cells.push_back(row.state);
    append(row.number("particles"));
    append(row.number("wall_time_s"));
    for (const std::string& name : measures) append(row.measure(name));
    table.add(cells);
  }
  table.save(file);
}

}  // namespace pulvis::sweep
