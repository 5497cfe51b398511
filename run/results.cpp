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

#include "case/units.hpp"
#include "engine/contacts/wall_sight.hpp"
#include "output/picture.hpp"
#include "output/result_json.hpp"
#include "output/safe_file.hpp"
#include "run/body_pull.hpp"
#include "run/checkpoint.hpp"
#include "run/wall_mesh.hpp"

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
                                               ".reserve",
                                               "parcels.pvd",
                                               "walls.pvd",
                                               "porosity.pvd",
                                               "frames/parcels-*.vtp",
                                               "frames/walls-*.vtp",
                                               "frames/porosity-*.vti"};

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

const std::vector<std::string> log_columns{"step",
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

/// The files that belong to what is written.
std::set<std::string> names_of(const WrittenResults& written) {
  std::set<std::string> names(written.files.begin(), written.files.end());
  names.insert({"case.toml", "run.json", "result.json", "log.csv"});
  if (written.wall_log > 0) names.insert("wall-forces.csv");
  const auto add = [&](const char* series, const std::vector<VtkSeries::Frame>& frames) {
    if (!frames.empty()) names.insert(series);
    for (const VtkSeries::Frame& frame : frames) names.insert(frame.file);
  };
  add("parcels.pvd", written.parcels);
  add("walls.pvd", written.walls);
  add("porosity.pvd", written.porosity);
  return names;
}

/// Largest overlap of a pair over the smaller radius.
double pair_overlap_ratio(const Simulation& simulation) {
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

/// Largest overlap of a parcel with a wall over its radius.
double wall_overlap_ratio(const Simulation& simulation) {
  const NearWalls& walls = simulation.walls();
  double largest = 0.0;
  for (std::size_t s = 0; s < walls.slots(); ++s) {
    if (!walls.touching[s]) continue;
    const Parcel& p = simulation.state().parcels.body[walls.parcel[s]];
    const Walls& all = simulation.model().walls;
    const Pose& pose = simulation.pose(all.surfaces[walls.surface[s]].body);
    const double overlap = p.radius - look(all, walls, s, pose.now.back(p.position)).distance;
    largest = std::max(largest, overlap / p.radius);
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

Vec3 up_in(const Case& c, double time) {
  const Vec3 pull = pull_at(c, time);
  return norm(pull) > 0.0 ? -pull / norm(pull) : Vec3{0, 0, 1};
}

/// Upright through the middle of the die, square to y where that is level and else to x.
CutPlane cut_through(const measures::Container& die, const Vec3& up) {
  const bool box = die.shape == measures::Container::Shape::box;
  const Vec3 middle = box ? 0.5 * (die.min + die.max) : die.base + (0.5 * die.height) * die.axis;
  // A slight tilt must not turn the picture, hence the tolerance.
  const bool along_y = std::abs(up.y) < std::abs(up.x) + 0.1;
  const Vec3 wish = along_y ? Vec3{0, -1, 0} : Vec3{1, 0, 0};
  return {middle, wish - dot(wish, up) * up};
}

/// Sum of the masses in order of ids, kg.
double present_mass(const Simulation& simulation) {
  double mass = 0.0;
  for (const double m : look_at(simulation).masses) mass += m;
  return mass;
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
      log_(written.log > 0 ? CsvLog::continued(folder.file("log.csv"), log_columns, written.log)
                           : CsvLog(folder.file("log.csv"), log_columns)),
      wall_results_(folder, walls, written.wall_log),
      parcels_(folder.file("parcels.pvd"), written.parcels),
      walls_(folder.file("walls.pvd"), written.walls),
      porosity_(folder.file("porosity.pvd"), written.porosity) {
  folder.remove_results(result_files, names_of(written));
  // Given back before result.json is written, so that a full disk still has room for what went wrong.
  write_file_safely(folder_.file(".reserve"), std::string(reserved_bytes, ' '));
}

WrittenResults Results::written() {
  written_.log = log_.sync();
  written_.wall_log = wall_results_.sync();
  written_.parcels = parcels_.frames();
  written_.walls = walls_.frames();
  written_.porosity = porosity_.frames();
  return written_;
}

void Results::write_case() {
  write_file_safely(folder_.file("case.toml"), case_.text);
  Json keys = Json::object();
  for (const ResolvedKey& key : case_.keys) keys[key.key] = {{"value", key.value}, {"origin", key.origin}};
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

void Results::log(const Simulation& simulation, const std::string& phase) {
  const State& state = simulation.state();
  const Sight sight = look_at(simulation);
  const Vec3 up = up_in(case_, simulation.time());
  double fastest = 0.0, highest = 0.0;
  for (std::size_t k = 0; k < sight.bodies.size(); ++k) {
    fastest = std::max(fastest, norm(sight.bodies[k].velocity));
    const double top = dot(sight.spheres[k].centre, up) + sight.spheres[k].radius;
    highest = k == 0 ? top : std::max(highest, top);
  }
  const double overlap = std::max(pair_overlap_ratio(simulation), wall_overlap_ratio(simulation));
  written_.largest_overlap = std::max(written_.largest_overlap, overlap);
  log_.add({static_cast<std::int64_t>(state.step), simulation.time(), std::string_view(phase),
            static_cast<std::int64_t>(state.parcels.size()),
            static_cast<std::int64_t>(count_of(simulation.pairs().touching)),
            static_cast<std::int64_t>(count_of(simulation.walls().touching)),
            measures::energies(sight.bodies, simulation.field().gravity).kinetic(), fastest, overlap, highest,
            state.ledger.inserted_mass, static_cast<std::int64_t>(state.ledger.escaped)});
}

void Results::frame(const Simulation& simulation, const WallLoads& loads,
                    const std::optional<measures::PorosityField>& porosity) {
  const double time = simulation.time();
  if (time == written_.last_frame) return;
  written_.last_frame = time;
  const std::string number = fmt::format("{:06}", written_.frames++);
  folder_.folder("frames");
  const auto file = [&](const char* kind, const char* ending) {
    return fmt::format("frames/{}-{}.{}", kind, number, ending);
  };

  // A frame of millions of parcels is large: only what is written is held while it is.
  std::vector<std::uint32_t> index;
  std::vector<std::int32_t> coordination;
  {
    Sight sight = look_at(simulation);
    coordination = contacts_of(sight);
    index = std::move(sight.index);
  }
  const std::size_t count = index.size();
  std::vector<Vec3> centres(count), velocity(count), spin(count), force(count);
  std::vector<double> radius(count);
  std::vector<std::uint32_t> id(count), species(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Parcel& p = simulation.state().parcels.body[index[k]];
    centres[k] = p.position;
    velocity[k] = p.velocity;
    spin[k] = p.spin;
    force[k] = simulation.state().parcels.load[index[k]].force;
    radius[k] = p.radius;
    id[k] = p.id;
    species[k] = p.species;
  }
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
      mesh_of_walls(simulation.model().walls, simulation.model().domain,
                    [&](std::uint32_t body) -> const Pose& { return simulation.pose(body); });
  const WallFields bear = wall_fields(walls, loads, simulation);
  const std::vector<Field> on_walls = {{"body", std::span<const std::uint32_t>(walls.body)},
                                       {"wall", std::span<const std::uint32_t>(walls.wall)},
                                       {"surface", std::span<const std::uint32_t>(walls.surface)},
                                       {"pressure", std::span<const double>(bear.pressure)},
                                       {"shear_stress", std::span<const double>(bear.shear_stress)},
                                       {"normal_force", std::span<const double>(bear.normal_force)},
                                       {"shear_force", std::span<const double>(bear.shear_force)}};
  write_surface_vtp(folder_.file(file("walls", "vtp")), walls.mesh, on_walls, time);
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

void Results::picture(const Simulation& simulation, const std::string& phase, bool last) {
  const Sight sight = look_at(simulation);
  const std::vector<std::int32_t> contacts = contacts_of(sight);
  constexpr double most_contacts = 8.0;
  PictureRequest request;
  for (std::size_t k = 0; k < sight.spheres.size(); ++k)
    request.spheres.push_back({sight.spheres[k].centre, sight.spheres[k].radius,
                               static_cast<float>(std::min(1.0, contacts[k] / most_contacts))});
  request.walls = mesh_of_walls(simulation.model().walls, simulation.model().domain,
                                [&](std::uint32_t body) -> const Pose& { return simulation.pose(body); })
                      .mesh;
  request.up = up_in(case_, simulation.time());
  if (const auto die = measured_container(case_, simulation)) request.cut = cut_through(*die, request.up);
  request.colour_bar = ColourBar{"contacts per parcel", 0.0, most_contacts};
  request.title = case_.title.empty() ? case_.file : case_.title;
  request.caption =
      fmt::format("after phase \"{}\", t = {}", phase, format_quantity(simulation.time(), dimension::time));
  request.threads = simulation.most_threads();
  if (!last) folder_.folder("pictures");
  const std::string name = last ? "picture.png" : "pictures/after-" + phase + ".png";
  write_picture(folder_.file(name), request);
  written_.files.push_back(name);
}

void Results::write_result(const RunSummary& summary, const Simulation* simulation, bool ended) {
  Json json = {{"exit", static_cast<int>(summary.exit)},
               {"exit_reason", summary.reason},
               {"title", case_.title},
               {"version", PULVIS_VERSION}};
  if (simulation) {
    const State& state = simulation->state();
    const Ledger& ledger = state.ledger;
    json["steps"] = state.step;
    json["simulated_time_s"] = simulation->time();
    json["time_step_s"] = simulation->model().dt;
    json["time_step_limit"] = time_step_.given
                                  ? "given by the case"
                                  : time_step_.limits.front().kind + " of " + time_step_.limits.front().of;
    json["wall_time_s"] = summary.wall_time;
    json["resumes"] = summary.resumes;
    json["threads"] = simulation->most_threads();
    json["threads_used"] = simulation->threads();
    json["list_rebuilds"] = simulation->rebuilds();
    json["instruction_set"] = kernels::name_of(kernels::instruction_set());
    json["particles"] = state.parcels.size();
    json["time_table_s"] = {{"steps", summary.stepping_time},
                            {"measures_files_pictures", summary.looking_time}};
    json["particle_steps_per_s"] = summary.stepping_time > 0.0
                                       ? static_cast<double>(summary.particle_steps) / summary.stepping_time
                                       : 0.0;
    json["largest_overlap_over_radius"] = written_.largest_overlap;
    json["state_hash"] = simulation->hash();
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
                      {"measures", to_json(p.measures)},
                      {"walls", to_json(p.walls)}});
  json["phases"] = phases;
  json["measures"] = summary.phases.empty() ? Json::object() : to_json(summary.phases.back().measures);
  json["notes"] = summary.notes;
  json["warnings"] = summary.warnings;
  if (ended) std::remove(folder_.file(".reserve").c_str());
  write_json(folder_.file("result.json"), json);
}

}  // namespace pulvis
