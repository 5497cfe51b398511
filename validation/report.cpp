// SPDX-License-Identifier: Apache-2.0
#include "validation/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "output/html_page.hpp"

namespace pulvis::validation {
namespace {

std::string limit_text(const Row& row) { return row.limit ? fmt::format("{:.1e}", *row.limit) : "-"; }
std::string verdict(const Row& row) { return !row.limit ? "reported" : row.passed() ? "pass" : "FAIL"; }
std::string automatic_text(const Row& row) {
  return row.automatic ? fmt::format("{:.6g}", *row.automatic) : "";
}

std::size_t failures(const Findings& f) {
  return static_cast<std::size_t>(
      std::count_if(f.rows().begin(), f.rows().end(), [](const Row& r) { return !r.passed(); }));
}

/// In words: how many comparisons, how many failed.
std::string summary(const Findings& f) {
  const auto judged = std::count_if(f.rows().begin(), f.rows().end(), [](const Row& r) { return r.limit; });
  return fmt::format("{} comparisons with a limit, {} without, {} failed", judged,
                     f.rows().size() - static_cast<std::size_t>(judged), failures(f));
}

}  // namespace

std::string table_text(const std::vector<Result>& results) {
  std::string text;
  for (const Result& r : results) {
    text += fmt::format("\n{} ({}): {}, {:.1f} s\n", r.chapter->title, r.chapter->name, summary(r.findings),
                        r.seconds);
    text += fmt::format("  {:<74} {:>13} {:>13} {:>10} {:>8} {:<8} {}\n", "quantity", "reference", "ours",
                        "deviation", "limit", "", "at automatic step");
    for (const Row& row : r.findings.rows())
      text += fmt::format("  {:<74} {:>13.6g} {:>13.6g} {:>10.2e} {:>8} {:<8} {}\n", row.name, row.reference,
                          row.value, row.deviation, limit_text(row), verdict(row), automatic_text(row));
  }
  return text;
}

std::string json_text(const std::vector<Result>& results) {
  // A number that is not one becomes null when it is written: it never passes.
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Result& r : results)
    for (const Row& row : r.findings.rows()) {
      nlohmann::ordered_json entry{
          {"chapter", r.chapter->name}, {"name", row.name},     {"source", row.source},
          {"reference", row.reference}, {"value", row.value},   {"deviation", row.deviation},
          {"limit", nullptr},           {"pass", row.passed()}, {"value_at_automatic_step", nullptr}};
      if (row.limit) entry["limit"] = *row.limit;
      if (row.automatic) entry["value_at_automatic_step"] = *row.automatic;
      rows.push_back(entry);
    }
  return nlohmann::ordered_json{{"version", PULVIS_VERSION}, {"rows", rows}}.dump(1) + "\n";
}

std::string page_text(const std::vector<Result>& results, bool quick) {
  HtmlPage page(fmt::format("Validation of pulvis {}", PULVIS_VERSION));
  page.paragraph(fmt::format(
      "{} Each row sets a quantity against a reference and says where that comes from. A deviation is "
      "relative where the reference is a size, absolute where it is an angle, a ratio or zero. Limits hold "
      "at "
      "a time step of a thousandth of the contact time (with adhesion also so small that a step at the "
      "collision's speed stays below a hundredth of the stretch at rupture); the last column shows the same "
      "quantity at the time step that a case would be given.",
      quick ? "The quick form." : "The full form."));
  std::vector<HtmlPage::Row> overview;
  for (const Result& r : results)
    overview.push_back({{std::string(r.chapter->title), summary(r.findings), fmt::format("{:.1f}", r.seconds),
                         r.findings.passed() ? "pass" : "FAIL"},
                        r.findings.passed() ? "good" : "bad"});
  page.table({"chapter", "comparisons", "seconds", ""}, overview);
  const bool drawing = can_draw_figures();
  if (!drawing)
    page.paragraph(
        "The figures are missing: gnuplot (Debian: gnuplot-nox) was not found. Their points lie beside "
        "this page as CSV.");
  for (const Result& r : results) {
    page.heading(r.chapter->title);
    page.paragraph(r.chapter->text);
    if (drawing)
      for (const Figure& figure : r.findings.figures()) page.image(figure_svg(figure), figure.title);
    std::vector<HtmlPage::Row> rows;
    for (const Row& row : r.findings.rows())
      rows.push_back(
          {{row.name, row.source, fmt::format("{:.9g}", row.reference), fmt::format("{:.9g}", row.value),
            fmt::format("{:.2e}", row.deviation), limit_text(row), automatic_text(row), verdict(row)},
           row.passed() ? "good" : "bad"});
    page.table(
        {"quantity", "reference from", "reference", "ours", "deviation", "limit", "at automatic step", ""},
        rows);
  }
  return page.text();
}

bool all_passed(const std::vector<Result>& results) {
  return !results.empty() &&
         std::all_of(results.begin(), results.end(), [](const Result& r) { return r.findings.passed(); });
}

}  // namespace pulvis::validation
