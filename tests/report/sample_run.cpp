// SPDX-License-Identifier: Apache-2.0
#include "tests/report/sample_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "case/reader.hpp"
#include "output/png_file.hpp"
#include "tests/output/scratch_folder.hpp"
#include "tests/run/program.hpp"

namespace pulvis::test {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> phases{"fill", "shake"};
constexpr double floor_height = 0.006;  // m, of the powder's surface

Json scalar(double value, const char* unit) {
  return {{"value", value}, {"unit", unit}, {"window", "instantaneous"}};
}

double porosity_of(const SampleRun& run, std::size_t phase, double height) {
  const double mean = run.porosity + (phase == 0 ? 0.02 : 0.0);
  return mean + run.lower_denser * (1.0 - mean) * (height / floor_height - 0.5);
}

Json scalars_of(const SampleRun& run, std::size_t phase) {
  return {{"fill_mass", scalar(0.0016, "kg")},
          {"fill_count", scalar(3078, "1")},
          {"porosity_mean", scalar(porosity_of(run, phase, 0.5 * floor_height), "1")},
          {"porosity_std", scalar(0.02, "1")},
          {"free_surface_height_mean", scalar(floor_height, "m")},
          {"kinetic_energy_translational", scalar(1e-12, "J")}};
}

Json profile_of(const SampleRun& run, std::size_t phase, const char* axis, bool upright) {
  Json p{{"axis", axis}};
  for (int k = 0; k < 6; ++k) {
    const double place = (k + 0.5) * floor_height / 6;
    p["position_m"].push_back(place);
    p["porosity"].push_back(porosity_of(run, phase, upright ? place : 0.5 * floor_height));
    p["volume_m3"].push_back(4.8e-8);
  }
  return p;
}

Json part_of(const SampleRun& run, std::size_t phase, const char* name, double height) {
  return {{"name", name},         {"min_m", {0, 0, 0}},
          {"max_m", run.die},     {"porosity", porosity_of(run, phase, height)},
          {"porosity_std", 0.01}, {"volume_m3", 1e-7},
          {"mass_kg", 8e-4},      {"apparent_density_kg_m3", 5300.0},
          {"coordination", 4.0}};
}

Json measures_of(const SampleRun& run, std::size_t phase) {
  Json m{{"format", "pulvis measures"},
         {"version", run.version},
         {"phase", phases[phase]},
         {"time_s", 0.1 * static_cast<double>(phase + 1)}};
  m["die"] = {{"shape", "box"}, {"size_m", run.die}, {"volume_m3", run.die[0] * run.die[1] * run.die[2]}};
  m["scalars"] = scalars_of(run, phase);
  m["scalars"]["free_surface_tilt"] = scalar(0.01, "rad");
  Json& grid =
      m["porosity"] = {{"cells", {3, 2, 3}}, {"spacing_m", {run.die[0] / 3, run.die[1] / 2, run.die[2] / 3}}};
  for (int k = 0; k < 18; ++k) {
    if (k == 17 || k / 6 >= run.layers_of_powder)
      grid["values"].push_back(nullptr);
    else
      grid["values"].push_back(porosity_of(run, phase, (k / 6 + 0.5) * floor_height / 3) + 0.001 * (k % 6));
    grid["volume_m3"].push_back(k == 17 ? 0.0 : 2e-8);
  }
  m["porosity_profiles"] = {profile_of(run, phase, "first", false), profile_of(run, phase, "second", false),
                            profile_of(run, phase, "third", true)};
  m["porosity_histogram"] = {{"edges", {0.4, 0.45, 0.5, 0.55}}, {"share", {0.2, 0.5, 0.3}}};
  const double low = 0.25 * floor_height, middle = 0.5 * floor_height, high = 0.75 * floor_height;
  m["parts"] = {
      part_of(run, phase, "lower half", low),           part_of(run, phase, "upper half", high),
      part_of(run, phase, "first lower half", middle),  part_of(run, phase, "first upper half", middle),
      part_of(run, phase, "second lower half", middle), part_of(run, phase, "second upper half", middle)};
  m["surface"] = {{"columns", {2, 2}},
                  {"spacing_m", {run.die[0] / 2, run.die[1] / 2}},
                  {"heights_m", {0.0059, 0.006, 0.0061, 0.006}},
                  {"areas_m2", {1.2e-5, 1.2e-5, 1.2e-5, 1.2e-5}},
                  {"mean_m", 0.006},
                  {"roughness_m", 1e-4},
                  {"slope_first", 0.01},
                  {"slope_second", 0.0},
                  {"tilt_rad", 0.01}};
  m["coordination"] = {{"count", {10, 100, 900, 1500, 500, 68}}};
  m["contact_forces"] = {
      {"mean_N", 1e-4}, {"edges", {0, 1, 2, 3}}, {"density", {0.6, 0.3, 0.1}}, {"pulling_share", 0.1}};
  for (int k = 0; k < 3; ++k) {
    m["layers"]["height_m"].push_back(0.001 + 0.002 * k);
    m["layers"]["density_kg_m3"].push_back(5300.0 - 50.0 * k);
    m["layers"]["speed_rms_m_s"].push_back(1e-3);
    m["layers"]["stress_Pa"].push_back(Json{{100, 0, 0}, {0, 100, 0}, {0, 0, 300.0 - 90.0 * k}});
  }
  m["segregation"] = {{"mean_diameter_m", 4.6e-4}, {"index", 0.0}, {"intensity", 0.0}};
  return m;
}

Json result_of(const SampleRun& run) {
  Json r{{"exit", run.ended ? 0 : 1},
         {"exit_reason", run.ended ? "completed" : "the run has not ended, or it was killed"},
         {"title", "A die for <tests> & nothing else"},
         {"version", "0.1.0"},
         {"steps", 1000},
         {"simulated_time_s", 0.2},
         {"time_step_s", 2e-6},
         {"time_step_limit", "rayleigh of powder"},
         {"wall_time_s", 60.0 + run.seed},
         {"time_table_s", {{"pairs", 30.0}, {"near_lists", 9.0}, {"rest", 0.0}}},
         {"threads", 2},
         {"particles", 3078},
         {"particle_steps_per_s", 8e6},
         {"largest_overlap_over_radius", 0.02},
         {"state_hash", "f49844773404c8df"},
         {"ledger", {{"inserted", 3078}, {"present", 3078}, {"removed", 0}, {"escaped", 0}}},
         {"ledger_mass", {{"inserted", 0.0016}, {"present", 0.0016}, {"removed", 0.0}, {"escaped", 0.0}}}};
  r["phases"] = Json::array();
  for (std::size_t k = 0; k < (run.ended ? phases.size() : 1); ++k)
    r["phases"].push_back({{"name", phases[k]},
                           {"start_s", 0.1 * static_cast<double>(k)},
                           {"end_s", 0.1 * static_cast<double>(k + 1)},
                           {"ended_by", "time"},
                           {"measures", scalars_of(run, k)}});
  r["notes"] = {"motion shaking: amplitude 3 mm"};
  r["warnings"] = {"a warning of the run"};
  return r;
}

void write_case(const std::string& folder, const SampleRun& run) {
  const std::string text = tests::text_of(tests::source_folder() + "/cases/die-filling/quick.toml");
  put(folder + "/case.toml", text);
  const std::vector<Override> overrides{
      {"seed", std::to_string(run.seed)},
      {"materials.molybdenum.surface_energy", fmt::format("{} J/m^2", run.surface_energy)}};
  Json keys;
  for (const ResolvedKey& k : read_case_text(text, "case.toml", overrides).keys)
    keys[k.key] = {{"value", k.value}, {"origin", k.origin}, {"comment", k.comment}};
  put(folder + "/run.json", Json{{"version", "0.1.0"}, {"title", "a title"}, {"keys", keys}}.dump(1));
}

void write_pressures(const std::string& path) {
  std::string text = "wall,surface,x_m,y_m,z_m,u_m,v_m,area_m2,pressure_Pa,shear_stress_Pa,window_s\n";
  for (const char* side : {"-x", "+x", "-y", "+y", "-z"})
    for (int k = 0; k < 4; ++k)
      text += fmt::format("die,die.{},0,0,0,{},{},9e-6,{},1,0.1\n", side, k % 2 ? 0.0015 : -0.0015,
                          k / 2 ? 0.0015 : -0.0015, 100 * k);
  put(path, text + "shoe,shoe,0,0,0,0,0,1e-6,5,1,0.1\n");
}

void write_series(const std::string& folder) {
  std::string log = "step,time_s,phase,kinetic_energy_J\n",
              series = "time_s,phase,fill_mass_kg,porosity_mean,porosity_lower_half\n";
  for (int k = 0; k < 10; ++k) {
    log += fmt::format("{},{},{},{}\n", 100 * k, 0.02 * k, phases[k / 5], k == 0 ? 0.0 : 1e-6 / k);
    series += fmt::format("{},{},{},{},{}\n", 0.02 * k, phases[k / 5], 0.00016 * k, 0.5 - 0.002 * k,
                          k < 3 ? "" : "0.47");
  }
  put(folder + "/log.csv", log);
  put(folder + "/measures.csv", series);
}

}  // namespace

void write_sample_run(const std::string& folder, const SampleRun& run) {
  put(folder + "/result.json", result_of(run).dump(1));
  write_case(folder, run);
  write_series(folder);
  for (std::size_t k = 0; k < phases.size(); ++k) {
    write_pressures(folder + "/wall-pressure/after-" + phases[k] + ".csv");
    if (run.measures) put(folder + "/measures/after-" + phases[k] + ".json", measures_of(run, k).dump());
  }
  if (!run.measures) std::filesystem::remove(folder + "/measures.csv");
  if (!run.pictures) return;
  std::filesystem::create_directories(folder + "/pictures");
  for (const char* name : {"picture.png", "pictures/whole.png", "pictures/speed.png", "pictures/size.png",
                           "pictures/after-fill.png"})
    write_png(folder + "/" + name, Image(40, 30, {0.5f, 0.5f, 0.5f}));
}

}  // namespace pulvis::test
