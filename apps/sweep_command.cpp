// SPDX-License-Identifier: Apache-2.0
#include "apps/sweep_command.hpp"

#include <csignal>
#include <string>
#include <vector>

#include "run/stop_request.hpp"
#include "sweep/sweep.hpp"

namespace pulvis {
namespace {

extern "C" void on_stop(int signal) { ask_to_stop(signal); }

template <typename Value>
Value value_of(const CLI::App& command, const char* option) {
  return command.count(option) > 0 ? command.get_option(option)->as<Value>() : Value{};
}

bool has_command(const CLI::App& app, const std::string& name) {
  return !app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; }).empty();
}

}  // namespace

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
      "Example: pulvis sweep sine-5hz.toml sine-10hz.toml --vary materials.mo.friction=0.3,0.5 --seeds 3 "
      "--out "
      "sweep\n"
      "Runs side by side on one thread each waste nothing on sharing; threads never change a result. Leaves "
      "sweep.json\n"
      "(the list of runs), sweep.csv (their measures), NAME/ and NAME.log of each run. Ctrl-C or SIGTERM "
      "stop all "
      "runs\n"
      "with a checkpoint; then, or after a crash, the same command goes on: complete runs are kept. The exit "
      "code "
      "is that\n"
      "of the first run that failed.");
}

std::optional<Exit> run_sweep_command(const CLI::App& app) {
  const CLI::App* command = app.get_subcommand("sweep");
  if (!*command) return {};
  std::signal(SIGTERM, on_stop);
  std::signal(SIGUSR1, on_stop);
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
  request.compare = has_command(app, "compare");
  return sweep::run_sweep(request);
}

}  // namespace pulvis
