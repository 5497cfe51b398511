// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"
#include "output/picture.hpp"
#include "run/sight.hpp"

namespace pulvis {

/// What a picture shows: the die cut open with parcels coloured by their contacts, speed or diameter, or the
/// whole of it.
enum class View { contacts, speed, size, whole };

/// Takes pictures of one moment.
class Photographer {
 public:
  Photographer(const Case& c, const Simulation& simulation, const std::string& phase);

  /// A PNG seen from obliquely above. Throws Failure(Exit::io) if it cannot be written.
  void write(const std::string& path, View view) const;

 private:
  Sight sight_;
  PictureRequest base_;  ///< without parcels
  std::optional<CutPlane> cut_;
};

}  // namespace pulvis
