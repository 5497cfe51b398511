// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"
#include "measures/container.hpp"
#include "measures/porosity.hpp"
#include "run/sight.hpp"

namespace pulvis {

/// A named result. `value` is empty where there is nothing to measure (no parcel in the die).
struct Measure {
  std::string name;
  std::optional<double> value;
  std::string unit;
  std::string window;  ///< what it is taken over: "at the end of the phase"
};

/// Everything measured at one moment.
struct Measurement {
  std::vector<Measure> list;
  std::optional<measures::PorosityField> porosity;  ///< none if no die is measured
};

/// The same in the frame of `measured_container`: that of the die if it has turned.
Sight look_at_die(const Case& c, const Simulation& simulation);

/// The inside of the measured die where it stands now: moved with its wall, or, once that has turned, in the
/// wall's own frame. None if the case measures none.
std::optional<measures::Container> measured_container(const Case& c, const Simulation& simulation);

Measurement measure(const Case& c, const Simulation& simulation);

}  // namespace pulvis
