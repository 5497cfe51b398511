// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/reader.hpp"
#include "engine/base/failure.hpp"
#include "output/csv.hpp"
#include "output/run_folder.hpp"
#include "output/vtk_series.hpp"
#include "run/measuring.hpp"
#include "run/time_step.hpp"
#include "run/wall_results.hpp"

namespace pulvis {

/// How a phase went.
struct PhaseRecord {
  std::string name;
  double start = 0.0, end = 0.0;  ///< s
  std::string ended_by;
  std::vector<Measure> measures;
  std::vector<WallForce> walls;
};

/// How a run went.
struct RunSummary {
  Exit exit = Exit::ok;
  std::string reason;
  double wall_time = 0.0;      ///< s
  double stepping_time = 0.0;  ///< s of it in time steps
  double looking_time = 0.0;   ///< s of it in measures, files and pictures
  std::uint64_t particle_steps = 0;
  std::vector<PhaseRecord> phases;
  std::vector<std::string> warnings;
};

/// Everything a run writes into its folder.
class Results {
 public:
  /// Throws Failure(Exit::usage), besides what RunFolder throws, if the case or a bed lies among the results,
  /// where the copy of the case would take its place or --force remove it.
  Results(const Case& c, const TimeStep& time_step, const std::string& folder, UsedFolder used);

  const RunFolder& folder() const { return folder_; }

  /// case.toml as read, run.json with every key and where its value came from.
  void write_case(const std::vector<Override>& overrides);
  /// A line of log.csv.
  void log(const Simulation& simulation, const std::string& phase);
  /// Parcels, walls with what they bear, and (if given) porosity for ParaView.
  void frame(const Simulation& simulation, const WallLoads& loads,
             const std::optional<measures::PorosityField>& porosity);
  WallResults& walls() { return wall_results_; }
  /// The die cut open, seen from obliquely above: picture.png if it is the `last`, else one in pictures/.
  void picture(const Simulation& simulation, const std::string& phase, bool last);
  /// result.json. `simulation` may be null if the run failed before it began. `ended`: the run is over, now
  /// is the time to use the room kept for this.
  void write_result(const RunSummary& summary, const Simulation* simulation, bool ended = true);

  /// Over the radius, with parcels and walls, of all looks so far.
  double largest_overlap() const { return largest_overlap_; }

 private:
  const Case& case_;
  const TimeStep& time_step_;
  RunFolder folder_;
  WallResults wall_results_{folder_};
  std::unique_ptr<CsvLog> log_;
  VtkSeries parcels_, walls_, porosity_;
  double largest_overlap_ = 0.0;
  double last_frame_ = -1.0;  ///< s
  int frames_ = 0;
};

}  // namespace pulvis
