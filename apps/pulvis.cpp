// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "apps/bench_command.hpp"
#include "apps/options.hpp"
#include "apps/report_command.hpp"
#include "apps/study_command.hpp"
#include "apps/sweep_command.hpp"
#include "apps/templates.hpp"
#include "case/reader.hpp"
#include "output/safe_file.hpp"
#include "run/law_report.hpp"
#include "run/preflight.hpp"
#include "run/run_case.hpp"
#include "run/stop_request.hpp"
#include "validation/validate.hpp"

namespace {

using pulvis::Exit;
using pulvis::Failure;
using pulvis::overrides_from;

extern "C" void on_interrupt(int signal) {
  // The first Ctrl-C ends after this step with valid results; a second one ends at once.
  pulvis::ask_to_stop(signal);
  std::signal(signal, SIG_DFL);
}

Exit check(const std::string& file, const std::vector<std::string>& settings) {
  const pulvis::Case c = pulvis::read_case(file, overrides_from(settings));
  const pulvis::Assembly assembly = pulvis::assemble(c);
  const pulvis::Forecast forecast = pulvis::forecast(c, assembly);
  fmt::print("{}", pulvis::check_report(c, assembly, forecast));
  for (const auto& warning : forecast.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return Exit::ok;
}

Exit law(const std::string& file, const std::vector<std::string>& settings,
         const std::vector<std::string>& pair, const std::vector<std::string>& speeds,
         const std::string& out) {
  pulvis::LawRequest request{pair, {}};
  for (const std::string& speed : speeds) request.speeds.push_back(pulvis::speed_from(speed));
  const pulvis::Case c = pulvis::read_case(file, overrides_from(settings));
  const pulvis::Assembly assembly = pulvis::assemble(c);
  const pulvis::LawReport report = pulvis::law_report(c, assembly, pulvis::forecast(c, assembly), request);
  if (!out.empty()) pulvis::write_curves(out, report);
  fmt::print("{}", report.text);
  for (const auto& warning : report.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return Exit::ok;
}

Exit make_new(const std::string& name, const std::string& folder) {
  for (const auto& t : pulvis::templates()) {
    if (t.name != name) continue;
    const std::filesystem::path path = std::filesystem::path(folder) / "case.toml";
    if (std::filesystem::exists(path))
      throw Failure(Exit::usage, fmt::format("{} exists already; choose another folder", path.string()));
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Failure(Exit::io, fmt::format("cannot create {}: {}", folder, error.message()));
    pulvis::write_file_safely(path.string(), t.text);
    fmt::print("{}\nNow: pulvis check {}, then pulvis run {} --out {}\n", path.string(), path.string(),
               path.string(), (std::filesystem::path(folder) / "results").string());
    return Exit::ok;
  }
  std::string known;
  for (const auto& t : pulvis::templates()) known += fmt::format("\n  {:<14} {}", t.name, t.help);
  throw Failure(Exit::usage, fmt::format("there is no template \"{}\"; templates are:{}", name, known));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "pulvis simulates how cohesive powder fills a die.\nStart with: pulvis new die-filling my-case"};
  app.footer(
      "Exit codes: 0 completed, 2 usage or results folder in use, 3 invalid case, 4 unreadable input, 5 "
      "physics\n"
      "(not a number, lost parcel), 6 results cannot be written, 7 internal check, 8 validate, study: a "
      "limit "
      "not kept,\n"
      "75 stopped with a checkpoint by SIGTERM, SIGUSR1 or --max-wall, 130 Ctrl-C");
  app.set_version_flag("--version", PULVIS_VERSION);
  app.require_subcommand(1);

  pulvis::RunRequest request;
  std::vector<std::string> settings;
  std::vector<std::string> pair, speeds;
  std::string file, key, name, folder, out;

  auto* run = app.add_subcommand("run", "run a case");
  run->add_option("CASE", request.case_file, "case file (TOML)")->required();
  run->add_option("--out", request.out, "folder for the results")->required();
  run->add_option("--set", settings, "override a key: --set key.path=value (repeatable)")
      ->allow_extra_args(false);
  run->add_option("--threads", request.threads, "threads; default: all processors")
      ->check(CLI::Range(1, 1024));
  run->footer(
      "Example: pulvis run case.toml --out results --set powders.mo.coarse_graining=50 --set "
      "'output.interval=1 ms'\n"
      "Leaves report.html, result.json, log.csv, picture.png and series for ParaView (parcels.pvd, "
      "walls.pvd, "
      "porosity.pvd) in\n"
      "the folder. Ctrl-C ends the run after the current step with valid results; SIGTERM and SIGUSR1 stop "
      "it\n"
      "there with a checkpoint. Either way, or after a crash, the same command with --resume goes on to the\n"
      "same results.");
  auto* force =
      run->add_flag("--force", request.force, "replace the results of an earlier run in that folder");
  run->add_flag("--resume", request.resume, "go on from the newest checkpoint in that folder")
      ->excludes(force);
  run->add_option("--max-wall", request.max_wall,
                  "stop with a checkpoint (exit 75) after this time on the clock, e.g. \"12 h\"");

  auto* check_command =
      app.add_subcommand("check", "validate a case and print what follows from it; simulates nothing");
  check_command->footer(
      "Prints the time step and the limit that binds it, parcels, memory, and for each pair of materials "
      "(walls\n"
      "included) pull-off force, Bond number, sticking speed and expected overlap, for a real grain and for "
      "the\n"
      "parcel that is simulated in its stead.");
  check_command->add_option("CASE", file, "case file (TOML)")->required();
  check_command->add_option("--set", settings, "override a key: --set key.path=value (repeatable)")
      ->allow_extra_args(false);

  auto* law_command = app.add_subcommand(
      "law",
      "print what the contact law makes of one contact, for each pair of materials; simulates nothing");
  law_command->footer(
      "Prints, for a real grain and for the parcel simulated in its stead, pull-off force, work of "
      "separation,\n"
      "sticking speed and the restitution that collisions really show. Everything is asked of the law "
      "itself: slow\n"
      "pressing and pulling, and collisions integrated in time.\n"
      "Example: pulvis law case.toml --pair molybdenum steel --speed '0.1 m/s' --out curves");
  law_command->add_option("CASE", file, "case file (TOML)")->required();
  law_command->add_option("--pair", pair, "two materials or powders; default: every pair")->expected(2);
  law_command
      ->add_option("--speed", speeds,
                   "speed of collisions, e.g. '0.1 m/s' (repeatable); default: parts of the "
                   "characteristic speed")
      ->allow_extra_args(false);
  law_command->add_option("--out", out,
                          "folder for the load-unload curves: an SVG figure and a CSV file each");
  law_command->add_option("--set", settings, "override a key: --set key.path=value (repeatable)")
      ->allow_extra_args(false);

  auto* new_command = app.add_subcommand("new", "write a case to start from");
  std::string list = "Templates:";
  for (const auto& t : pulvis::templates()) list += fmt::format("\n  {:<14} {}", t.name, t.help);
  new_command->footer(list);
  new_command->add_option("TEMPLATE", name, "one of the templates below")->required();
  new_command->add_option("DIR", folder, "new folder")->required();

  auto* explain =
      app.add_subcommand("explain", "explain a key of the case file, e.g. powders.coarse_graining");
  explain->add_option("KEY", key, "a key or a table")->required();

  pulvis::add_report_commands(app);
  pulvis::add_sweep_command(app);
  pulvis::add_study_command(app);
  pulvis::add_bench_command(app);

  pulvis::validation::Request validation;
  validation.out = "validation-results";
  auto* validate = app.add_subcommand("validate", "compare the program with theory and published numbers");
  validate->footer(
      "Prints each quantity with its reference, deviation and limit, and leaves them with figures in\n"
      "validation.html. Takes up to an hour, with --quick up to three minutes. Exit code 0 if every "
      "comparison\n"
      "keeps its limit, 8 if not.");
  validate->add_flag("--quick", validation.quick, "fewer states, angles and speeds");
  validate->add_option("--only", validation.only, "only this chapter (repeatable)")->allow_extra_args(false);
  validate->add_option("--out", validation.out, "folder for the page and its figures")->capture_default_str();
  validate->add_option("--json", validation.json, "also write the table to this file");
  validate->add_option("--threads", validation.threads, "chapters side by side; default: all processors")
      ->check(CLI::Range(1, 1024));

  app.add_subcommand("keys", "print the reference of all keys (Markdown)");
  app.add_subcommand("schema", "print a JSON Schema of the case file, for editors");

  try {
    if (argc > 1 && std::string_view(argv[1]) == "help") return fmt::print("{}", app.help()), 0;
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // The library would only say that a subcommand is missing.
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty())
      fmt::print(stderr, "pulvis: there is no command \"{}\"\n", argv[1]);
    const int code = app.exit(error);
    return code == 0 ? 0 : static_cast<int>(Exit::usage);
  }

  try {
    std::signal(SIGINT, on_interrupt);
    Exit result = Exit::ok;
    if (*run) {
      pulvis::stop_on_batch_signals();
      request.overrides = overrides_from(settings);
      request.make_page = pulvis::make_report;
      result = pulvis::run_case(request);
    } else if (const auto reported = pulvis::run_report_command(app)) {
      result = *reported;
    } else if (const auto swept = pulvis::run_sweep_command(app)) {
      result = *swept;
    } else if (const auto studied = pulvis::run_study_command(app)) {
      result = *studied;
    } else if (const auto timed = pulvis::run_bench_command(app)) {
      result = *timed;
    } else if (*check_command) {
      result = check(file, settings);
    } else if (*law_command) {
      result = law(file, settings, pair, speeds, out);
    } else if (*new_command) {
      result = make_new(name, folder);
    } else if (*validate) {
      if (validation.threads == 0) validation.threads = pulvis::available_processors();
      result = pulvis::validation::validate(validation);
    } else if (*explain) {
      fmt::print("{}", pulvis::explain(key));
    } else if (app.got_subcommand("keys")) {
      fmt::print("{}", pulvis::keys_reference_markdown());
    } else {
      fmt::print("{}", pulvis::json_schema());
    }
    // What was printed may reach a full disk only now.
    if (std::fflush(stdout) != 0) throw Failure(Exit::io, "cannot write to the standard output");
    return static_cast<int>(result);
  } catch (const Failure& failure) {
    fmt::print(stderr, "{}{}\n", failure.code() == Exit::bad_case ? "" : "pulvis: ", failure.what());
    return static_cast<int>(failure.code());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "pulvis: not enough memory; `pulvis check` says how much a case needs\n");
    return static_cast<int>(Exit::unexpected);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pulvis: unexpected: {}\n", error.what());
    return static_cast<int>(Exit::unexpected);
  }
}
