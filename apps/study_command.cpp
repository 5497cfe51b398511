// SPDX-License-Identifier: Apache-2.0
#include "apps/study_command.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "apps/options.hpp"
#include "study/conduct.hpp"

namespace pulvis {

void add_study_command(CLI::App& app) {
  auto* study = app.add_subcommand("study", "find out how much a coarser powder changes");
  std::string list = "Studies:";
  for (const auto& s : study::studies()) list += fmt::format("\n  {:<14} {}", s.name, s.title);
  study->footer(
      list +
      "\nExample: pulvis study collision --out collision\n"
      "Computes the points of the study side by side and leaves study.html, study.json, figures, and\n"
      "points/NAME of each. Ctrl-C or SIGTERM stop it; then, or after a crash, the same command goes on:\n"
      "complete points are kept. Exit code 8 if a limit is not kept.");
  study->add_option("NAME", "one of the studies below")->required();
  study->add_option("CASE", "case file (TOML), for studies that take one");
  study->add_option("--out", "folder for points and results")->required();
  study->add_flag("--quick")->description("fewer and smaller points: minutes");
  study->add_option("--factors", "factors of coarse graining, like 8,6,4; default: the study's own")
      ->delimiter(',')
      ->expected(1, 1000)
      ->allow_extra_args(false)
      ->check(CLI::Range(1.0, 1e6));
  study->add_option("--seeds", "the seeds 1 to N, where chance matters; default: the study's own")
      ->check(CLI::Range(1, 10000));
  study->add_option("--set", "override a key of CASE: --set key.path=value (repeatable)")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  study->add_option("--jobs", "points at once; default: processors over threads")->check(CLI::Range(1, 1024));
  study
      ->add_option("--threads",
                   "threads of each point; default: 1, or more if there are fewer points than processors")
      ->check(CLI::Range(1, 1024));
  study->add_option("--point", "compute this point of the study in the folder, and nothing else")->group("");
}

std::optional<Exit> run_study_command(const CLI::App& app) {
  const CLI::App* command = app.get_subcommand("study");
  if (!*command) return {};
  stop_on_batch_signals();
  study::Request request;
  request.name = value_of<std::string>(*command, "NAME");
  request.options.case_file = value_of<std::string>(*command, "CASE");
  request.options.quick = command->count("--quick") > 0;
  request.options.factors = value_of<std::vector<double>>(*command, "--factors");
  request.options.seeds = value_of<int>(*command, "--seeds");
  request.options.settings = overrides_from(value_of<std::vector<std::string>>(*command, "--set"));
  request.out = value_of<std::string>(*command, "--out");
  request.jobs = value_of<int>(*command, "--jobs");
  request.threads = value_of<int>(*command, "--threads");
  request.point = value_of<std::string>(*command, "--point");
  return study::conduct(request);
}

}  // namespace pulvis
