// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "engine/simulation/simulation.hpp"
#include "measures/porosity.hpp"
#include "output/run_folder.hpp"
#include "output/vtk_series.hpp"
#include "run/measuring.hpp"
#include "run/wall_loads.hpp"

namespace pulvis {

/// What of the frames is written, to go on from there.
struct WrittenFrames {
  std::vector<VtkSeries::Frame> parcels, walls, porosity, fields;
  std::uint64_t count = 0;
  double last = -1.0;  ///< s
};

/// The series for ParaView: parcels, walls with what they bear, porosity, continuum fields.
class Frames {
 public:
  Frames(const RunFolder& folder, const WrittenFrames& written);

  /// One frame of each series; of the porosity if it is given. None if there is one of this time already.
  void add(const Simulation& simulation, const WallLoads& loads,
           const std::optional<measures::PorosityField>& porosity);
  /// Continuum fields in the cells of a porosity field, at the end of a phase.
  void add_fields(double time, const DieSight& sight, const measures::PorosityField& grid, double support);
  const WrittenFrames& written();

 private:
  const RunFolder& folder_;
  WrittenFrames written_;
  VtkSeries parcels_, walls_, porosity_, fields_;
};

}  // namespace pulvis
