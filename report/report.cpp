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

/// After each phase, what `has` finds something in.
template <class Has>
Beside phases_with(const RunData& run, const Has& has) {
  Beside list;
  for (const PhaseData& p : run.phases)
    if (has(p)) list.push_back({p.name, &p});
  return list;
}

void add_figures(Document& document, const RunData& run) {
  HtmlPage& page = document.page();
  const Beside detailed = phases_with(run, [](const PhaseData& p) { return p.detail.has_value(); });
  const Beside pressed = phases_with(run, [](const PhaseData& p) { return p.wall_pressure.has_value(); });
  const Beside last = detailed.empty() ? Beside{} : Beside{detailed.back()};
  page.heading("Where it is dense and where loose");
  document.show(porosity_cuts(last), "No map of the porosity was measured.");
  if (detailed.size() > 1) document.show(porosity_upright_cuts(detailed), "");
  document.show(porosity_profiles(detailed), "No profiles of the porosity were measured.");
  document.show(porosity_histogram(detailed), "No histogram of the porosity was measured.");
  page.heading("The surface of the powder");
  document.show(surface_maps(detailed), "The surface was not measured.");
  document.show(surface_profiles(detailed), "There are no profiles of the surface.");
  page.heading("Pressure on the walls");
  document.show(wall_pressure_maps(pressed), "No wall bore any pressure, or it was not measured.");
  page.heading("Contacts");
  document.show(coordination_histogram(detailed), "Contacts were not counted.");
  document.show(contact_force_distribution(detailed), "Contact forces were not measured.");
  page.heading("Layers");
  document.show(layer_profiles(detailed), "No layers were measured.");
  page.heading("Over time");
  document.show(time_series({&run}), "There is no log and no measures over time.");
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
  add_figures(document, run);
  page.heading("The run's own numbers");
  page.table({"", ""}, rows_of(run.numbers));
  page.paragraph(fmt::format("Page made by pulvis {} from the folder {}.", PULVIS_VERSION, run.label));
  document.write();
  return document.warnings();
}

}  // namespace pulvis::report
