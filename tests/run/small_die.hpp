// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "tests/run/program.hpp"

namespace pulvis::tests {

/// About 145 cohesive parcels rain into a die, settle, are shaken and measured: the whole road in half a
/// second.
inline const char* const small_die = R"(title = "A small die, filled and shaken"
seed = 3

[domain]
min = ["-1 mm", "-1 mm", "-2 mm"]
max = ["4 mm", "4 mm", "12 mm"]

[materials.glass]
density = "2.5 g/cm^3"
young_modulus = "70 GPa"
poisson_ratio = 0.25
surface_energy = "1e-4 J/m^2"
restitution = 0.4
friction = 0.4
rolling_friction = 0.1

[materials.steel]
density = "7.8 g/cm^3"
young_modulus = "210 GPa"
poisson_ratio = 0.3
surface_energy = "4e-4 J/m^2"
restitution = 0.5
friction = 0.3
rolling_friction = 0.1

[powders.beads]
material = "glass"
size = { kind = "uniform", smallest = "45 um", largest = "55 um" }
coarse_graining = 10
simulated_modulus = "2 MPa"
keep = "pull_off"

[contact]
normal = "jkr"
rolling = "elastic_plastic"

[walls.die]
shape = "box"
min = ["0 mm", "0 mm", "0 mm"]
max = ["3 mm", "3 mm", "4 mm"]
open = ["+z"]
material = "steel"
motion = "shaking"

[motions.shaking]
kind = "sine"
frequency = "100 Hz"
peak_acceleration = "15 m/s^2"
direction = [0, 0, 1]
phase = "-90 deg"

[sources.rain]
kind = "rain"
region = { min = ["0.1 mm", "0.1 mm", "4.2 mm"], max = ["2.9 mm", "2.9 mm", "6 mm"] }
velocity = ["0 m/s", "0 m/s", "-0.2 m/s"]
mass = "24 mg"
mass_rate = "600 mg/s"

[[phases]]
name = "fill"
sources = ["rain"]
until = "inserted"
time_limit = "0.2 s"

[[phases]]
name = "settle"
until = "rest"
at_least = "0.02 s"
time_limit = "0.03 s"

[[phases]]
name = "shake"
motions = ["shaking"]
until = "cycles"
cycles = 2

[[phases]]
name = "measure"
until = "time"
duration = "0.01 s"

[time]
fraction = 1.0

[output]
interval = "0.02 s"
log_interval = "2 ms"
picture = false
report = false
)";

/// The same die, walls and powder without its sources and phases, which the test adds.
inline std::string die_with(const std::string& sources_and_phases) {
  const std::string text = small_die;
  return text.substr(0, text.find("[sources.rain]")) + sources_and_phases + text.substr(text.find("[time]"));
}

/// A few parcels put at once into the middle of the die, with a velocity; one phase of 20 ms.
inline std::string thrown(const std::string& velocity, int count = 5) {
  return die_with(fmt::format(R"([sources.pack]
kind = "pack"
region = {{ min = ["0.5 mm", "0.5 mm", "1 mm"], max = ["2.5 mm", "2.5 mm", "3 mm"] }}
velocity = {}
count = {}

[[phases]]
name = "fly"
sources = ["pack"]
until = "time"
duration = "20 ms"

)",
                              velocity, count));
}

/// `text` with one part replaced by another.
inline std::string with(std::string text, const std::string& part, const std::string& replacement) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::logic_error("the sample has no " + part);
  return text.replace(at, part.size(), replacement);
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A case that was run, with its results.
class RunOfCase {
 public:
  explicit RunOfCase(const std::string& text, std::vector<std::string> options = {"--threads", "1"},
                     const Surroundings& surroundings = {})
      : case_file_(folder_.file("case.toml", text)) {
    std::vector<std::string> arguments{"run", case_file_, "--out", out()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    outcome_ = call(arguments, surroundings);
  }
  int exit() const { return outcome_.exit; }
  const Outcome& outcome() const { return outcome_; }
  const std::string& case_file() const { return case_file_; }
  const TemporaryFolder& folder() const { return folder_; }
  std::string out() const { return folder_ / "out"; }
  std::string out(const std::string& name) const { return out() + "/" + name; }
  Json result() const { return json_of(out("result.json")); }

 private:
  TemporaryFolder folder_;
  std::string case_file_;
  Outcome outcome_;
};

}  // namespace pulvis::tests
