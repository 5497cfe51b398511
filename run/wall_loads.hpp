// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"
#include "measures/wall_tiles.hpp"

namespace pulvis {

/// Force and torque on a wall or a body, means over a window.
struct WallLoad {
  Vec3 force;   ///< N
  Vec3 torque;  ///< N m, about the body's reference point
};

/// Force on one tile or triangle, mean over a window; positive presses on it.
struct TileLoad {
  double normal = 0.0;  ///< N
  Vec3 shear;           ///< N, in the frame of the body
};

/// What walls bore over a window of time.
struct WallWindow {
  double start = 0.0, end = 0.0;  ///< s
  std::uint64_t samples = 0;
  std::vector<WallLoad> walls, bodies;
  std::vector<TileLoad> tiles;                ///< as WallLoads::tiling
  std::vector<std::vector<TileLoad>> facets;  ///< per mesh, per triangle
};

/// What has been gathered so far, which a checkpoint holds.
struct WallRecord {
  std::uint64_t steps_per_window = 1, steps_in_window = 0;
  bool cycles = false;       ///< windows are whole cycles
  WallWindow current, last;  ///< sums; means
};

/// Adds up what parcels do to walls, window after window: whole cycles of shaking where a phase shakes, else
/// the length the case states. It looks every few steps, which the mean over a window does not notice.
class WallLoads {
 public:
  /// `default_window`: s, where the case states none. Tiles are at least three mean parcel diameters wide.
  WallLoads(const Case& c, const Simulation& simulation, double default_window);

  /// Begins anew, with the windows of this phase.
  void begin_phase(const Phase& phase, const Simulation& simulation);
  bool samples_after_next_step() const;
  /// After each step. True if a window has just been completed.
  bool after_step(const Simulation& simulation);

  const WallRecord& record() const { return now_; }
  /// Goes on from a record. Throws Failure(bad_input) if it is of other walls.
  void go_on_from(WallRecord record);

  /// The last complete window of this phase; before there is one, what has been gathered so far. Stays until the next step.
  const WallWindow& window() const { return now_.last.samples > 0 ? now_.last : current_mean(); }
  std::string window_text() const;
  const measures::WallTiling& tiling() const { return tiling_; }
  /// Point about which torques are taken, in the frame of the body: the middle of the box around it.
  const Vec3& reference_point(std::size_t body) const { return reference_[body]; }

  /// Pressure of a tile over the window, Pa.
  double pressure(std::size_t tile) const;
  /// Largest mean pressure of a tile, and normal force over area of all tiles that bore any, of one body.
  double largest_pressure(std::uint32_t body) const;
  double mean_pressure(std::uint32_t body) const;

 private:
  void sample(const Simulation& simulation);
  void clear(const Simulation& simulation);
  const WallWindow& current_mean() const;

  const Case& case_;
  const Walls& walls_;
  measures::WallTiling tiling_;
  std::vector<Vec3> reference_;
  double default_window_;
  WallRecord now_;
  mutable std::optional<WallWindow> mean_;  ///< of what has been gathered so far, once asked for
};

}  // namespace pulvis
