// SPDX-License-Identifier: Apache-2.0
#include "run/result_file.hpp"

#include <nlohmann/json.hpp>

#include "run/energy_lines.hpp"
#include "run/measures_json.hpp"
#include "run/sight.hpp"

namespace pulvis {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const std::vector<WallForce>& walls) {
  const auto list = [](const Vec3& v) { return Json{v.x, v.y, v.z}; };
  Json json = Json::object();
  for (const WallForce& w : walls)
    json[w.name] = {
        {"force_N", list(w.load.force)}, {"torque_N_m", list(w.load.torque)}, {"window", w.window}};
  return json;
}

Json to_json(const std::vector<Escape>& escapes) {
  Json list = Json::array();
  for (const Escape& e : escapes)
    list.push_back({{"id", e.id},
                    {"time_s", e.time},
                    {"position_m", {e.position.x, e.position.y, e.position.z}},
                    {"speed_m_s", norm(e.velocity)},
                    {"through", e.through}});
  return list;
}

Json to_json(const TaskSeconds& times) {
  Json json = Json::object();
  for (std::size_t k = 0; k < task_names.size(); ++k) json[task_names[k]] = times.of[k];
  return json;
}

Json energy_json(const EnergyBalance& balance) {
  Json json = Json::object();
  for (const EnergyLine& line : energy_lines(balance)) json[std::string(line.name) + "_J"] = line.value;
  json["closing_share"] = balance.closing_share();
  return json;
}

/// Sum of the masses in order of ids, kg.
double present_mass(const Simulation& simulation) {
  double mass = 0.0;
  for (const double m : look_at(simulation).masses) mass += m;
  return mass;
}

}  // namespace

Json result_json(const Case& c, const TimeStep& time_step, const RunSummary& summary,
                 const Simulation* simulation, double largest_overlap) {
  Json json = {{"exit", static_cast<int>(summary.exit)},
               {"exit_reason", summary.reason},
               {"title", c.title},
               {"version", PULVIS_VERSION}};
  if (simulation) {
    const State& state = simulation->state();
    const Ledger& ledger = state.ledger;
    json["steps"] = state.step;
    json["simulated_time_s"] = simulation->time();
    json["time_step_s"] = simulation->model().dt;
    json["time_step_limit"] = time_step.given
                                  ? "given by the case"
                                  : time_step.limits.front().kind + " of " + time_step.limits.front().of;
    const TaskSeconds& times = simulation->times().seconds();
    json["wall_time_s"] = times.total();
    json["resumes"] = summary.resumes;
    json["threads"] = simulation->most_threads();
    json["threads_used"] = simulation->threads();
    json["list_rebuilds"] = simulation->rebuilds();
    json["instruction_set"] = kernels::name_of(kernels::instruction_set());
    json["particles"] = state.parcels.size();
    json["stepping_time_s"] = times.of_steps();
    json["time_table_s"] = to_json(times);
    json["particle_steps_per_s"] =
        times.of_steps() > 0.0 ? static_cast<double>(summary.particle_steps) / times.of_steps() : 0.0;
    json["largest_overlap_over_radius"] = largest_overlap;
    json["state_hash"] = simulation->hash();
    json["ledger"] = {{"inserted", ledger.inserted},
                      {"present", state.parcels.size()},
                      {"removed", ledger.removed},
                      {"escaped", ledger.escaped}};
    json["ledger_mass"] = {{"inserted", ledger.inserted_mass},
                           {"present", present_mass(*simulation)},
                           {"removed", ledger.removed_mass},
                           {"escaped", ledger.escaped_mass}};
    if (const auto energy = simulation->energy()) json["energy"] = energy_json(*energy);
    json["escapes"] = to_json(state.escapes);
  }
  Json phases = Json::array();
  for (const PhaseRecord& p : summary.phases)
    phases.push_back({{"name", p.name},
                      {"start_s", p.start},
                      {"end_s", p.end},
                      {"ended_by", p.ended_by},
                      {"measures", scalars_json(p.measures)},
                      {"walls", to_json(p.walls)}});
  json["phases"] = phases;
  json["measures"] = summary.phases.empty() ? Json::object() : scalars_json(summary.phases.back().measures);
  json["notes"] = summary.notes;
  json["warnings"] = summary.warnings;
  return json;
}

}  // namespace pulvis
