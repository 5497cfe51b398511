// SPDX-License-Identifier: Apache-2.0
#include "study/report.hpp"

#include <fmt/format.h>

#include "output/html_page.hpp"
#include "output/safe_file.hpp"

namespace pulvis::study {
namespace {

using validation::Findings;
using validation::Row;

std::string limit_text(const Row& row) { return row.limit ? fmt::format("{:.3g}", *row.limit) : "-"; }
std::string verdict(const Row& row) { return !row.limit ? "reported" : row.passed() ? "pass" : "FAIL"; }

std::string page_text(const Study& study, const Findings& findings) {
  HtmlPage page(study.title);
  page.paragraph(study.text);
  page.paragraph(fmt::format("Made by pulvis {}: pulvis study {}. Every number stands in study.json.",
                             PULVIS_VERSION, study.name));
  if (can_draw_figures()) {
    for (const Figure& figure : findings.figures()) page.image(figure_svg(figure), figure.title);
  } else {
    page.notice(
        "The figures are missing: gnuplot (Debian: gnuplot-nox) was not found. Their points lie beside this "
        "page as CSV.");
  }
  std::vector<HtmlPage::Row> rows;
  for (const Row& row : findings.rows())
    rows.push_back(
        {{row.name, row.source, fmt::format("{:.6g}", row.reference), fmt::format("{:.6g}", row.value),
          fmt::format("{:.2e}", row.deviation), limit_text(row), verdict(row)},
         !row.limit     ? ""
         : row.passed() ? "good"
                        : "bad"});
  page.table({"quantity", "reference from", "reference", "ours", "deviation", "limit", ""}, rows);
  return page.text();
}

}  // namespace

std::string table_text(const Findings& findings) {
  std::string text = fmt::format("{:<86} {:>12} {:>12} {:>10} {:>8}\n", "quantity", "reference", "ours",
                                 "deviation", "limit");
  for (const Row& row : findings.rows())
    text += fmt::format("{:<86} {:>12.5g} {:>12.5g} {:>10.2e} {:>8} {}\n", row.name, row.reference, row.value,
                        row.deviation, limit_text(row), verdict(row));
  return text;
}

std::string json_text(const Study& study, const std::vector<Done>& points, const Findings& findings) {
  Json rows = Json::array(), list = Json::array();
  for (const Row& row : findings.rows()) {
    rows.push_back({{"quantity", row.name},
                    {"source", row.source},
                    {"value", row.value},
                    {"reference", row.reference},
                    {"deviation", row.deviation},
                    {"limit", nullptr},
                    {"passed", row.passed()}});
    if (row.limit) rows.back()["limit"] = *row.limit;
  }
  for (const Done& done : points)
    list.push_back({{"name", done.point.name}, {"settings", done.point.settings}, {"result", done.result}});
  return Json{{"version", PULVIS_VERSION},
              {"study", study.name},
              {"passed", findings.passed()},
              {"rows", rows},
              {"points", list}}
             .dump(1) +
         "\n";
}

void write_report(const std::string& folder, const Study& study, const std::vector<Done>& points,
                  const Findings& findings) {
  for (const Figure& figure : findings.figures()) {
    if (can_draw_figures())
      write_figure(folder, figure);
    else
      write_file_safely(folder + "/" + figure.name + ".csv", figure_csv(figure));
  }
  write_file_safely(folder + "/study.html", page_text(study, findings));
  write_file_safely(folder + "/study.json", json_text(study, points, findings));
}

}  // namespace pulvis::study
