// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"
#include "output/progress.hpp"
#include "run/checkpoint.hpp"
#include "run/procedure.hpp"
#include "run/results.hpp"
#include "run/run_summary.hpp"
#include "run/wall_loads.hpp"

namespace pulvis {

/// One run from where it stands to its end: steps, looks, outputs, checkpoints.
class Runner {
 public:
  /// `start`: a checkpoint with all that is known before the first step, or from which to go on. Throws
  /// Failure(bad_input) if its state is not one of this model. `times` began when the process did.
  Runner(const Case& c, Model&& model, Checkpoint start, Results& results, Checkpoints& checkpoints,
         int threads, const TimeSheet& times);

  /// To the end of the last phase, or until a signal asks to stop, or until seconds_now() is past `latest`.
  void run(double latest);

  const Simulation& simulation() const { return simulation_; }
  RunSummary& summary() { return checkpoint_.summary; }

 private:
  /// Steps between looks that are `interval` seconds apart; 0: never.
  std::uint64_t every(double interval) const;
  void begin();
  bool looks_after_next_step() const;
  void step(Simulation::Then then);
  void end_phase(const std::string& ended_by);
  void look(bool phase_ends, const std::string& phase);
  std::vector<Measure> all_measures(const std::optional<DieSurvey>& die) const;
  void log_measures(const std::string& phase, std::vector<Measure> list);
  void close_phase(const std::string& ended_by, bool run_ends);
  bool stops(double latest);
  void save();
  void show_progress();
  void check_escapes() const;
  void warn(const std::string& text);
  TimeSheet& times() { return simulation_.times(); }

  const Case& case_;
  Results& results_;
  Checkpoints& checkpoints_;
  Checkpoint checkpoint_;  ///< what does not change, and the summary; the rest is put in when it is saved
  Simulation simulation_;
  Procedure procedure_;
  Progress progress_;
  WallLoads loads_;
  FlowMeters flows_;
  std::uint64_t frame_every_, log_every_, measure_every_;
  double saved_;  ///< s on the clock: when last saved
};

}  // namespace pulvis
