// SPDX-License-Identifier: Apache-2.0
#include "run/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "measures/energies.hpp"
#include "output/result_json.hpp"
#include "output/safe_file.hpp"
#include "run/body_pull.hpp"
#include "run/checkpoint.hpp"
#include "run/overlaps.hpp"
#include "run/pictures.hpp"
#include "run/result_file.hpp"
#include "run/sight.hpp"

namespace pulvis {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t reserved_bytes = 1 << 16;

const std::vector<std::string> result_files = {"case.toml",
                                               "run.json",
                                               "result.json",
                                               "log.csv",
                                               "wall-forces.csv",
                                               "wall-pressure/after-*.csv",
                                               "picture.png",
                                               "pictures/after-*.png",
                                               "pictures/whole.png",
                                               "pictures/speed.png",
                                               "pictures/size.png",
                                               "measures.csv",
                                               "measures/after-*.json",
                                               "report.html",
                                               "report/*.svg",
                                               "report/*.csv",
                                               "report/*.gnuplot",
                                               ".reserve",
                                               "parcels.pvd",
                                               "walls.pvd",
                                               "porosity.pvd",
                                               "fields.pvd",
                                               "frames/parcels-*.vtp",
                                               "frames/walls-*.vtp",
                                               "frames/porosity-*.vti",
                                               "frames/fields-*.vti"};

std::filesystem::path real_path(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto whole = std::filesystem::absolute(path, ignored);
  const auto real = std::filesystem::weakly_canonical(whole, ignored);
  return ignored ? whole.lexically_normal() : real;
}

/// `folder`, unless a file of the user's lies in it.
const std::string& free_of_inputs(const Case& c, const std::string& folder) {
  const auto results = real_path(std::filesystem::path(folder) / "any").parent_path();
  const auto refuse_if_there = [&](const char* what, const std::string& file) {
    if (real_path(file).parent_path() == results)
      throw Failure(Exit::usage,
                    fmt::format("the {} {} lies in the results folder {}, where results could replace it; "
                                "choose another --out",
                                what, file, folder));
  };
  refuse_if_there("case", c.file);
  for (const std::string& base : c.bases) refuse_if_there("case", base);
  for (const Source& source : c.sources)
    if (source.kind == Source::Kind::file) refuse_if_there("bed", source.path);
  return folder;
}

std::vector<std::string> log_columns(const Case& c) {
  std::vector<std::string> columns{"step",
                                   "time_s",
                                   "phase",
                                   "parcels",
                                   "pair_contacts",
                                   "wall_contacts",
                                   "kinetic_energy_J",
                                   "largest_speed_m_s",
                                   "largest_overlap_over_radius",
                                   "highest_point_m",
                                   "inserted_mass_kg",
                                   "escaped"};
  if (c.measures.energy_ledger)
    columns.insert(columns.end(), {"potential_energy_J", "stored_energy_J", "lost_energy_J",
                                   "brought_in_energy_J", "energy_closing_error_J"});
  return columns;
}

/// The files that belong to what is written.
std::set<std::string> names_of(const WrittenResults& written) {
  std::set<std::string> names(written.files.begin(), written.files.end());
  names.insert({"case.toml", "run.json", "result.json", "log.csv"});
  if (written.wall_log > 0) names.insert("wall-forces.csv");
  if (written.measures > 0) names.insert("measures.csv");
  const auto add = [&](const char* series, const std::vector<VtkSeries::Frame>& frames) {
    if (!frames.empty()) names.insert(series);
    for (const VtkSeries::Frame& frame : frames) names.insert(frame.file);
  };
  add("parcels.pvd", written.frames.parcels);
  add("walls.pvd", written.frames.walls);
  add("porosity.pvd", written.frames.porosity);
  add("fields.pvd", written.frames.fields);
  return names;
}

std::size_t count_of(const std::vector<std::uint8_t>& touching) {
  return static_cast<std::size_t>(std::count(touching.begin(), touching.end(), std::uint8_t{1}));
}

}  // namespace

RunFolder open_results(const Case& c, const std::string& folder, UsedFolder used) {
  std::vector<std::string> all = result_files;
  all.push_back(Checkpoints::files);
  return RunFolder(free_of_inputs(c, folder), used, all);
}

bool is_complete(const RunFolder& folder) {
  std::ifstream file(folder.file("result.json"));
  const Json result = Json::parse(file, nullptr, false);
  return result.is_object() && result.contains("exit") && result["exit"] == 0;
}

