// SPDX-License-Identifier: Apache-2.0
#include "apps/bench_command.hpp"

#include <fmt/format.h>

#include <csignal>
#include <string>

#include "apps/options.hpp"
#include "run/run_case.hpp"
#include "yardstick/bench.hpp"

namespace pulvis {

void add_bench_command(CLI::App& app) {
  auto* bench = app.add_subcommand("bench", "measure how fast pulvis is on this machine");
  std::string list = "Laws:";
  for (const auto& law : yardstick::known_laws()) list += fmt::format("\n  {:<6} {}", law.name, law.title);
  bench->footer(
      list +
      "\nA bed of equal spheres (periodic, on a floor) settles once for each law; larger beds are the same "
      "one, "
      "side\n"
      "by side, so that sizes are rounded to whole beds. Each row has: time per particle-step, contacts and "
      "near\n"
      "pairs per parcel, rebuilds of the near lists per step, bytes per parcel, shares of the time, speed-up "
      "over\n"
      "one thread, time per particle-step over that of the smallest bed. With one thread it is time of the\n"
      "processor, else of the clock: keep the machine free of other work. Without options: some minutes.\n"
      "Example: pulvis bench --sizes 1e4,1e6 --laws hertz,jkr --threads 1,2 --json bench.json");
  bench->add_option("--sizes", "parcels, e.g. 1e4,1e6,1e7; default: 1e4,1e5")
      ->delimiter(',')
      ->expected(1, 100)
      ->allow_extra_args(false)
      ->check(CLI::Range(static_cast<double>(yardstick::smallest_bed),
                         static_cast<double>(yardstick::largest_bed)));
  bench->add_option("--laws", "of those below, e.g. hertz,jkr; default: hertz")
      ->delimiter(',')
      ->expected(1, 100)
      ->allow_extra_args(false);
  bench->add_option("--threads", "e.g. 1,2,4; default: 1 and all processors")
      ->delimiter(',')
      ->expected(1, 100)
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 1024));
  bench->add_option("--steps", "steps to time; default: enough for 20 million particle-steps, at least 100")
      ->check(CLI::Range(1, 1'000'000'000));
  bench
      ->add_option("--look-every",
                   "steps between looks at the state (1: as if somebody looked at every step); default: 16")
      ->check(CLI::Range(1, 1'000'000'000));
  bench->add_flag("--energy")->description("with the ledger of energy");
  bench->add_option("--json", "also write the rows to this file");
}

std::optional<Exit> run_bench_command(const CLI::App& app) {
  const CLI::App* command = app.get_subcommand("bench");
  if (!*command) return {};
  std::signal(SIGINT, SIG_DFL);  // there is nothing to save
  yardstick::Request request;
  if (command->count("--sizes")) {
    request.sizes.clear();
    for (const double size : value_of<std::vector<double>>(*command, "--sizes"))
      request.sizes.push_back(static_cast<std::size_t>(size));
  }
  if (command->count("--laws")) request.laws = value_of<std::vector<std::string>>(*command, "--laws");
  request.threads = value_of<std::vector<int>>(*command, "--threads");
  if (request.threads.empty()) {
    request.threads = {1};
    if (available_processors() > 1) request.threads.push_back(available_processors());
  }
  request.steps = value_of<int>(*command, "--steps");
  if (command->count("--look-every")) request.look_every = value_of<int>(*command, "--look-every");
  request.energy = command->count("--energy") > 0;
  request.json = value_of<std::string>(*command, "--json");
  yardstick::bench(request);
  return Exit::ok;
}

}  // namespace pulvis
