// SPDX-License-Identifier: Apache-2.0
#include "report/run_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "case/reader.hpp"
#include "case/units.hpp"
#include "engine/base/failure.hpp"
#include "report/json_entry.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void read_scalars(const JsonEntry& entry, std::vector<Scalar>& list) {
  for (const auto& [name, m] : entry.members())
    list.push_back({name, m.at("value").number(), m.at("unit").text(), m.text_or("window", "")});
}

/// Beside what result.json has of it.
void read_phase_files(RunData& run, PhaseData& phase) {
  // A name that leads elsewhere was not written by pulvis.
  if (phase.name.empty() || phase.name.find('/') != std::string::npos)
    throw Failure(Exit::bad_input, fmt::format("{}: \"{}\" is no name of a phase; the file is damaged",
                                               run.file("result.json"), phase.name));
  const std::string measures = "measures/after-" + phase.name + ".json";
  const std::string pressures = "wall-pressure/after-" + phase.name + ".csv";
  phase.detail = read_measures(run.file(measures));
  if (!phase.detail) run.missing.push_back(measures + " (maps, profiles and distributions)");
  phase.wall_pressure = CsvTable::read(run.file(pressures));
  if (!phase.wall_pressure)
    run.missing.push_back(pressures + " (pressure on walls)");
  else
    phase.wall_pressure->require({"wall", "surface", "u_m", "v_m", "area_m2", "pressure_Pa"});
  if (phase.detail)
    for (const Scalar& s : phase.detail->scalars)
      if (std::none_of(phase.measures.begin(), phase.measures.end(),
                       [&](const Scalar& m) { return m.name == s.name; }))
        phase.measures.push_back(s);
}

void add_ledger(const JsonEntry& result, RunData& run) {
  for (const auto& [key, words] :
       {std::pair{"ledger", "parcels"}, std::pair{"ledger_mass", "mass of parcels"}}) {
    const auto ledger = result.find(key);
    if (!ledger) continue;
    std::string text;
    for (const auto& [name, entry] : ledger->members()) {
      const double v = entry.number();
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                          key == std::string("ledger") ? fmt::format("{:.15g}", v)
                          : v == 0.0                   ? "0"
                                                       : value_text(v, "kg", 6),
                          name);
    }
    run.numbers.emplace_back(words, text);
  }
}

