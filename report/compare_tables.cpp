// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/compare.hpp"
#include "report/quantity_text.hpp"
#include "report/result_tables.hpp"

namespace pulvis::report {
namespace {

std::vector<std::string> header_of(const std::vector<RunData>& runs, std::vector<std::string> header) {
  for (const RunData& run : runs) header.push_back(run.label);
  return header;
}

std::string key_of(const RunData& run, const std::string& name) {
  const Key* key = run.key(name);
  return key ? key->value : "-";
}

}  // namespace

void add_differing_keys(HtmlPage& page, const std::vector<RunData>& runs) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const RunData& run : runs)
    for (const Key& key : run.keys)
      if (known.insert(key.name).second) names.push_back(key.name);
  std::vector<HtmlPage::Row> rows;
  for (const std::string& name : names) {
    std::vector<std::string> cells{name};
    std::set<std::string> values;
    for (const RunData& run : runs) {
      cells.push_back(key_of(run, name));
      values.insert(cells.back());
    }
    if (values.size() > 1) rows.push_back({std::move(cells)});
  }
  page.heading("How the cases differ");
  if (rows.empty())
    page.paragraph("All keys of the cases have the same values, as far as they are known.");
  else
    page.table(header_of(runs, {"key"}), rows);
}

void add_measures(HtmlPage& page, const std::vector<RunData>& runs,
                  const std::vector<const PhaseData*>& last) {
  page.heading("Results");
  std::string words;
  for (std::size_t k = 0; k < runs.size(); ++k)
    words += fmt::format("{}{}: {}", k ? "; " : "", runs[k].label,
                         last[k] ? "after \"" + last[k]->name + "\"" : "nothing was measured");
  page.paragraph(fmt::format(
      "At the end of the last phase of each run ({}). In brackets: against the first run.", words));
  std::vector<const PhaseData*> measured;
  for (const PhaseData* p : last)
    if (p) measured.push_back(p);
  std::vector<HtmlPage::Row> rows;
  for (const Scalar& m : measures_of(measured)) {
    std::vector<double> values;
    for (const PhaseData* p : last) values.push_back(p ? p->measure(m.name) : std::nan(""));
    std::string unit;
    std::vector<std::string> numbers = cells_of(m, values, unit);
    for (std::size_t k = 1; k < values.size(); ++k)
      if (values[k] == values[0])
        numbers[k] += " (=)";
      else if (std::isfinite(values[k]) && std::isfinite(values[0]) && values[0] != 0.0)
        numbers[k] += fmt::format(" ({})", percent_more(1.0 + (values[k] - values[0]) / std::abs(values[0])));
    std::vector<std::string> cells{measure_words(m.name), unit};
    cells.insert(cells.end(), numbers.begin(), numbers.end());
    rows.push_back({std::move(cells)});
  }
  page.table(header_of(runs, {"measure", "unit"}), rows);
}

void add_costs(HtmlPage& page, const std::vector<RunData>& runs) {
  page.heading("The runs' own numbers");
  std::vector<std::string> names;
  for (const RunData& run : runs)
    for (const auto& [name, text] : run.numbers)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  std::vector<HtmlPage::Row> rows;
  for (const std::string& name : names) {
    std::vector<std::string> cells{name};
    for (const RunData& run : runs) {
      cells.push_back("-");
      for (const auto& [known, text] : run.numbers)
        if (known == name) cells.back() = text;
    }
    rows.push_back({std::move(cells)});
  }
  page.table(header_of(runs, {""}), rows);
}

}  // namespace pulvis::report
