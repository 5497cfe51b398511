// SPDX-License-Identifier: Apache-2.0
#include "report/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "engine/base/failure.hpp"
#include "report/quantity_text.hpp"
#include "report/report.hpp"

namespace pulvis::report {
namespace {

/// Names of folders where they are unlike, else the paths as given.
void label(std::vector<RunData>& runs) {
  std::map<std::string, int> times;
  for (const RunData& run : runs) ++times[run.label];
  for (RunData& run : runs)
    if (times[run.label] > 1) run.label = run.folder;
}

std::string die_words(const Die& die) {
  std::string text = die.shape;
  for (std::size_t k = 0; k < die.size.size(); ++k)
    text += (k ? " x " : " of ") + value_text(die.size[k], "m", 6);
  return text;
}

bool same_die(const Die& a, const Die& b) {
  const auto alike = [](double x, double y) {
    return std::abs(x - y) <= 1e-9 * std::max(std::abs(x), std::abs(y));
  };
  return a.shape == b.shape && std::equal(a.size.begin(), a.size.end(), b.size.begin(), b.size.end(), alike);
}

void require_one_die(const std::vector<RunData>& runs) {
  const RunData* first = nullptr;
  for (const RunData& run : runs) {
    if (!run.die()) continue;
    if (!first) first = &run;
    if (!same_die(*first->die(), *run.die()))
      throw Failure(Exit::usage,
                    fmt::format("the runs have different dies: {} a {}, {} a {}. Their maps and profiles "
                                "cannot be set side by side; compare runs of one die",
                                first->folder, die_words(*first->die()), run.folder, die_words(*run.die())));
  }
}

void add_runs(HtmlPage& page, const std::vector<RunData>& runs) {
  std::vector<HtmlPage::Row> rows;
  for (const RunData& run : runs)
    rows.push_back(
        {{run.label, run.title, std::isfinite(run.parcels) ? fmt::format("{:.15g}", run.parcels) : "-",
          value_text(run.wall_time, "s"), run.ended ? "completed" : run.reason},
         run.ended ? "" : "bad"});
  page.table({"run", "title", "parcels", "time on the clock", "end"}, rows);
  for (const RunData& run : runs) {
    if (!run.ended) page.notice(fmt::format("{} has not come to its end: {}.", run.label, run.reason));
    for (const std::string& file : run.missing) page.notice(fmt::format("{} lacks {}.", run.label, file));
  }
}

}  // namespace

std::vector<std::string> write_comparison(const std::vector<std::string>& folders, const std::string& out) {
  if (folders.size() < 2)
    throw Failure(Exit::usage, "a comparison needs at least two run folders; for one run: pulvis report DIR");
  std::vector<RunData> runs;
  for (const std::string& folder : folders) runs.push_back(read_run(folder));
  label(runs);
  require_one_die(runs);
  std::vector<const PhaseData*> last;
  for (const RunData& run : runs) last.push_back(run.last());
  Document document((std::filesystem::path(out) / "comparison.html").string(),
                    fmt::format("Comparison of {} runs", runs.size()));
  HtmlPage& page = document.page();
  add_runs(page, runs);
  page.contents();
  add_differing_keys(page, runs);
  add_measures(page, runs, last);
  add_groups(page, runs, last);
  add_compared_figures(document, runs, last);
  add_compared_pictures(page, runs);
  add_costs(page, runs);
  page.paragraph(fmt::format("Page made by pulvis {}.", PULVIS_VERSION));
  document.write();
  return document.warnings();
}

}  // namespace pulvis::report