Results::Results(const Case& c, const TimeStep& time_step, const Walls& walls, const RunFolder& folder,
                 const WrittenResults& written)
    : case_(c),
      time_step_(time_step),
      folder_(folder),
      written_(written),
      log_(written.log > 0 ? CsvLog::continued(folder.file("log.csv"), log_columns(c), written.log)
                           : CsvLog(folder.file("log.csv"), log_columns(c))),
      wall_results_(folder, walls, written.wall_log),
      measure_results_(folder, written.measures),
      frames_(folder, written.frames) {
  folder.remove_results(result_files, names_of(written));
  // Given back before result.json is written, so that a full disk still has room for what went wrong.
  write_file_safely(folder_.file(".reserve"), std::string(reserved_bytes, ' '));
}

WrittenResults Results::written() {
  written_.log = log_.sync();
  written_.wall_log = wall_results_.sync();
  written_.measures = measure_results_.sync();
  written_.frames = frames_.written();
  return written_;
}

void Results::write_case() {
  write_file_safely(folder_.file("case.toml"), case_.text);
  Json keys = Json::object();
  for (const ResolvedKey& key : case_.keys) {
    keys[key.key] = {{"value", key.value}, {"origin", key.origin}};
    if (!key.comment.empty()) keys[key.key]["comment"] = key.comment;
  }
  Json limits = Json::array();
  for (const StepLimit& l : time_step_.limits)
    limits.push_back({{"kind", l.kind}, {"of", l.of}, {"time_s", l.time}});
  write_json(folder_.file("run.json"), {{"version", PULVIS_VERSION},
                                        {"case", case_.file},
                                        {"extends", case_.bases},
                                        {"title", case_.title},
                                        {"time_step_s", time_step_.step},
                                        {"time_step_limits", limits},
                                        {"characteristic_speed_m_s", time_step_.characteristic_speed},
                                        {"keys", keys}});
}

void Results::pictures(const Simulation& simulation, const std::string& phase, bool last) {
  const Photographer photographer(case_, simulation, phase);
  const auto take = [&](const std::string& name, View view) {
    photographer.write(folder_.file(name), view);
    written_.files.push_back(name);
  };
  folder_.folder("pictures");
  take(last ? "picture.png" : "pictures/after-" + phase + ".png", View::contacts);
  if (!last) return;
  take("pictures/whole.png", View::whole);
  take("pictures/speed.png", View::speed);
  take("pictures/size.png", View::size);
}

void Results::write_result(const RunSummary& summary, const Simulation* simulation, bool ended) {
  const Json json = result_json(case_, time_step_, summary, simulation, written_.largest_overlap);
  if (ended) std::remove(folder_.file(".reserve").c_str());
  write_json(folder_.file("result.json"), json);
}

void Results::log(const Simulation& simulation, const std::string& phase) {
  const State& state = simulation.state();
  const Sight sight = look_at(simulation);
  const Vec3 up = up_at(case_, simulation.time());
  double fastest = 0.0, highest = 0.0;
  for (std::size_t k = 0; k < sight.bodies.size(); ++k) {
    fastest = std::max(fastest, norm(sight.bodies[k].velocity));
    const double top = dot(sight.spheres[k].centre, up) + sight.spheres[k].radius;
    highest = k == 0 ? top : std::max(highest, top);
  }
  const double overlap = largest_overlap_ratio(simulation);
  written_.largest_overlap = std::max(written_.largest_overlap, overlap);
  std::vector<CsvCell> cells{static_cast<std::int64_t>(state.step),
                             simulation.time(),
                             std::string_view(phase),
                             static_cast<std::int64_t>(state.parcels.size()),
                             static_cast<std::int64_t>(count_of(simulation.pairs().touching)),
                             static_cast<std::int64_t>(count_of(simulation.walls().touching)),
                             measures::energies(sight.bodies, simulation.field().gravity).kinetic(),
                             fastest,
                             overlap,
                             highest,
                             state.ledger.inserted_mass,
                             static_cast<std::int64_t>(state.ledger.escaped)};
  if (const auto energy = simulation.energy())
    cells.insert(cells.end(), {energy->potential, energy->stored(), energy->lost(), energy->brought_in(),
                               energy->closing_error()});
  log_.add(cells);
}

}  // namespace pulvis
