// SPDX-License-Identifier: Apache-2.0
#include "case/keys.hpp"

// One row per key; the order is that of the reference page.
namespace pulvis::case_file {
namespace {

using enum KeyKind;
using enum Presence;
using Keys = std::vector<Key>;

constexpr Range positive{Range::End::excluded, Range::End::open, 0.0, 0.0};
constexpr Range not_negative{Range::End::included, Range::End::open, 0.0, 0.0};
constexpr Range fraction{Range::End::excluded, Range::End::included, 0.0, 1.0};

void append(Keys& keys, Keys more) { keys.insert(keys.end(), more.begin(), more.end()); }

// A box or a cylinder, wherever one is described: as a region or as the inside of a wall.
void append_shape(Keys& keys, const std::string& table) {
  const Condition box{"shape", {"box"}}, cylinder{"shape", {"cylinder"}};
  append(keys, {
    {.pattern = table + ".min", .kind = vector, .dimension = dimension::length, .example = R"(["0 mm", "0 mm", "0 mm"])",
     .presence = required, .only_when = box, .help = "corner of the box with the smallest coordinates"},
    {.pattern = table + ".max", .kind = vector, .dimension = dimension::length, .example = R"(["2 mm", "2 mm", "5 mm"])",
     .presence = required, .only_when = box, .help = "corner of the box with the largest coordinates"},
    {.pattern = table + ".base", .kind = vector, .dimension = dimension::length, .example = R"(["0 mm", "0 mm", "0 mm"])",
     .presence = required, .only_when = cylinder, .help = "centre of the lower end of the cylinder"},
    {.pattern = table + ".axis", .kind = direction, .example = "[0, 0, 1]", .standard = "[0, 0, 1]",
     .only_when = cylinder, .help = "direction from the base to the other end"},
    {.pattern = table + ".radius", .kind = quantity, .dimension = dimension::length, .example = R"("1 mm")",
     .presence = required, .range = positive, .only_when = cylinder, .help = "radius of the cylinder"},
    {.pattern = table + ".height", .kind = quantity, .dimension = dimension::length, .example = R"("5 mm")",
     .presence = required, .range = positive, .only_when = cylinder, .help = "length of the cylinder along its axis"},
  });
}

void append_general(Keys& keys) {
  append(keys, {
    {.pattern = "title", .kind = text, .example = R"("molybdenum into a cuboid die")", .standard = R"("")",
     .help = "what this case is, for reports"},
    {.pattern = "seed", .kind = integer, .example = "7", .standard = "1", .range = not_negative,
     .help = "start of the random numbers; the same seed gives the same run"},

    {.pattern = "domain", .kind = table, .presence = required, .help = "the space in which parcels may be"},
    {.pattern = "domain.min", .kind = vector, .dimension = dimension::length, .example = R"(["0 mm", "0 mm", "0 mm"])",
     .presence = required, .help = "corner with the smallest coordinates"},
    {.pattern = "domain.max", .kind = vector, .dimension = dimension::length, .example = R"(["2 mm", "2 mm", "9 mm"])",
     .presence = required, .help = "corner with the largest coordinates"},
    {.pattern = "domain.periodic", .kind = choices, .example = R"(["x", "y"])", .standard = "[]", .choices = {"x", "y", "z"},
     .help = "directions in which what leaves at one side comes back at the other"},
    {.pattern = "domain.escape", .kind = choice, .example = R"("count")", .standard = R"("error")", .choices = {"error", "count"},
     .help = "what a parcel does that leaves the domain or passes a wall: stop the run, or be removed and counted"},

    {.pattern = "gravity", .kind = table, .help = "the weight of things"},
    {.pattern = "gravity.acceleration", .kind = vector, .dimension = dimension::acceleration,
     .example = R"(["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"])", .standard = R"(["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"])",
     .help = "acceleration by gravity, in any direction"},
  });
}

void append_materials(Keys& keys) {
  append(keys, {
    {.pattern = "materials", .kind = named_tables, .presence = required, .help = "what powders and walls are made of"},
    {.pattern = "materials.*.density", .kind = quantity, .dimension = dimension::density, .example = R"("10.2 g/cm^3")",
     .presence = required, .range = positive, .help = "density of the solid"},
    {.pattern = "materials.*.young_modulus", .kind = quantity, .dimension = dimension::pressure, .example = R"("70 GPa")",
     .presence = required, .range = positive, .help = "Young's modulus of the solid"},
    {.pattern = "materials.*.poisson_ratio", .kind = number, .example = "0.31", .presence = required,
     .range = {Range::End::excluded, Range::End::excluded, -1.0, 0.5}, .help = "Poisson's ratio of the solid"},
    {.pattern = "materials.*.surface_energy", .kind = quantity, .dimension = dimension::surface_energy, .example = R"("0.1 mJ/m^2")",
     .standard = R"("0 J/m^2")", .range = not_negative,
     .help = "energy gamma of one surface; two surfaces adhere with W = 2 sqrt(gamma_1 gamma_2)"},
    {.pattern = "materials.*.restitution", .kind = number, .example = "0.5", .presence = required, .range = fraction,
     .help = "coefficient of restitution against itself"},
    {.pattern = "materials.*.friction", .kind = number, .example = "0.4", .presence = required, .range = not_negative,
     .help = "coefficient of sliding friction against itself"},
    {.pattern = "materials.*.rolling_friction", .kind = number, .example = "0.05", .standard = "0", .range = not_negative,
     .help = "coefficient of rolling friction against itself"},

    {.pattern = "mixing", .kind = table, .help = "contacts between different materials"},
    {.pattern = "mixing.rule", .kind = choice, .example = R"("smaller")", .standard = R"("geometric_mean")",
     .choices = {"geometric_mean", "arithmetic_mean", "harmonic_mean", "smaller", "larger"},
     .help = "how the restitution and friction of two materials make that of their pair"},

    {.pattern = "pairs", .kind = listed_tables, .help = "pairs of materials that do not follow the mixing rule"},
    {.pattern = "pairs[].materials", .kind = names, .example = R"(["molybdenum", "steel"])", .presence = required, .length = 2,
     .refers_to = "materials", .help = "the two materials"},
    {.pattern = "pairs[].restitution", .kind = number, .example = "0.3", .when_unset = "the mixing rule", .range = fraction,
     .help = "coefficient of restitution between the two"},
    {.pattern = "pairs[].friction", .kind = number, .example = "0.3", .when_unset = "the mixing rule", .range = not_negative,
     .help = "coefficient of sliding friction between the two"},
    {.pattern = "pairs[].rolling_friction", .kind = number, .example = "0.02", .when_unset = "the mixing rule", .range = not_negative,
     .help = "coefficient of rolling friction between the two"},
    {.pattern = "pairs[].work_of_adhesion", .kind = quantity, .dimension = dimension::surface_energy, .example = R"("0.2 mJ/m^2")",
     .when_unset = "2 sqrt(gamma_1 gamma_2)", .range = not_negative, .help = "work of adhesion W between the two"},
  });
}

void append_powders(Keys& keys) {
  const Condition spread{"kind", {"uniform", "normal", "lognormal"}}, listed{"kind", {"table"}};
  append(keys, {
    {.pattern = "powders", .kind = named_tables, .presence = required, .help = "grains of one material and their sizes"},
    {.pattern = "powders.*.material", .kind = name, .example = R"("molybdenum")", .presence = required, .refers_to = "materials",
     .help = "what the grains are made of"},
    {.pattern = "powders.*.coarse_graining", .kind = number, .example = "50", .standard = "1",
     .range = {Range::End::included, Range::End::open, 1.0, 0.0},
     .help = "diameter of a simulated parcel over that of the grains it stands for"},
    {.pattern = "powders.*.simulated_modulus", .kind = quantity, .dimension = dimension::pressure, .example = R"("50 MPa")",
     .when_unset = "that of the material", .range = positive,
     .help = "Young's modulus used instead of the real one, to allow longer time steps (softening)"},
    {.pattern = "powders.*.keep", .kind = choice, .example = R"("sticking_speed")", .standard = R"("pull_off")",
     .choices = {"pull_off", "sticking_speed"}, .help = "which measure of cohesion the softened powder keeps"},

    {.pattern = "powders.*.size", .kind = table, .presence = required, .help = "diameters of the real grains"},
    {.pattern = "powders.*.size.kind", .kind = choice, .example = R"("single")", .presence = required,
     .choices = {"single", "uniform", "normal", "lognormal", "table"}, .help = "kind of distribution, by number"},
    {.pattern = "powders.*.size.diameter", .kind = quantity, .dimension = dimension::length, .example = R"("4.6 um")",
     .presence = required, .range = positive, .only_when = {"kind", {"single", "normal", "lognormal"}},
     .help = "the diameter (single), its mean (normal), its median (lognormal)"},
    {.pattern = "powders.*.size.standard_deviation", .kind = quantity, .dimension = dimension::length, .example = R"("0.5 um")",
     .presence = required, .range = positive, .only_when = {"kind", {"normal"}}, .help = "standard deviation, before the cut-offs"},
    {.pattern = "powders.*.size.geometric_deviation", .kind = number, .example = "1.3", .presence = required,
     .range = {Range::End::excluded, Range::End::open, 1.0, 0.0}, .only_when = {"kind", {"lognormal"}},
     .help = "exp of the standard deviation of ln d, before the cut-offs"},
    {.pattern = "powders.*.size.smallest", .kind = quantity, .dimension = dimension::length, .example = R"("3 um")",
     .presence = required, .range = positive, .only_when = spread, .help = "smallest diameter; grains below are left out"},
    {.pattern = "powders.*.size.largest", .kind = quantity, .dimension = dimension::length, .example = R"("7 um")",
     .presence = required, .range = positive, .only_when = spread, .help = "largest diameter; grains above are left out"},
    {.pattern = "powders.*.size.diameters", .kind = quantities, .dimension = dimension::length, .example = R"(["3 um", "5 um", "7 um"])",
     .presence = required, .range = positive, .only_when = listed, .help = "the diameters that occur, ascending"},
    {.pattern = "powders.*.size.shares", .kind = numbers, .example = "[1, 3, 1]", .presence = required, .range = positive,
     .only_when = listed, .help = "share of each diameter; the sum does not matter"},
    {.pattern = "powders.*.size.by", .kind = choice, .example = R"("mass")", .standard = R"("number")", .choices = {"number", "mass"},
     .only_when = listed, .help = "what the shares are shares of"},
  });
}

void append_contact(Keys& keys) {
  append(keys, {
    {.pattern = "contact", .kind = table, .help = "the parts of the contact law, between parcels and on walls"},
    {.pattern = "contact.normal", .kind = choice, .example = R"("jkr")", .standard = R"("hertz")", .choices = {"hertz", "jkr"},
     .help = "normal force: elastic spheres, or elastic spheres that adhere"},
    {.pattern = "contact.damping", .kind = choice, .example = R"("restitution")", .standard = R"("restitution")",
     .choices = {"restitution", "none"}, .help = "normal dashpot: from the coefficient of restitution (Tsuji), or none"},
    {.pattern = "contact.sliding", .kind = choice, .example = R"("total_spring")", .standard = R"("total_spring")",
     .choices = {"total_spring", "none"}, .help = "tangential force: spring with Coulomb's limit, or none"},
    {.pattern = "contact.rolling", .kind = choice, .example = R"("elastic_plastic")", .standard = R"("none")",
     .choices = {"elastic_plastic", "none"}, .help = "rolling resistance: elastic-plastic spring (EPSD2), or none"},
    {.pattern = "contact.friction_limit", .kind = choice, .example = R"("total")", .standard = R"("elastic")",
     .choices = {"elastic", "total"}, .help = "normal force in the friction limits: without its dashpot, or with it (as LIGGGHTS)"},
    {.pattern = "contact.damping_radius", .kind = choice, .example = R"("jkr_radius")", .standard = R"("hertz")",
     .choices = {"hertz", "jkr_radius"},
     .help = "stiffness that damping uses under JKR: Hertz's at the same overlap, or that of the JKR contact radius"},
  });
}

void append_walls(Keys& keys) {
  const Condition plane{"shape", {"plane"}};
  append(keys, {
    {.pattern = "walls", .kind = named_tables, .help = "what holds the powder"},
    {.pattern = "walls.*.shape", .kind = choice, .example = R"("box")", .presence = required, .choices = {"plane", "box", "cylinder"},
     .help = "shape of the wall; powder is inside a box or cylinder"},
    {.pattern = "walls.*.material", .kind = name, .example = R"("steel")", .presence = required, .refers_to = "materials",
     .help = "what the wall is made of"},
    {.pattern = "walls.*.motion", .kind = name, .example = R"("shaking")", .when_unset = "the wall is at rest", .refers_to = "motions",
     .help = "how the wall moves in the phases that run this motion"},
    {.pattern = "walls.*.open", .kind = choices, .example = R"(["+z"])", .standard = "[]",
     .choices = {"-x", "+x", "-y", "+y", "-z", "+z", "base", "top"}, .only_when = {"shape", {"box", "cylinder"}},
     .help = "sides that are not there: of a box -x to +z, of a cylinder base and top"},
    {.pattern = "walls.*.point", .kind = vector, .dimension = dimension::length, .example = R"(["0 mm", "0 mm", "0 mm"])",
     .presence = required, .only_when = plane, .help = "a point of the plane"},
    {.pattern = "walls.*.normal", .kind = direction, .example = "[0, 0, 1]", .standard = "[0, 0, 1]", .only_when = plane,
     .help = "direction from the plane to the powder"},
  });
  append_shape(keys, "walls.*");

  const Condition sine{"kind", {"sine"}};
  append(keys, {
    {.pattern = "motions", .kind = named_tables, .help = "movements that walls can make"},
    {.pattern = "motions.*.kind", .kind = choice, .example = R"("sine")", .presence = required, .choices = {"sine"},
     .help = "kind of movement"},
    {.pattern = "motions.*.frequency", .kind = quantity, .dimension = dimension::frequency, .example = R"("10 Hz")",
     .presence = required, .range = positive, .only_when = sine, .help = "cycles per second"},
    {.pattern = "motions.*.amplitude", .kind = quantity, .dimension = dimension::length, .example = R"("0.5 mm")",
     .presence = one_of, .range = positive, .partner = "peak_acceleration", .only_when = sine,
     .help = "largest distance from the middle position"},
    {.pattern = "motions.*.peak_acceleration", .kind = quantity, .dimension = dimension::acceleration, .example = R"("15 m/s^2")",
     .presence = one_of, .range = positive, .partner = "amplitude", .only_when = sine,
     .help = "largest acceleration a; the amplitude is a / (2 pi f)^2"},
    {.pattern = "motions.*.direction", .kind = direction, .example = "[0, 0, 1]", .standard = "[0, 0, 1]", .only_when = sine,
     .help = "direction of the movement"},
    {.pattern = "motions.*.phase", .kind = quantity, .dimension = dimension::angle, .example = R"("90 deg")", .standard = R"("0 deg")",
     .only_when = sine, .help = "where in its cycle the movement starts"},
  });
}

void append_sources(Keys& keys) {
  const Condition made{"kind", {"pack", "rain"}}, rain{"kind", {"rain"}};
  append(keys, {
    {.pattern = "sources", .kind = named_tables, .presence = required, .help = "where parcels come from"},
    {.pattern = "sources.*.kind", .kind = choice, .example = R"("rain")", .presence = required, .choices = {"pack", "rain", "file"},
     .help = "a random pack without overlap at once, a rain of given rate, or a bed read from a file"},
    {.pattern = "sources.*.powder", .kind = name, .example = R"("mo")", .when_unset = "the only powder", .refers_to = "powders",
     .help = "which powder"},
    {.pattern = "sources.*.mass_rate", .kind = quantity, .dimension = dimension::mass_rate, .example = R"("2 g/s")",
     .presence = required, .range = positive, .only_when = rain, .help = "mass that falls in per second"},
    {.pattern = "sources.*.count", .kind = integer, .example = "20000", .presence = one_of,
     .range = {Range::End::included, Range::End::included, 1.0, 1e12}, .partner = "mass", .only_when = made, .help = "number of parcels"},
    {.pattern = "sources.*.mass", .kind = quantity, .dimension = dimension::mass, .example = R"("20 mg")",
     .presence = one_of, .range = positive, .partner = "count", .only_when = made, .help = "mass of all parcels together"},
    {.pattern = "sources.*.velocity", .kind = vector, .dimension = dimension::speed, .example = R"(["0 m/s", "0 m/s", "-0.2 m/s"])",
     .standard = R"(["0 m/s", "0 m/s", "0 m/s"])", .only_when = made, .help = "velocity of new parcels"},
    {.pattern = "sources.*.path", .kind = text, .example = R"("bed.dump")", .presence = required, .only_when = {"kind", {"file"}},
     .help = "LIGGGHTS or LAMMPS text dump with id, type, position, velocity and radius; seen from the case file"},
    {.pattern = "sources.*.region", .kind = table, .presence = required, .only_when = made,
     .help = "where parcels appear; they lie inside as a whole"},
    {.pattern = "sources.*.region.shape", .kind = choice, .example = R"("box")", .standard = R"("box")", .choices = {"box", "cylinder"},
     .help = "shape of the region; of a rain, a box"},
  });
  append_shape(keys, "sources.*.region");
}

void append_phases(Keys& keys) {
  const Condition waiting{"until", {"inserted", "mass", "rest"}};
  append(keys, {
    {.pattern = "phases", .kind = listed_tables, .presence = required, .help = "what is done, one after the other"},
    {.pattern = "phases[].name", .kind = text, .example = R"("fill")", .presence = required, .help = "name of the phase, used once"},
    {.pattern = "phases[].sources", .kind = names, .example = R"(["rain"])", .standard = "[]", .refers_to = "sources",
     .help = "sources that are open in this phase"},
    {.pattern = "phases[].motions", .kind = names, .example = R"(["shaking"])", .standard = "[]", .refers_to = "motions",
     .help = "motions that run in this phase, from their start"},
    {.pattern = "phases[].until", .kind = choice, .example = R"("rest")", .presence = required,
     .choices = {"time", "inserted", "mass", "cycles", "rest"},
     .help = "what ends the phase: a duration, all sources having given all, a mass in the die, cycles of its first motion, or rest"},
    {.pattern = "phases[].duration", .kind = quantity, .dimension = dimension::time, .example = R"("0.1 s")", .presence = required,
     .range = positive, .only_when = {"until", {"time"}}, .help = "how long the phase lasts"},
    {.pattern = "phases[].mass", .kind = quantity, .dimension = dimension::mass, .example = R"("10 mg")", .presence = required,
     .range = positive, .only_when = {"until", {"mass"}}, .help = "mass in the measured die or region that ends the phase"},
    {.pattern = "phases[].cycles", .kind = number, .example = "5", .presence = required, .range = positive,
     .only_when = {"until", {"cycles"}}, .help = "cycles of the first motion that end the phase"},
    {.pattern = "phases[].kinetic_energy", .kind = quantity, .dimension = dimension::energy, .example = R"("1e-15 J")",
     .when_unset = "1e-4 of m g d of the median parcel", .range = positive, .only_when = {"until", {"rest"}},
     .help = "mean kinetic energy per parcel below which the powder is at rest"},
    {.pattern = "phases[].at_least", .kind = quantity, .dimension = dimension::time, .example = R"("10 ms")", .standard = R"("0 s")",
     .range = not_negative, .only_when = waiting, .help = "time before which the phase does not end"},
    {.pattern = "phases[].time_limit", .kind = quantity, .dimension = dimension::time, .example = R"("2 s")", .presence = required,
     .range = positive, .only_when = waiting, .help = "time after which the phase ends even so"},
    {.pattern = "phases[].at_limit", .kind = choice, .example = R"("error")", .standard = R"("end")", .choices = {"end", "error"},
     .only_when = waiting, .help = "what happens at the time limit: the next phase, or the run stops (exit 5)"},
  });
}

void append_choices(Keys& keys) {
  append(keys, {
    {.pattern = "time", .kind = table, .help = "the time step"},
    {.pattern = "time.fraction", .kind = number, .example = "0.1", .standard = "0.2", .range = fraction, .partner = "step",
     .help = "time step over the smallest of the Rayleigh, Hertz and cohesive limits"},
    {.pattern = "time.step", .kind = quantity, .dimension = dimension::time, .example = R"("1 us")", .when_unset = "found from the fraction",
     .range = positive, .partner = "fraction", .help = "time step, fixed"},
    {.pattern = "time.characteristic_speed", .kind = quantity, .dimension = dimension::speed, .example = R"("0.5 m/s")",
     .when_unset = "estimated from the case", .range = positive, .help = "speed of the fastest impacts, for the Hertz limit"},

    {.pattern = "measures", .kind = table, .help = "what is measured at the end of each phase"},
    {.pattern = "measures.die", .kind = name, .example = R"("die")", .when_unset = "the only box or cylinder among the walls",
     .refers_to = "walls", .partner = "region", .help = "the wall whose inside is measured, in its own frame"},
    {.pattern = "measures.region", .kind = table, .partner = "die", .help = "a region at rest that is measured instead of a die"},
    {.pattern = "measures.region.shape", .kind = choice, .example = R"("box")", .standard = R"("box")", .choices = {"box", "cylinder"},
     .help = "shape of the region"},
  });
  append_shape(keys, "measures.region");
  append(keys, {
    {.pattern = "measures.cell_diameters", .kind = number, .example = "3", .standard = "3", .range = positive,
     .help = "edge of a cell of the porosity grid in mean parcel diameters"},
    {.pattern = "measures.column_diameters", .kind = number, .example = "2", .standard = "2", .range = positive,
     .help = "edge of a column in which the free surface is found, in mean parcel diameters"},

    {.pattern = "output", .kind = table, .help = "what is written besides the results"},
    {.pattern = "output.interval", .kind = quantity, .dimension = dimension::time, .example = R"("20 ms")", .standard = R"("0 s")",
     .range = not_negative, .help = "time between frames for ParaView; 0 s: only at the end of phases"},
    {.pattern = "output.log_interval", .kind = quantity, .dimension = dimension::time, .example = R"("1 ms")", .standard = R"("0 s")",
     .range = not_negative, .help = "time between lines of log.csv; 0 s: a hundredth of the longest phase"},
    {.pattern = "output.picture", .kind = boolean, .example = "false", .standard = "true", .help = "draw the filled die, cut open"},
  });
}

Keys make_table() {
  Keys keys;
  append_general(keys);
  append_materials(keys);
  append_powders(keys);
  append_contact(keys);
  append_walls(keys);
  append_sources(keys);
  append_phases(keys);
  append_choices(keys);
  return keys;
}

}  // namespace

const std::vector<Key>& all_keys() {
  static const Keys table = make_table();
  return table;
}

}  // namespace pulvis::case_file
