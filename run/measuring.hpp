// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"
#include "measures/contact_forces.hpp"
#include "measures/container.hpp"
#include "measures/coordination.hpp"
#include "measures/fill.hpp"
#include "measures/layers.hpp"
#include "measures/porosity_parts.hpp"
#include "measures/segregation.hpp"
#include "run/sight.hpp"

namespace pulvis {

/// A named result. `value` is empty where there is nothing to measure (no parcel in the die).
struct Measure {
  std::string name;
  std::optional<double> value;
  std::string unit;
  std::string window;  ///< what it is taken over: "at the end of the phase"
};

/// The inside of the measured die where it stands now: moved with its wall, or, once that has turned, in the
/// wall's own frame. None if the case measures none.
std::optional<measures::Container> measured_container(const Case& c, const Simulation& simulation);

/// From the frame of `measured_container` to that of the domain.
Rigid placement_of_container(const Case& c, const Simulation& simulation);

/// The powder in the frame of `measured_container`, as things stand now.
struct DieSight {
  measures::Container container;
  Sight sight;
  ForceSight forces;
  std::vector<measures::Particle> particles;  ///< velocities are those against the die
};
/// Support of the kernel that continuum fields are smoothed with, m.
double field_support(const Case& c);

/// None if the case measures no die.
std::optional<DieSight> look_into_die(const Case& c, const Simulation& simulation);

/// The same without forces and particles, which cost more.
std::optional<DieSight> spheres_in_die(const Case& c, const Simulation& simulation);

/// What is in the die: mass and number of the parcels whose centre is inside; none if no die is measured.
std::optional<measures::Fill> fill_of_die(const Case& c, const Simulation& simulation);

/// The porosity of the die alone, for frames.
std::optional<measures::PorosityField> porosity_of_die(const Case& c, const Simulation& simulation);

struct PartSurvey {
  measures::Part part;
  measures::PartPorosity porosity;
  std::optional<double> coordination;
};

/// Everything measured in a die at one moment.
struct DieSurvey {
  measures::Container container;
  measures::FreeSurface surface;
  measures::PorosityField porosity;
  std::array<measures::PorosityProfile, 3> profiles;
  measures::PorosityHistogram histogram;
  std::vector<PartSurvey> parts;  ///< halves, then those of the case
  measures::Fill inside;
  measures::FillState fill;
  measures::Coordination coordination;
  measures::ContactForces forces;
  std::optional<measures::Stress> stress;  ///< none in an empty die
  measures::Layers layers;
  measures::Segregation segregation;
};
DieSurvey survey_die(const Case& c, const Simulation& simulation, const DieSight& sight);
/// The same of a look into the die now; none if the case measures no die.
std::optional<DieSurvey> survey_die(const Case& c, const Simulation& simulation);

/// The measures that are one number, the same ones at any time of a run.
std::vector<Measure> measures_of(const Simulation& simulation, const std::optional<DieSurvey>& die);

}  // namespace pulvis
