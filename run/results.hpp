// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/reader.hpp"
#include "output/csv.hpp"
#include "output/run_folder.hpp"
#include "run/frames.hpp"
#include "run/measure_results.hpp"
#include "run/run_summary.hpp"
#include "run/time_step.hpp"
#include "run/wall_results.hpp"

namespace pulvis {

/// What of the results is written, to go on from there.
struct WrittenResults {
  std::uint64_t log = 0, wall_log = 0, measures = 0;  ///< bytes of log.csv, wall-forces.csv, measures.csv
  WrittenFrames frames;
  std::vector<std::string> files;  ///< pictures and tables, each written once
  double largest_overlap = 0.0;
};

/// Takes the results folder. Throws Failure(Exit::usage), besides what RunFolder throws, if the case or a bed
/// lies among the results, where the copy of the case would take its place or --force remove it.
RunFolder open_results(const Case& c, const std::string& folder, UsedFolder used);

/// Whether a run that ended well left its results there.
bool is_complete(const RunFolder& folder);

/// Everything a run writes into its folder.
class Results {
 public:
  /// Begins anew, or goes on from what is written: all that was written after it is removed or cut off.
  Results(const Case& c, const TimeStep& time_step, const Walls& walls, const RunFolder& folder,
          const WrittenResults& written = {});

  /// case.toml as read, run.json with every key and where its value came from.
  void write_case();
  /// A line of log.csv.
  void log(const Simulation& simulation, const std::string& phase);
  /// Parcels, walls with what they bear, and (if given) porosity for ParaView.
  void frame(const Simulation& simulation, const WallLoads& loads,
             const std::optional<measures::PorosityField>& porosity) {
    frames_.add(simulation, loads, porosity);
  }
  /// Continuum fields of the die for ParaView.
  void fields(double time, const DieSight& sight, const measures::PorosityField& grid, double support) {
    frames_.add_fields(time, sight, grid, support);
  }
  /// A line of wall-forces.csv.
  void log_walls(const WallLoads& loads, const Simulation& simulation, const std::string& phase) {
    wall_results_.log(loads, simulation, phase);
  }
  /// A line of measures.csv.
  void log_measures(double time, const std::string& phase, const std::vector<Measure>& list) {
    measure_results_.log(time, phase, list);
  }
  /// Everything measured at the end of a phase.
  void write_measures(double time, const std::string& phase, const std::vector<Measure>& list,
                      const std::optional<DieSurvey>& die, const std::vector<FlowSince>& flow) {
    written_.files.push_back(measure_results_.write_phase(time, phase, list, die, flow));
  }
  void write_pressures(const WallLoads& loads, const Simulation& simulation, const std::string& phase) {
    written_.files.push_back(wall_results_.write_pressures(loads, simulation, phase));
  }
  /// The die cut open, seen from obliquely above: picture.png and, in pictures/, further views if it is the
  /// `last`, else one in pictures/.
  void pictures(const Simulation& simulation, const std::string& phase, bool last);
  /// result.json. `simulation` may be null if the run failed before it began. `ended`: the run is over, now
  /// is the time to use the room kept for this.
  void write_result(const RunSummary& summary, const Simulation* simulation, bool ended = true);

  /// All that is written so far, brought to the disk.
  WrittenResults written();

  /// Over the radius, with parcels and walls, of all looks so far.
  double largest_overlap() const { return written_.largest_overlap; }

 private:
  const Case& case_;
  const TimeStep& time_step_;
  const RunFolder& folder_;
  WrittenResults written_;  ///< but for the logs and the series, which know it themselves
  CsvLog log_;
  WallResults wall_results_;
  MeasureResults measure_results_;
  Frames frames_;
};

}  // namespace pulvis
