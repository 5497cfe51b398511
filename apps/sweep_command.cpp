// SPDX-License-Identifier: Apache-2.0
#include "apps/sweep_command.hpp"

#include <string>
#include <vector>

#include "apps/options.hpp"
#include "sweep/sweep.hpp"

namespace pulvis {

void add_sweep_command(CLI::App& app) {
  auto* sweep = app.add_subcommand("sweep", "run cases with several values and seeds side by side");
  sweep->add_option("CASE", "case files (TOML)")->required()->expected(1, -1)->allow_extra_args(true);
  sweep->add_option("--vary", "values of a key: --vary key.path=v1,v2,v3 (repeatable: all combinations)")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  sweep->add_option("--seeds", "run each with the seeds 1 to N; default: the seed of its case")
      ->check(CLI::Range(1, 10000));
  sweep->add_option("--out", "folder for the runs, each in a folder of its name")->required();
  sweep->add_option("--jobs", "runs at once; default: processors over threads")->check(CLI::Range(1, 1024));
  sweep
      ->add_option("--threads",
                   "threads of each run; default: 1, or more if there are fewer runs than processors")
      ->check(CLI::Range(1, 1024));
  sweep->add_option("--set", "override a key in all runs: --set key.path=value (repeatable)")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  sweep->add_flag("--resume")->description("refuse to begin: a sweep must be there to go on with");
  sweep->footer(
      "Example: pulvis sweep sine.toml square.toml --vary materials.mo.friction=0.3,0.5 --seeds 3 --out "
      "sweep\n"
      "Runs side by side on one thread each waste nothing on sharing; threads never change a result.\n"
      "Leaves sweep.json (the list of runs), sweep.csv (their measures), comparison/ (a page of the runs "
      "side\n"
      "by side), NAME/ and NAME.log of each run. Ctrl-C or SIGTERM stop all runs with a checkpoint; then, "
      "or\n"
      "after a crash, the same command goes on: complete runs are kept. The exit code is that of the first "
      "run\n"
      "that failed.");
}

std::optional<Exit> run_sweep_command(const CLI::App& app) {
  const CLI::App* command = app.get_subcommand("sweep");
  if (!*command) return {};
  stop_on_batch_signals();
  sweep::Request request;
  request.choice.cases = value_of<std::vector<std::string>>(*command, "CASE");
  for (const std::string& text : value_of<std::vector<std::string>>(*command, "--vary"))
    request.choice.factors.push_back(sweep::factor_from(text));
  request.choice.seeds = value_of<int>(*command, "--seeds");
  request.choice.common = overrides_from(value_of<std::vector<std::string>>(*command, "--set"));
  request.out = value_of<std::string>(*command, "--out");
  request.jobs = value_of<int>(*command, "--jobs");
  request.threads = value_of<int>(*command, "--threads");
  request.resume = command->count("--resume") > 0;
  return sweep::run_sweep(request);
}

}  // namespace pulvis
