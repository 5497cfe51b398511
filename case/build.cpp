// SPDX-License-Identifier: Apache-2.0
#include "case/build.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include "case/build_walls.hpp"
#include "case/rules.hpp"

namespace pulvis::case_file {
namespace {

// The choices as the key table spells them, and what they are in a `Case`.
template <typename Choice, std::size_t count>
Choice chosen(const std::array<std::pair<const char*, Choice>, count>& choices, const std::string& text) {
  for (const auto& [name, choice] : choices)
    if (text == name) return choice;
  throw std::logic_error("the choice \"" + text + "\" is declared, but means nothing");
}

constexpr std::array<std::pair<const char*, Mixing>, 5> mixing_rules{
    {{"geometric_mean", Mixing::geometric_mean},
     {"arithmetic_mean", Mixing::arithmetic_mean},
     {"harmonic_mean", Mixing::harmonic_mean},
     {"smaller", Mixing::smaller},
     {"larger", Mixing::larger}}};
constexpr std::array<std::pair<const char*, SizeDistribution::Kind>, 5> size_kinds{
    {{"single", SizeDistribution::Kind::single},
     {"uniform", SizeDistribution::Kind::uniform},
     {"normal", SizeDistribution::Kind::normal},
     {"lognormal", SizeDistribution::Kind::lognormal},
     {"table", SizeDistribution::Kind::table}}};
constexpr std::array<std::pair<const char*, Powder::Keep>, 2> keeps{
    {{"pull_off", Powder::Keep::pull_off}, {"sticking_speed", Powder::Keep::sticking_speed}}};
constexpr std::array<std::pair<const char*, Source::Kind>, 4> source_kinds{{{"pack", Source::Kind::pack},
                                                                            {"dense", Source::Kind::dense},
                                                                            {"rain", Source::Kind::rain},
                                                                            {"file", Source::Kind::file}}};
constexpr std::array<std::pair<const char*, Phase::Until>, 6> criteria{{{"time", Phase::Until::time},
                                                                        {"inserted", Phase::Until::inserted},
                                                                        {"mass", Phase::Until::mass},
                                                                        {"cycles", Phase::Until::cycles},
                                                                        {"motions", Phase::Until::motions},
                                                                        {"rest", Phase::Until::rest}}};

// The value of a key that counts only under a condition, 0 where that does not hold.
double number_or_zero(const Section& section, const std::string& key) {
  return section.optional_number(key).value_or(0.0);
}

class Builder {
 public:
  explicit Builder(const Section& root) : root_(root) {
    for (const auto& [table, group] : root.groups)
      for (std::size_t i = 0; i < group.size(); ++i) indices_[table].emplace(group[i].name, i);
  }

  Case build(const std::string& name) const {
    Case result;
    result.title = root_.text("title");
    result.seed = static_cast<std::uint64_t>(root_.integer("seed"));
    result.body_force = body_force(root_.table("gravity"), root_.table("rotating_frame"));
    result.domain = domain(root_.table("domain"));
    result.mixing = chosen(mixing_rules, root_.table("mixing").text("rule"));
    for (const Section& section : root_.group("materials")) result.materials.push_back(material(section));
    for (const Section& section : root_.group("pairs")) result.pairs.push_back(pair(section));
    for (const Section& section : root_.group("powders")) result.powders.push_back(powder(section));
    result.contact = contact(root_.table("contact"));
    const std::string folder = std::filesystem::absolute(name).parent_path().string();
    for (const Section& section : root_.group("walls")) result.walls.push_back(wall(section, folder));
    for (const Section& section : root_.group("motions")) result.motions.push_back(build_motion(section));
    for (const Section& section : root_.group("sources")) result.sources.push_back(source(section, name));
    for (const Section& section : root_.group("phases")) result.phases.push_back(phase(section));
    result.time = time(root_.table("time"));
    result.measures = measures(root_.table("measures"));
    result.output = output(root_.table("output"));
    return result;
  }

 private:
  std::size_t index(const std::string& table, const std::string& name) const {
    return indices_.at(table).at(name);
  }

  std::optional<std::size_t> optional_index(const std::string& table, const Section& section,
                                            const std::string& key) const {
    const std::string* name = section.optional_text(key);
    return name != nullptr ? std::optional(index(table, *name)) : std::nullopt;
  }

  std::vector<std::size_t> indices(const std::string& table, const std::vector<std::string>& names) const {
    std::vector<std::size_t> result;
    for (const std::string& name : names) result.push_back(index(table, name));
    return result;
  }

  static Domain domain(const Section& section) {
    Domain result;
    result.min = section.vector("min");
    result.max = section.vector("max");
    for (const std::string& axis : section.texts("periodic")) result.periodic[axis.front() - 'x'] = true;
    if (const Section& shear = section.table("shear"); shear.given) {
      result.shear.rate = shear.number("rate");
      result.shear.flow = shear.text("flow").front() - 'x';
      result.shear.gradient = shear.text("gradient").front() - 'x';
    }
    result.escape_is_error = section.text("escape") == "error";
    return result;
  }

