// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "output/csv.hpp"
#include "output/run_folder.hpp"
#include "run/measuring.hpp"
#include "run/wall_loads.hpp"
#include "run/wall_mesh.hpp"

namespace pulvis {

/// Files on what walls bear: wall-forces.csv, a line for each window, and wall-pressure/after-PHASE.csv, a
/// line for each tile.
class WallResults {
 public:
  /// Goes on with wall-forces.csv as it was when it had `length` bytes; 0: a new one, when there is a line.
  WallResults(const RunFolder& folder, const Walls& walls, std::uint64_t length);

  void log(const WallLoads& loads, const Simulation& simulation, const std::string& phase);
  /// Brings wall-forces.csv to the disk; its length in bytes, 0 if there is none yet.
  std::uint64_t sync() { return log_ ? log_->sync() : 0; }
  /// Returns the name of the file in the folder.
  std::string write_pressures(const WallLoads& loads, const Simulation& simulation, const std::string& phase);

 private:
  const RunFolder& folder_;
  std::optional<CsvLog> log_;
};

/// Pressure and shear stress (Pa) of the tile, and normal and shear force (N) of the triangle of the mesh (0 for
/// shapes), for each triangle to look at.
struct WallFields {
  std::vector<double> pressure, shear_stress, normal_force, shear_force;
};
WallFields wall_fields(const WallMesh& mesh, const WallLoads& loads, const Simulation& simulation);

/// `wall_pressure_max` and `wall_pressure_mean` of the measured die's body, else of all bodies together.
std::vector<Measure> wall_measures(const Case& c, const WallLoads& loads, const Simulation& simulation);

/// Mean force and torque on one named wall or body over the window at the end of a phase.
struct WallForce {
  std::string name;
  WallLoad load;
  std::string window;
};
std::vector<WallForce> wall_forces(const WallLoads& loads, const Simulation& simulation);

}  // namespace pulvis
