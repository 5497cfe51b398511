// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"
#include "measures/flow.hpp"

namespace pulvis {

/// What flowed through a surface in this phase and since the last line of measures.csv.
struct FlowRecord {
  measures::FlowMeter::State meter;
  double phase_mass = 0.0, line_mass = 0.0;    ///< kg, net; the meter's when the phase, the line began
  std::int64_t phase_count = 0;                ///< parcels, net; likewise
  double phase_start = 0.0, line_start = 0.0;  ///< s
};

/// The flow through one surface over a time.
struct FlowSince {
  std::string surface;
  double mass = 0.0;       ///< kg, net
  std::int64_t count = 0;  ///< parcels, net
  double rate = 0.0;       ///< kg/s; 0 over no time
};

/// Meters at the surfaces of a case, which look every few steps.
class FlowMeters {
 public:
  FlowMeters(const Case& c, const Simulation& simulation);

  /// Whether the meters look at the end of a step.
  bool look_at(std::uint64_t step) const;
  void after_step(const Simulation& simulation);
  void begin_phase(const Simulation& simulation);
  /// Since the phase began.
  std::vector<FlowSince> in_phase(const Simulation& simulation) const;
  /// Since the last call.
  std::vector<FlowSince> since_last_line(const Simulation& simulation);

  std::vector<FlowRecord> record() const;
  /// Goes on from a record. Throws Failure(bad_input) if it is of other surfaces.
  void go_on_from(std::vector<FlowRecord> record);

 private:
  void look(const Simulation& simulation);

  const Case& case_;
  std::vector<measures::FlowMeter> meters_;
  std::vector<FlowRecord> records_;  ///< without the states of the meters
};

}  // namespace pulvis
