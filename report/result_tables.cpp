// SPDX-License-Identifier: Apache-2.0
#include "report/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

/// One window if all phases have the same, else each with its phase.
std::string windows_of(const std::vector<const PhaseData*>& phases, const std::string& measure) {
  std::vector<std::pair<std::string, std::string>> windows;
  for (const PhaseData* phase : phases)
    for (const Scalar& m : phase->measures)
      if (m.name == measure) windows.emplace_back(phase->name, m.window);
  const bool same = std::all_of(windows.begin(), windows.end(),
                                [&](const auto& w) { return w.second == windows[0].second; });
  if (same) return windows.empty() ? "" : windows[0].second;
  std::string text;
  for (const auto& [phase, window] : windows)
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", phase, window);
  return text;
}

}  // namespace

std::vector<Scalar> measures_of(const std::vector<const PhaseData*>& phases) {
  std::vector<Scalar> list;
  const auto is_new = [&](const Scalar& m) {
    return std::none_of(list.begin(), list.end(), [&](const Scalar& s) { return s.name == m.name; });
  };
  for (const PhaseData* phase : phases) {
    if (phase == nullptr) continue;  // a run of which nothing was measured
    for (const Scalar& m : phase->measures)
      if (is_new(m)) list.push_back(m);
  }
  return list;
}

std::vector<std::string> cells_of(const Scalar& measure, const std::vector<double>& values,
                                  std::string& unit) {
  const DisplayUnit shown = display_unit(values, measure.unit);
  unit = shown.name;
  std::vector<std::string> cells;
  for (const double v : values)
    cells.push_back(std::isfinite(v) ? fmt::format("{:.4g}", v * shown.factor) : "-");
  // A count has all its digits.
  if (measure.name.ends_with("_count"))
    for (std::size_t k = 0; k < values.size(); ++k)
      if (std::isfinite(values[k])) cells[k] = fmt::format("{:.15g}", values[k]);
  return cells;
}

void add_results(HtmlPage& page, const RunData& run) {
  std::vector<const PhaseData*> phases;
  for (const PhaseData& p : run.phases)
    if (!p.measures.empty()) phases.push_back(&p);
  if (phases.empty()) {
    page.paragraph("Nothing was measured: no phase has come to its end.");
    return;
  }
  std::vector<std::string> header{"measure", "unit"};
  for (const PhaseData* p : phases) header.push_back("after " + p->name);
  header.push_back("window");
  std::vector<HtmlPage::Row> rows;
  for (const Scalar& m : measures_of(phases)) {
    std::vector<double> values;
    for (const PhaseData* p : phases) values.push_back(p->measure(m.name));
    std::string unit;
    const std::vector<std::string> numbers = cells_of(m, values, unit);
    std::vector<std::string> cells{measure_words(m.name), unit};
    cells.insert(cells.end(), numbers.begin(), numbers.end());
    cells.push_back(windows_of(phases, m.name));
    rows.push_back({std::move(cells)});
  }
  page.table(header, rows);
  std::vector<HtmlPage::Row> ends;
  for (const PhaseData* p : phases)
    ends.push_back({{p->name, value_text(p->start, "s"), value_text(p->end, "s"), p->ended_by}});
  page.table({"phase", "from", "to", "ended by"}, ends);
}

void add_parts(HtmlPage& page, const RunData& run) {
  const PhaseData* last = run.last();
  if (!last || !last->detail || last->detail->parts.empty()) return;
  page.heading(fmt::format("Parts of the die after {}", last->name), 3);
  std::vector<HtmlPage::Row> rows;
  for (const Part& p : last->detail->parts)
    rows.push_back({{p.name, value_text(p.porosity, "1"), value_text(p.porosity_std, "1", 2),
                     value_text(p.density, "kg/m^3"), value_text(p.coordination, "1", 3),
                     value_text(p.volume, "m^3", 3)}});
  page.table({"part", "porosity", "its scatter", "apparent density", "contacts per parcel", "volume"}, rows);
}

}  // namespace pulvis::report
