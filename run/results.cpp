// SPDX-License-Identifier: Apache-2.0
#include "run/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "output/picture.hpp"
#include "output/result_json.hpp"
#include "output/safe_file.hpp"
#include "run/wall_mesh.hpp"

namespace pulvis {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t reserved_bytes = 1 << 16;

const std::vector<std::string> result_files = {"case.toml",          "run.json",
                                               "result.json",        "log.csv",
                                               "picture*.png",       ".reserve",
                                               "parcels.pvd",        "walls.pvd",
                                               "porosity.pvd",       "frames/parcels-*.vtp",
                                               "frames/walls-*.vtp", "frames/porosity-*.vti"};

/// Largest overlap of a pair over the smaller radius.
double overlap_ratio(const Simulation& simulation) {
  const NearPairs& pairs = simulation.pairs();
  const NearestImage nearest = NearestImage::of(simulation.model().domain);
  double largest = 0.0;
  for (std::size_t s = 0; s < pairs.slots(); ++s) {
    if (!pairs.touching[s]) continue;
    const Parcel& p = simulation.state().parcels.body[pairs.first[s]];
    const Parcel& q = simulation.state().parcels.body[pairs.second[s]];
    const double overlap = p.radius + q.radius - norm(nearest(q.position - p.position));
    largest = std::max(largest, overlap / std::min(p.radius, q.radius));
  }
  return largest;
}

std::size_t count_of(const std::vector<std::uint8_t>& touching) {
  return static_cast<std::size_t>(std::count(touching.begin(), touching.end(), std::uint8_t{1}));
}

std::vector<std::int32_t> contacts_of(const Sight& sight) {
  std::vector<std::int32_t> contacts(sight.spheres.size(), 0);
  for (const auto& c : sight.contacts) ++contacts[c.first], ++contacts[c.second];
  return contacts;
}

Json to_json(const std::vector<Measure>& measures) {
  Json json = Json::object();
  for (const Measure& m : measures)
    json[m.name] = {{"value", m.value ? Json(*m.value) : Json()}, {"unit", m.unit}, {"window", m.window}};
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

/// Sum of the masses in order of ids, kg.
double present_mass(const Simulation& simulation) {
  double mass = 0.0;
  for (const double m : look_at(simulation).masses) mass += m;
  return mass;
}

}  // namespace

Results::Results(const Case& c, const Assembly& assembly, const std::string& folder, UsedFolder used)
    : case_(c),
      assembly_(assembly),
      folder_(folder, used, result_files),
      parcels_(folder_.file("parcels.pvd")),
      walls_(folder_.file("walls.pvd")),
      porosity_(folder_.file("porosity.pvd")) {
  // Given back before result.json is written, so that a full disk still has room for what went wrong.
  write_file_safely(folder_.file(".reserve"), std::string(reserved_bytes, ' '));
  log_ = std::make_unique<CsvLog>(
      folder_.file("log.csv"),
      std::vector<std::string>{"step", "time_s", "phase", "parcels", "pair_contacts", "wall_contacts",
                               "kinetic_energy_J", "largest_speed_m_s", "largest_overlap_over_radius",
                               "highest_point_m", "inserted_mass_kg", "escaped"});
}

void Results::write_case(const std::vector<Override>& overrides) {
  write_file_safely(folder_.file("case.toml"), case_.text);
  Json keys = Json::object();
  for (const auto& key : resolved(case_.text, case_.file, overrides))
    keys[key.key] = {{"value", key.value}, {"origin", key.origin}};
  Json limits = Json::array();
  for (const StepLimit& l : assembly_.time_step.limits)
    limits.push_back({{"kind", l.kind}, {"of", l.of}, {"time_s", l.time}});
  write_json(folder_.file("run.json"),
             {{"version", PULVIS_VERSION},
              {"case", case_.file},
              {"title", case_.title},
              {"time_step_s", assembly_.time_step.step},
              {"time_step_limits", limits},
              {"characteristic_speed_m_s", assembly_.time_step.characteristic_speed},
              {"keys", keys}});
}

void Results::log(const Simulation& simulation, const std::string& phase) {
  const State& state = simulation.state();
  const Sight sight = look_at(simulation);
  const Vec3 up = norm(case_.gravity) > 0.0 ? -case_.gravity / norm(case_.gravity) : Vec3{0, 0, 1};
  double fastest = 0.0, highest = 0.0;
  for (std::size_t k = 0; k < sight.bodies.size(); ++k) {
    fastest = std::max(fastest, norm(sight.bodies[k].velocity));
    const double top = dot(sight.spheres[k].centre, up) + sight.spheres[k].radius;
    highest = k == 0 ? top : std::max(highest, top);
  }
  const double overlap = overlap_ratio(simulation);
  largest_overlap_ = std::max(largest_overlap_, overlap);
  log_->add({static_cast<std::int64_t>(state.step), simulation.time(), std::string_view(phase),
             static_cast<std::int64_t>(state.parcels.size()),
             static_cast<std::int64_t>(count_of(simulation.pairs().touching)),
             static_cast<std::int64_t>(count_of(simulation.walls().touching)),
             measures::energies(sight.bodies, case_.gravity).kinetic(), fastest, overlap, highest,
             state.ledger.inserted_mass, static_cast<std::int64_t>(state.ledger.escaped)});
}

void Results::frame(const Simulation& simulation, const std::optional<measures::PorosityField>& porosity) {
  const double time = simulation.time();
  if (time == last_frame_) return;
  last_frame_ = time;
  const std::string number = fmt::format("{:06}", frames_++);
  folder_.folder("frames");
  const auto file = [&](const char* kind, const char* ending) {
    return fmt::format("frames/{}-{}.{}", kind, number, ending);
  };

  const Sight sight = look_at(simulation);
  std::vector<Vec3> centres, velocity, spin, force;
  std::vector<double> radius;
  std::vector<std::uint32_t> id, species;
  for (std::size_t k = 0; k < sight.spheres.size(); ++k) {
    const Parcel& p = simulation.state().parcels.body[sight.index[k]];
    centres.push_back(p.position);
    velocity.push_back(p.velocity);
    spin.push_back(p.spin);
    force.push_back(simulation.state().parcels.load[sight.index[k]].force);
    radius.push_back(p.radius);
    id.push_back(p.id);
    species.push_back(p.species);
  }
  const std::vector<std::int32_t> coordination = contacts_of(sight);
  const std::vector<Field> fields = {{"id", std::span<const std::uint32_t>(id)},
                                     {"type", std::span<const std::uint32_t>(species)},
                                     {"radius", std::span<const double>(radius)},
                                     {"velocity", std::span<const Vec3>(velocity)},
                                     {"omega", std::span<const Vec3>(spin)},
                                     {"force", std::span<const Vec3>(force)},
                                     {"coordination", std::span<const std::int32_t>(coordination)}};
  write_points_vtp(folder_.file(file("parcels", "vtp")), centres, fields, time);
  parcels_.add(time, file("parcels", "vtp"));

  const WallMesh walls =
      mesh_of_walls(simulation.model().surfaces, simulation.model().domain,
                    [&](std::uint32_t body) { return simulation.body_displacement(body); });
  const std::vector<Field> wall_fields = {{"body", std::span<const std::uint32_t>(walls.body)},
                                          {"surface", std::span<const std::uint32_t>(walls.surface)}};
  write_surface_vtp(folder_.file(file("walls", "vtp")), walls.mesh, wall_fields, time);
  walls_.add(time, file("walls", "vtp"));

  if (!porosity) return;
  Grid grid;
  grid.origin = porosity->origin;
  grid.spacing = porosity->spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) grid.cells[axis] = static_cast<int>(porosity->cells[axis]);
  const std::vector<Field> grid_fields = {
      {"porosity", std::span<const double>(porosity->values), 1, Stored::double_precision},
      {"counted_volume", std::span<const double>(porosity->counted_volume), 1, Stored::double_precision}};
  write_grid_vti(folder_.file(file("porosity", "vti")), grid, grid_fields, time);
  porosity_.add(time, file("porosity", "vti"));
}

