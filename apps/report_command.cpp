// SPDX-License-Identifier: Apache-2.0
#include "apps/report_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace pulvis {

void add_report_commands(CLI::App& app) {
  auto* report =
      app.add_subcommand("report", "make one page of a run: results, judgement, pictures, figures");
  report->add_option("DIR", "folder of a run")->required();
  report->add_option(
      "--out",
      "the page to write; default: DIR/report.html. Its figures lie beside it, in a folder of its "
      "name");
  report->footer(
      "The page is one HTML file without scripts that opens from disk. Figures need gnuplot; without it the "
      "page\n"
      "is written with their data beside it.\n"
      "Example: pulvis report results");
  auto* compare =
      app.add_subcommand("compare", "make one page of several runs of one die, in the same scales");
  compare->add_option("DIR", "folders of runs")->required()->expected(1, -1)->allow_extra_args(true);
  compare->add_option("--out", "folder for comparison.html and its figures")->required();
  compare->footer(
      "Runs that differ only in their seed form groups: the page has their means and scatter, and says "
      "whether groups\n"
      "differ beyond it.\n"
      "Example: pulvis compare gentle hard --out comparison");
}

std::string make_report(const std::string& folder) {
  const std::string page = (std::filesystem::path(folder) / "report.html").string();
  for (const std::string& warning : report::write_report(folder, page))
    fmt::print(stderr, "warning: {}\n", warning);
  return page;
}

std::optional<Exit> run_report_command(const CLI::App& app) {
  const auto text = [](const CLI::App* command, const char* option) {
    return command->count(option) ? command->get_option(option)->as<std::string>() : std::string();
  };
  std::vector<std::string> warnings;
  std::string page;
  if (const auto* report = app.get_subcommand("report"); *report) {
    const std::string folder = text(report, "DIR"), out = text(report, "--out");
    page = out.empty() ? (std::filesystem::path(folder) / "report.html").string() : out;
    warnings = report::write_report(folder, page);
  } else if (const auto* compare = app.get_subcommand("compare"); *compare) {
    const std::string out = text(compare, "--out");
    page = (std::filesystem::path(out) / "comparison.html").string();
    warnings = report::write_comparison(compare->get_option("DIR")->as<std::vector<std::string>>(), out);
  } else {
    return {};
  }
  for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
  fmt::print("{}\n", page);
  return Exit::ok;
}

}  // namespace pulvis
