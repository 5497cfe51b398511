// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/simulation/simulation.hpp"
#include "measures/stress.hpp"

namespace pulvis {

/// A sheared domain as a whole, at one moment.
struct ShearedBox {
  measures::Stress stress;    ///< velocities about the shear flow; pairs across faces with the image's branch
  double shear_stress = 0.0;  ///< Pa; what resists the flow: positive however the domain is sheared
  double solid_fraction = 0.0;
  double coordination = 0.0;  ///< contacts per parcel
  double temperature = 0.0;   ///< m^2/s^2; sum m v'^2/(3 sum m)
};
ShearedBox look_at_sheared_box(const Simulation& simulation);

}  // namespace pulvis