void Results::picture(const Simulation& simulation, const std::string& name, const std::string& caption) {
  const Sight sight = look_at(simulation);
  const std::vector<std::int32_t> contacts = contacts_of(sight);
  constexpr double most_contacts = 8.0;
  PictureRequest request;
  for (std::size_t k = 0; k < sight.spheres.size(); ++k)
    request.spheres.push_back({sight.spheres[k].centre, sight.spheres[k].radius,
                               static_cast<float>(std::min(1.0, contacts[k] / most_contacts))});
  request.walls =
      mesh_of_walls(simulation.model().surfaces, simulation.model().domain, [&](std::uint32_t body) {
        return simulation.body_displacement(body);
      }).mesh;
  if (const auto die = measured_container(case_, simulation)) {
    const bool box = die->shape == measures::Container::Shape::box;
    const Vec3 middle = box ? 0.5 * (die->min + die->max) : die->base + (0.5 * die->height) * die->axis;
    request.cut = CutPlane{middle, {0, -1, 0}};
  }
  request.colour_bar = ColourBar{"contacts per parcel", 0.0, most_contacts};
  request.title = case_.title.empty() ? case_.file : case_.title;
  request.caption = caption;
  request.up = norm(case_.gravity) > 0.0 ? -case_.gravity : Vec3{0, 0, 1};
  request.threads = simulation.most_threads();
  write_picture(folder_.file(name + ".png"), request);
}

