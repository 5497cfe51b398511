// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <fmt/format.h>

#include "report/case_words.hpp"
#include "report/document.hpp"
#include "report/judgement.hpp"
#include "report/pictures.hpp"
#include "report/quantity_text.hpp"
#include "report/result_tables.hpp"

namespace pulvis::report {
namespace {

std::vector<HtmlPage::Row> rows_of(const Words& words) {
  std::vector<HtmlPage::Row> rows;
  for (const auto& [what, text] : words) rows.push_back({{what, text}});
  return rows;
}

void add_state(HtmlPage& page, const RunData& run) {
  if (!run.ended)
    page.notice(fmt::format("This run has not come to its end: {}. The page shows what there is.",
                            run.reason.empty() ? "result.json does not say why" : run.reason));
  if (!run.missing.empty()) {
    page.notice("Some files of a complete run are missing in the folder; what they hold is left out here:");
    page.list(run.missing);
  }
}

void add_case(HtmlPage& page, const RunData& run) {
  page.heading("The case");
  if (run.the_case) {
    page.table({"", ""}, rows_of(case_words(*run.the_case)));
    page.heading("What is done", 3);
    Words phases;
    for (const Phase& p : run.the_case->phases)
      phases.emplace_back("phase " + p.name, phase_words(*run.the_case, p));
    for (const Motion& m : run.the_case->motions)
      phases.emplace_back("motion " + m.name, motion_words(run, m.name));
    page.table({"", ""}, rows_of(phases));
    if (!run.notes.empty()) page.list(run.notes);
    page.heading("What is simplified, and what that keeps", 3);
    page.list(simplifications(*run.the_case));
  } else {
    page.paragraph(fmt::format("The case cannot be put into words ({}); its keys:", run.case_problem));
    std::vector<HtmlPage::Row> rows;
    for (const Key& k : run.keys)
      if (k.origin != "default") rows.push_back({{k.name, k.value}});
    page.table({"key", "value"}, rows);
  }
  const std::vector<Assumed> assumed = assumed_values(run);
  if (assumed.empty()) return;
  page.heading("Values that are assumed", 3);
  page.paragraph("The case marks these as not known for this powder and die. Results depend on them.");
  std::vector<HtmlPage::Row> rows;
  for (const Assumed& a : assumed) rows.push_back({{a.key, a.value, a.comment}});
  page.table({"key", "value", ""}, rows);
}

void add_judgement(HtmlPage& page, const RunData& run) {
  page.heading("What came out");
  const Judgement j = judge(run);
  const auto add = [&](const char* title, const std::vector<std::string>& sentences) {
    if (sentences.empty()) return;
    page.heading(title, 3);
    page.list(sentences);
  };
  if (j.rules.empty()) page.paragraph("Nothing was measured, so there is nothing to judge.");
  add("How uniform", j.uniformity);
  add("From phase to phase", j.changes);
  if (!run.warnings.empty()) {
    page.heading("Warnings of the run", 3);
    for (const std::string& warning : run.warnings) page.notice(warning);
  }
  add("What to try next", j.to_try);
  if (j.rules.empty()) return;
  page.heading("The rules behind these sentences", 3);
  page.table({"what is said", "when"}, rows_of(j.rules));
}

void add_pictures(HtmlPage& page, const RunData& run) {
  page.heading("Pictures");
  std::vector<PageImage> images;
  for (const PictureName& name : last_pictures()) images.push_back(picture_of(run, name));
  for (const PictureName& name : phase_pictures(run)) images.push_back(picture_of(run, name));
  page.images(images);
}

}  // namespace

std::vector<std::string> write_report(const std::string& folder, std::string out) {
  const RunData run = read_run(folder);
  if (out.empty()) out = run.file("report.html");
  Document document(out, run.title);
  HtmlPage& page = document.page();
  add_state(page, run);
  page.contents();
  add_case(page, run);
  add_judgement(page, run);
  page.heading("Results");
  add_results(page, run);
  add_parts(page, run);
  add_pictures(page, run);
  Beside phases;
  for (const PhaseData& p : run.phases) phases.push_back({p.name, &p});
  const Beside last = run.last() ? Beside{{run.last()->name, run.last()}} : Beside{};
  add_figures(document, last, phases, {&run});
  page.heading("The run's own numbers");
  page.table({"", ""}, rows_of(run.numbers));
  page.paragraph(fmt::format("Page made by pulvis {} from the folder {}.", PULVIS_VERSION, run.label));
  document.write();
  return document.warnings();
}

}  // namespace pulvis::report
