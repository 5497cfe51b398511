// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/time_sheet.hpp"

namespace pulvis::yardstick {

/// One bed, timed.
struct Row {
  std::string law;
  std::size_t parcels = 0;
  int threads = 1, threads_used = 1;
  int steps = 0;
  double seconds = 0.0;  ///< for all of them
  std::size_t contacts = 0, near_pairs = 0;
  std::uint64_t rebuilds = 0;  ///< in these steps
  std::size_t bytes = 0;       ///< in arrays that grow with the number of parcels
  TaskSeconds times;           ///< of these steps

  double per_parcel(double total) const { return total / static_cast<double>(parcels); }
  double per_particle_step() const { return per_parcel(seconds / steps); }
};

/// Time of the same bed with one thread over that of `row`; nothing if that was not timed.
std::optional<double> speed_up(const std::vector<Row>& rows, const Row& row);
/// Time per particle-step over that of the smallest bed of the same law and threads.
double over_smallest(const std::vector<Row>& rows, const Row& row);

std::string table_head();
std::string table_line(const std::vector<Row>& rows, const Row& row);
nlohmann::ordered_json to_json(const std::vector<Row>& rows);

}  // namespace pulvis::yardstick