void Results::write_result(const RunSummary& summary, const Simulation* simulation, bool ended) {
  Json json = {{"exit", static_cast<int>(summary.exit)},
               {"exit_reason", summary.reason},
               {"title", case_.title},
               {"version", PULVIS_VERSION}};
  if (simulation) {
    const State state = simulation->snapshot();
    const Ledger& ledger = state.ledger;
    json["steps"] = state.step;
    json["simulated_time_s"] = simulation->time();
    json["time_step_s"] = simulation->model().dt;
    json["time_step_limit"] = assembly_.time_step.given ? "given by the case"
                                                        : assembly_.time_step.limits.front().kind + " of " +
                                                              assembly_.time_step.limits.front().of;
    json["wall_time_s"] = summary.wall_time;
    json["threads"] = simulation->most_threads();
    json["list_rebuilds"] = simulation->rebuilds();
    json["instruction_set"] = kernels::name_of(kernels::instruction_set());
    json["particles"] = state.parcels.size();
    json["time_table_s"] = {{"steps", summary.stepping_time},
                            {"measures_files_pictures", summary.looking_time}};
    json["particle_steps_per_s"] = summary.stepping_time > 0.0
                                       ? static_cast<double>(summary.particle_steps) / summary.stepping_time
                                       : 0.0;
    json["largest_overlap_over_radius"] = largest_overlap_;
    json["state_hash"] = state_hash(state);
    json["ledger"] = {{"inserted", ledger.inserted},
                      {"present", state.parcels.size()},
                      {"removed", ledger.removed},
                      {"escaped", ledger.escaped}};
    json["ledger_mass"] = {{"inserted", ledger.inserted_mass},
                           {"present", present_mass(*simulation)},
                           {"removed", ledger.removed_mass},
                           {"escaped", ledger.escaped_mass}};
    json["escapes"] = to_json(state.escapes);
  }
  Json phases = Json::array();
  for (const PhaseRecord& p : summary.phases)
    phases.push_back({{"name", p.name},
                      {"start_s", p.start},
                      {"end_s", p.end},
                      {"ended_by", p.ended_by},
                      {"measures", to_json(p.measures)}});
  json["phases"] = phases;
  json["measures"] = summary.phases.empty() ? Json::object() : to_json(summary.phases.back().measures);
  json["warnings"] = summary.warnings;
  if (ended) std::remove(folder_.file(".reserve").c_str());
  write_json(folder_.file("result.json"), json);
}

}  // namespace pulvis