  static Material material(const Section& section) {
    Material result;
    result.name = section.name;
    result.density = section.number("density");
    result.young_modulus = section.number("young_modulus");
    result.poisson_ratio = section.number("poisson_ratio");
    result.surface_energy = section.number("surface_energy");
    result.restitution = section.number("restitution");
    result.friction = section.number("friction");
    result.rolling_friction = section.number("rolling_friction");
    return result;
  }

  PairOverride pair(const Section& section) const {
    PairOverride result;
    result.first = index("materials", section.texts("materials")[0]);
    result.second = index("materials", section.texts("materials")[1]);
    result.restitution = section.optional_number("restitution");
    result.friction = section.optional_number("friction");
    result.rolling_friction = section.optional_number("rolling_friction");
    result.work_of_adhesion = section.optional_number("work_of_adhesion");
    for (const auto& [key, setting] : section.settings)
      if (setting.valid && find_key("contact", key) != nullptr)
        result.numbers.emplace_back(key, (key == "contact_angle" ? 2.0 * pi : 1.0) * setting.numbers.front());
    return result;
  }

  static SizeDistribution size(const Section& section) {
    SizeDistribution result;
    result.kind = chosen(size_kinds, section.text("kind"));
    result.diameter = number_or_zero(section, "diameter");
    result.standard_deviation = number_or_zero(section, "standard_deviation");
    result.geometric_deviation = section.optional_number("geometric_deviation").value_or(1.0);
    result.smallest = number_or_zero(section, "smallest");
    result.largest = number_or_zero(section, "largest");
    if (result.kind == SizeDistribution::Kind::single) result.smallest = result.largest = result.diameter;
    if (result.kind == SizeDistribution::Kind::table) {
      result.diameters = section.numbers("diameters");
      result.shares = section.numbers("shares");
      result.by_mass = section.text("by") == "mass";
      result.smallest = result.diameters.front();
      result.largest = result.diameters.back();
    }
    return result;
  }

  Powder powder(const Section& section) const {
    Powder result;
    result.name = section.name;
    result.material = index("materials", section.text("material"));
    result.size = size(section.table("size"));
    result.coarse_graining = section.number("coarse_graining");
    result.simulated_modulus = section.optional_number("simulated_modulus");
    result.keep = chosen(keeps, section.text("keep"));
    return result;
  }

  static ContactChoice contact(const Section& section) {
    ContactChoice c;
    for (const auto& [key, field] : {std::pair{"normal", &c.normal},
                                     {"cohesion", &c.cohesion},
                                     {"damping", &c.damping},
                                     {"sliding", &c.sliding},
                                     {"rolling", &c.rolling},
                                     {"twisting", &c.twisting},
                                     {"friction_limit", &c.friction_limit},
                                     {"cohesion_in_limit", &c.cohesion_in_limit},
                                     {"damping_radius", &c.damping_radius},
                                     {"similarity", &c.similarity}})
      *field = section.text(key);
    if (const std::string* form = section.optional_text("bridges_form")) c.bridges_form = *form;
    c.tangential_damping = section.flag("tangential_damping");
    for (const auto& [key, field] : {std::pair{"normal_stiffness", &c.normal_stiffness},
                                     {"characteristic_speed", &c.characteristic_speed},
                                     {"tangential_ratio", &c.tangential_ratio},
                                     {"plastic_ratio", &c.plastic_ratio},
                                     {"adhesion_ratio", &c.adhesion_ratio},
                                     {"plasticity_depth", &c.plasticity_depth},
                                     {"unloading_ratio", &c.unloading_ratio},
                                     {"constant_pull", &c.constant_pull},
                                     {"loading_exponent", &c.loading_exponent},
                                     {"adhesion_exponent", &c.adhesion_exponent},
                                     {"cohesion_energy_density", &c.cohesion_energy_density},
                                     {"surface_tension", &c.surface_tension},
                                     {"contact_angle", &c.contact_angle},
                                     {"liquid_content", &c.liquid_content},
                                     {"liquid_viscosity", &c.liquid_viscosity},
                                     {"shortest_bridge_gap", &c.shortest_bridge_gap},
                                     {"hamaker_constant", &c.hamaker_constant},
                                     {"shortest_gap", &c.shortest_gap},
                                     {"longest_gap", &c.longest_gap},
                                     {"rolling_viscosity", &c.rolling_viscosity},
                                     {"twisting_friction", &c.twisting_friction}})
      *field = section.optional_number(key).value_or(*field);
    c.contact_angle *= 2.0 * pi;  // angles of a case are in cycles
    return c;
  }

