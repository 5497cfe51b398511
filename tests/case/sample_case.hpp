// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "case/reader.hpp"

namespace pulvis::tests {

/// The smallest case that is complete.
inline const char* const minimal_case = R"([domain]
min = ["0 mm", "0 mm", "0 mm"]
max = ["2 mm", "2 mm", "8 mm"]

[materials.molybdenum]
density = "10.2 g/cm^3"
young_modulus = "317 GPa"
poisson_ratio = 0.31
restitution = 0.5
friction = 0.4

[powders.mo]
material = "molybdenum"
size = { kind = "single", diameter = "4.6 um" }

[sources.bed]
kind = "pack"
region = { min = ["0 mm", "0 mm", "0 mm"], max = ["2 mm", "2 mm", "2 mm"] }
count = 100

[[phases]]
name = "settle"
sources = ["bed"]
until = "time"
duration = "0.1 s"
)";

/// A case with about everything in it.
inline const char* const full_case = R"(title = "a die, filled and shaken"  # µm stay µm
seed = 7

[domain]
min = ["-1 mm", "-1 mm", "-1 mm"]
max = ["3 mm", "3 mm", "9 mm"]
periodic = ["x", "y"]
escape = "count"

[gravity]
acceleration = ["0 m/s^2", "1 m/s^2", "-9.81 m/s²"]

[materials.molybdenum]
density = "10.2 g/cm3"
young_modulus = "317 GPa"
poisson_ratio = 0.31
surface_energy = "0.1 mJ/m^2"
restitution = 0.5
friction = "40 %"
rolling_friction = 0.05

[materials.steel]
density = "7.8 g/cm^3"
young_modulus = "210 GPa"
poisson_ratio = 0.3
restitution = 0.6
friction = 0.2

[mixing]
rule = "smaller"

[[pairs]]
materials = ["steel", "molybdenum"]
friction = 0.3
work_of_adhesion = "0.2 mJ/m^2"

[powders.mo]
material = "molybdenum"
coarse_graining = 20
simulated_modulus = "50 MPa"
keep = "sticking_speed"

[powders.mo.size]
kind = "table"
diameters = ["3 um", "5 um", "7 um"]
shares = [1, 3, 1.5]
by = "mass"

[powders.fine]
material = "molybdenum"
coarse_graining = 20.0
size = { kind = "lognormal", diameter = "4 um", geometric_deviation = 1.3, smallest = "2 um", largest = "8 um" }

[contact]
normal = "jkr"
rolling = "elastic_plastic"
friction_limit = "total"

[walls.floor]
shape = "plane"
material = "steel"
point = ["0 mm", "0 mm", "-0.5 mm"]

[walls.die]
shape = "box"
min = ["0 mm", "0 mm", "0 mm"]
max = ["2 mm", "2 mm", "4 mm"]
open = ["+z"]
material = "steel"
motion = "shaking"

[walls.tube]
shape = "cylinder"
base = ["1 mm", "1 mm", "5 mm"]
axis = [0, 0, 2]
radius = "1 mm"
height = "3 mm"
open = ["base", "top"]
material = "steel"

[motions.shaking]
kind = "sine"
frequency = "10 Hz"
peak_acceleration = "15 m/s^2"
direction = [3, 0, 4]
phase = "90 deg"

[sources.rain]
kind = "rain"
powder = "mo"
region = { shape = "box", min = ["0 mm", "0 mm", "6 mm"], max = ["2 mm", "2 mm", "7 mm"] }
mass_rate = "2 g/s"
velocity = ["0 m/s", "0 m/s", "-0.2 m/s"]
mass = "20 mg"

[sources.pack]
kind = "pack"
powder = "fine"
region = { shape = "cylinder", base = ["1 mm", "1 mm", "0 mm"], radius = "0.5 mm", height = "1 mm" }
count = 1e3

[sources.old]
kind = "file"
powder = "mo"
path = "beds/old.dump"

[[phases]]
name = "fill"
sources = ["rain", "pack", "old"]
until = "inserted"
time_limit = "1 min"
at_limit = "error"

[[phases]]
name = "settle"
until = "rest"
kinetic_energy = "1e-15 J"
at_least = "10 ms"
time_limit = "2 s"

[[phases]]
name = "shake"
motions = ["shaking"]
until = "cycles"
cycles = 5

[time]
step = "1 us"
characteristic_speed = "0.5 m/s"

[measures]
die = "die"
cell_diameters = 3.5
column_diameters = 1.5

[output]
interval = "20 ms"
log_interval = "1 ms"
picture = false
)";

/// `text` with one part replaced by another.
inline std::string with(std::string text, const std::string& part, const std::string& replacement) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::logic_error("the sample has no " + part);
  return text.replace(at, part.size(), replacement);
}

/// The problems of a case; none if it is right.
inline std::vector<Problem> problems_of(const std::string& text,
                                        const std::vector<Override>& overrides = {}) {
  try {
    read_case_text(text, "die.toml", overrides);
    return {};
  } catch (const CaseError& error) {
    return error.problems;
  }
}

/// All of it as printed; empty if the case is right.
inline std::string messages_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  std::string all;
  for (const Problem& problem : problems_of(text, overrides)) all += format_problem(problem);
  return all;
}

/// "12:9", the place of a text in a sample.
inline std::string place_in(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::logic_error("the sample has no " + part);
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::size_t start = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return std::to_string(line) + ":" + std::to_string(at - (start == std::string::npos ? 0 : start + 1) + 1);
}

}  // namespace pulvis::tests