void add_energy(const JsonEntry& result, RunData& run) {
  const auto energy = result.find("energy");
  if (!energy) return;
  std::string text;
  for (const auto& [name, entry] : energy->members()) {
    if (name == "closing_share" || entry.number() == 0.0) continue;
    std::string words = name.substr(0, name.rfind("_J"));
    std::replace(words.begin(), words.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", words, value_text(entry.number(), "J", 4));
  }
  run.numbers.emplace_back("ledger of energy", text);
  run.numbers.emplace_back("energy unaccounted for, over what was put through",
                           value_text(energy->at("closing_share").number(), "1", 2));
}

void add_times(const JsonEntry& result, RunData& run) {
  const auto times = result.find("time_table_s");
  if (!times) return;
  double total = 0.0;
  for (const auto& [task, seconds] : times->members()) total += seconds.number();
  std::string text;
  for (const auto& [task, seconds] : times->members()) {
    const double share = seconds.number() / total;
    if (!(share >= 0.005)) continue;
    std::string words = task;
    std::replace(words.begin(), words.end(), '_', ' ');
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", words, 100.0 * share);
  }
  run.numbers.emplace_back("where it went", text);
}

/// What the run says of itself, for the page's last table.
void read_numbers(const JsonEntry& result, RunData& run) {
  const auto number = [&](const char* key, const std::string& words, const char* unit, int digits = 6) {
    if (result.has(key)) run.numbers.emplace_back(words, value_text(result.at(key).number(), unit, digits));
  };
  const auto text = [&](const char* key, const std::string& words) {
    if (result.has(key)) run.numbers.emplace_back(words, result.at(key).text());
  };
  number("simulated_time_s", "simulated time", "s");
  number("time_step_s", "time step", "s");
  text("time_step_limit", "time step bound by");
  number("steps", "steps", "1", 15);
  add_ledger(result, run);
  add_energy(result, run);
  number("largest_overlap_over_radius", "largest overlap over the radius", "1", 3);
  number("wall_time_s", "time on the clock", "s", 4);
  add_times(result, run);
  number("particle_steps_per_s", "parcels times steps per second", "1", 3);
  number("threads", "threads asked for", "1");
  number("threads_used", "threads used", "1");
  text("instruction_set", "instruction set");
  number("resumes", "times gone on with", "1");
  text("version", "version of pulvis");
  text("state_hash", "hash of the final state");
}

void read_result(RunData& run) {
  const auto json = read_json(run.file("result.json"));
  if (!json) {
    run.reason = "there is no result.json";
    run.missing.push_back("result.json (how the run ended, measures of the phases)");
    return;
  }
  const JsonEntry result(*json, run.file("result.json"));
  run.ended = result.at("exit").number() == 0.0;
  run.reason = result.text_or("exit_reason", "");
  run.title = result.text_or("title", "");
  run.version = result.text_or("version", "");
  run.parcels = result.number_or("particles", none);
  run.wall_time = result.number_or("wall_time_s", none);
  run.largest_overlap = result.number_or("largest_overlap_over_radius", none);
  run.notes = result.texts_or_none("notes");
  run.warnings = result.texts_or_none("warnings");
  read_numbers(result, run);
  if (const auto phases = result.find("phases"))
    for (const JsonEntry& p : phases->items()) {
      PhaseData phase;
      phase.name = p.at("name").text();
      phase.start = p.number_or("start_s", none);
      phase.end = p.number_or("end_s", none);
      phase.ended_by = p.text_or("ended_by", "");
      if (const auto measures = p.find("measures")) read_scalars(*measures, phase.measures);
      run.phases.push_back(std::move(phase));
    }
  for (PhaseData& phase : run.phases) read_phase_files(run, phase);
}

void read_keys(RunData& run) {
  const auto json = read_json(run.file("run.json"));
  if (!json) {
    run.missing.push_back("run.json (the keys of the case)");
    return;
  }
  const JsonEntry file(*json, run.file("run.json"));
  if (run.title.empty()) run.title = file.text_or("title", "");
  if (run.version.empty()) run.version = file.text_or("version", "");
  if (const auto keys = file.find("keys"))
    for (const auto& [name, entry] : keys->members())
      run.keys.push_back(
          {name, entry.at("value").text(), entry.text_or("origin", ""), entry.text_or("comment", "")});
}

/// The case as the run saw it: the file's text, and what `--set` put over it.
void read_the_case(RunData& run) {
  const auto text = read_bytes(run.file("case.toml"));
  if (!text) {
    run.case_problem = "there is no case.toml";
    run.missing.push_back("case.toml (the case as read)");
    return;
  }
  std::vector<Override> overrides;
  for (const Key& key : run.keys)
    if (key.origin.starts_with("--set")) overrides.push_back({key.name, key.value});
  try {
    run.the_case = read_case_text(*text, run.file("case.toml"), overrides);
  } catch (const Failure& failure) {
    run.case_problem = failure.what();
  }
}

}  // namespace

double PhaseData::measure(const std::string& measured) const {
  for (const Scalar& m : measures)
    if (m.name == measured) return m.value;
  return none;
}

const PhaseData* RunData::last() const {
  for (auto p = phases.rbegin(); p != phases.rend(); ++p)
    if (!p->measures.empty() || p->detail) return &*p;
  return nullptr;
}

std::optional<Die> RunData::die() const {
  for (auto p = phases.rbegin(); p != phases.rend(); ++p)
    if (p->detail && p->detail->die) return p->detail->die;
  if (!the_case || !the_case->measures.die) return {};
  const Region& r = the_case->walls[*the_case->measures.die].region;
  if (r.shape == Region::Shape::cylinder) return Die{"cylinder", {2.0 * r.radius, 2.0 * r.radius, r.height}};
  return Die{"box", {r.max.x - r.min.x, r.max.y - r.min.y, r.max.z - r.min.z}};
}

const Key* RunData::key(const std::string& name) const {
  const auto at = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
  return at == keys.end() ? nullptr : &*at;
}

RunData read_run(const std::string& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw Failure(Exit::bad_input,
                  fmt::format("{} is not a folder; give the folder that `pulvis run --out` filled", folder));
  RunData run;
  run.folder = folder;
  run.parcels = run.wall_time = run.largest_overlap = none;
  const auto name = std::filesystem::weakly_canonical(folder, error).filename().string();
  run.label = error || name.empty() ? folder : name;
  read_result(run);
  read_keys(run);
  run.log = CsvTable::read(run.file("log.csv"));
  run.series = CsvTable::read(run.file("measures.csv"));
  if (run.keys.empty() && run.phases.empty() && !run.log && !run.series)
    throw Failure(Exit::bad_input,
                  fmt::format("{} holds no run: there is no result.json, run.json, log.csv or "
                              "measures.csv in it that says anything; give the folder that `pulvis "
                              "run --out` filled",
                              folder));
  if (!run.log) run.missing.push_back("log.csv (energy and contacts over time)");
  if (!run.series) run.missing.push_back("measures.csv (measures over time)");
  read_the_case(run);
  if (run.title.empty()) run.title = "Run " + run.label;
  return run;
}

}  // namespace pulvis::report
