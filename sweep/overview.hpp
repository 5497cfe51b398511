// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "output/progress.hpp"

namespace pulvis::sweep {

/// How many runs stand where.
struct Counts {
  std::size_t complete = 0, running = 0, waiting = 0, failed = 0, stopped = 0;
};

/// "3 of 10 complete, 2 running, 1 failed, about 12 min left".
/// `what` they are called.
std::string overview_text(const Counts& counts, std::optional<double> seconds_left,
                          const std::string& what = "runs");

/// Shows that on a stream: one line redrawn on a terminal that can, else a line where something changes.
class Overview {
 public:
  Overview(std::ostream& stream, ProgressOptions options, std::string what = "runs")
      : stream_(stream), options_(options), what_(std::move(what)) {}
  ~Overview() { end_line(); }
  Overview(const Overview&) = delete;
  Overview& operator=(const Overview&) = delete;

  void update(const Counts& counts, std::optional<double> seconds_left);
  /// A line of its own.
  void message(const std::string& text);

 private:
  void end_line();

  std::ostream& stream_;
  ProgressOptions options_;
  std::string what_;
  std::string shown_, counted_;
  bool line_open_ = false;
};

}  // namespace pulvis::sweep