  Wall wall(const Section& section, const std::string& folder) const {
    Wall result = build_wall(section, folder);
    result.material = index("materials", section.text("material"));
    if (const Setting* motions = section.find("motion")) result.motions = indices("motions", motions->texts);
    return result;
  }

  static BodyForce body_force(const Section& gravity, const Section& frame) {
    BodyForce result;
    result.gravity = gravity.vector("acceleration");
    if (const Setting* times = gravity.find("times")) {
      result.times = times->numbers;
      const Setting* factors = gravity.find("factors");
      for (std::size_t k = 0; k < result.times.size(); ++k) {
        Vec3 at = factors != nullptr ? factors->numbers[k] * result.gravity : result.gravity;
        for (int axis = 0; axis < 3; ++axis)
          if (const Setting* list = gravity.find(std::string(1, "xyz"[axis]))) at[axis] = list->numbers[k];
        result.table.push_back(at);
      }
    }
    if (!frame.given) return result;
    result.rotation = frame.number("rate");
    result.ramp = frame.number("ramp");
    result.axis = frame.unit_vector("axis");
    result.point = frame.vector("point");
    return result;
  }

  Source source(const Section& section, const std::string& name) const {
    Source result;
    result.name = section.name;
    result.kind = chosen(source_kinds, section.text("kind"));
    // Without the key there is only one powder; the rules saw to that.
    result.powder = optional_index("powders", section, "powder").value_or(0);
    if (result.kind == Source::Kind::file) {
      const std::filesystem::path folder = std::filesystem::absolute(name).parent_path();
      result.path = (folder / section.text("path")).lexically_normal().string();
      return result;
    }
    result.velocity = section.vector("velocity");
    if (result.kind == Source::Kind::dense) {
      result.solid_fraction = section.number("solid_fraction");
      result.region.min = root_.table("domain").vector("min");
      result.region.max = root_.table("domain").vector("max");
      return result;
    }
    result.region = build_region(section.table("region"));
    result.target.mass = section.optional_number("mass");
    if (section.find("count") != nullptr)
      result.target.count = static_cast<std::uint64_t>(section.integer("count"));
    result.mass_rate = number_or_zero(section, "mass_rate");
    result.sieve_pitch = section.optional_number("sieve_pitch");
    result.sieve_opening = section.optional_number("sieve_opening");
    return result;
  }

  Phase phase(const Section& section) const {
    Phase result;
    result.name = section.text("name");
    result.sources = indices("sources", section.texts("sources"));
    result.motions = indices("motions", section.texts("motions"));
    result.without = indices("walls", section.texts("without"));
    result.until = chosen(criteria, section.text("until"));
    result.duration = number_or_zero(section, "duration");
    result.mass = number_or_zero(section, "mass");
    result.cycles = number_or_zero(section, "cycles");
    result.kinetic_energy = section.optional_number("kinetic_energy");
    result.at_least = number_or_zero(section, "at_least");
    result.time_limit = number_or_zero(section, "time_limit");
    const std::string* at_limit = section.optional_text("at_limit");
    result.limit_is_error = at_limit != nullptr && *at_limit == "error";
    return result;
  }

  static TimeChoice time(const Section& section) {
    TimeChoice result;
    result.fraction = section.optional_number("fraction").value_or(result.fraction);
    result.step = section.optional_number("step");
    result.characteristic_speed = section.optional_number("characteristic_speed");
    return result;
  }

  MeasureChoice measures(const Section& section) const {
    MeasureChoice result;
    result.die = optional_index("walls", section, "die");
    if (section.table("region").given) result.region = build_region(section.table("region"));
    const std::vector<std::size_t> inside = walls_with_inside(root_);
    if (!result.die && !result.region && inside.size() == 1) result.die = inside.front();
    result.cell_diameters = section.number("cell_diameters");
    result.wall_window = section.optional_number("wall_window");
    result.column_diameters = section.number("column_diameters");
    result.interval = section.number("interval");
    result.energy_ledger = section.flag("energy_ledger");
    for (const Section& part : section.group("parts"))
      result.parts.push_back({part.name, part.vector("min"), part.vector("max")});
    for (const Section& surface : section.group("surfaces"))
      result.surfaces.push_back({surface.name, surface.vector("point"), surface.unit_vector("normal"),
                                 surface.optional_number("radius")});
    return result;
  }

  static OutputChoice output(const Section& section) {
    return {section.number("interval"), section.number("log_interval"), section.number("checkpoint_interval"),
            section.flag("picture"), section.flag("report")};
  }

  const Section& root_;
  std::map<std::string, std::map<std::string, std::size_t>> indices_;
};

}  // namespace

Case build_case(const Section& root, const std::string& name) { return Builder(root).build(name); }

}  // namespace pulvis::case_file
