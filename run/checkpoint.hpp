// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/state.hpp"
#include "output/run_folder.hpp"
#include "run/case_keys.hpp"
#include "run/flow_meters.hpp"
#include "run/results.hpp"
#include "run/run_summary.hpp"
#include "run/wall_loads.hpp"

namespace pulvis {

/// Everything that a run between two steps is, besides its case: what is needed to go on as if it had never
/// stopped. Its form in a file: docs/checkpoint-format.md.
struct Checkpoint {
  static constexpr std::uint32_t version = 4;  ///< of the form in a file

  std::string program = PULVIS_VERSION;  ///< version of the program that wrote it
  double time_step = 0.0;                ///< s
  std::vector<CaseKey> keys;             ///< of the case
  State state;
  WallRecord loads;
  std::vector<FlowRecord> flows;
  RunSummary summary;  ///< without exit and reason
  TaskSeconds times;   ///< of all processes so far
  WrittenResults results;
};

/// The checkpoints in the folder of a run: checkpoints/checkpoint-N.pulvis, of which the last two are kept.
class Checkpoints {
 public:
  static constexpr const char* files = "checkpoints/checkpoint-*.pulvis";

  explicit Checkpoints(const RunFolder& folder);

  /// Writes the next one and removes all but the last two. Throws Failure(Exit::io) if it cannot be written;
  /// the last two are then still there.
  void write(const Checkpoint& checkpoint);

  bool none() const { return numbers().empty(); }

  /// The newest one that is intact; damaged ones after it are named on stderr, and no longer count: the next
  /// one takes the place of the first of them. Throws Failure(Exit::usage) if there is none at all,
  /// Failure(Exit::bad_input) if all are damaged.
  Checkpoint newest();
  /// Where the newest one is, once it was written or read.
  std::string file() const { return file(last_); }

 private:
  std::string file(std::uint64_t number) const;
  std::vector<std::uint64_t> numbers() const;
  void remove(std::uint64_t number) const;

  const RunFolder& folder_;
  std::uint64_t last_ = 0;  ///< number of the newest intact one; 0: there is none
};

}  // namespace pulvis
