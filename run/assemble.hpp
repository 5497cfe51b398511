// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/simulation/model.hpp"
#include "run/species.hpp"
#include "run/time_step.hpp"

namespace pulvis {

/// A case made ready to run: the engine's model and the numbers it was derived from.
struct Assembly {
  std::vector<Species> species;
  std::vector<PairProperties> pairs;
  TimeStep time_step;
  Model model;
  std::vector<std::string> notes;     ///< what was read: a line for each mesh
  std::vector<std::string> warnings;  ///< what is wrong with it, but can be run
};

/// Builds the model of a case. Throws Failure(bad_case) with the place and remedy of everything that does not
/// fit together (a die smaller than three parcels, a region too full or cut by a wall, powders with different
/// coarse graining), Failure(bad_input) for a bed that cannot be read or sits in a wall.
Assembly assemble(const Case& c);

/// Parcels a source will give: its count, or its mass over the mean parcel mass (rounded).
double expected_parcels(const Case& c, const Source& source);

}  // namespace pulvis
