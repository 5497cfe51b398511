// SPDX-License-Identifier: Apache-2.0
#include "yardstick/table.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace pulvis::yardstick {
namespace {

using Json = nlohmann::ordered_json;

double share(const Row& row, Task task) { return 100.0 * row.times[task] / row.times.total(); }

Json json_of(const std::vector<Row>& rows, const Row& row) {
  Json times = Json::object();
  for (std::size_t k = 0; k < task_names.size(); ++k) times[task_names[k]] = row.times.of[k];
  const auto faster = speed_up(rows, row);
  return {{"law", row.law},
          {"parcels", row.parcels},
          {"threads", row.threads},
          {"threads_used", row.threads_used},
          {"steps", row.steps},
          {"seconds", row.seconds},
          {"seconds_per_particle_step", row.per_particle_step()},
          {"particle_steps_per_s", 1.0 / row.per_particle_step()},
          {"contacts_per_parcel", row.per_parcel(static_cast<double>(row.contacts))},
          {"near_pairs_per_parcel", row.per_parcel(static_cast<double>(row.near_pairs))},
          {"rebuilds_per_step", static_cast<double>(row.rebuilds) / row.steps},
          {"bytes_per_parcel", row.per_parcel(static_cast<double>(row.bytes))},
          {"speed_up_over_one_thread", faster ? Json(*faster) : Json(nullptr)},
          {"time_over_smallest_bed", over_smallest(rows, row)},
          {"time_table_s", times}};
}

}  // namespace

std::optional<double> speed_up(const std::vector<Row>& rows, const Row& row) {
  for (const Row& other : rows)
    if (other.law == row.law && other.parcels == row.parcels && other.threads == 1)
      return other.per_particle_step() / row.per_particle_step();
  return {};
}

double over_smallest(const std::vector<Row>& rows, const Row& row) {
  const Row* smallest = &row;
  for (const Row& other : rows)
    if (other.law == row.law && other.threads == row.threads && other.parcels < smallest->parcels)
      smallest = &other;
  return row.per_particle_step() / smallest->per_particle_step();
}

std::string table_head() {
  return fmt::format("{:<6} {:>9} {:>7} {:>8} {:>10} {:>8} {:>6} {:>8} {:>6} {:>7} {:>7} {:>7} {:>8} {:>9}\n",
                     "law", "parcels", "threads", "ns/step", "Mp-steps/s", "contacts", "near", "rebuilds",
                     "bytes", "pairs,%", "walls,%", "lists,%", "speed-up", "/smallest");
}

std::string table_line(const std::vector<Row>& rows, const Row& row) {
  const auto faster = speed_up(rows, row);
  return fmt::format(
      "{:<6} {:>9} {:>7} {:>8.1f} {:>10.2f} {:>8.2f} {:>6.2f} {:>8.4f} {:>6.0f} {:>7.1f} {:>7.1f} {:>7.1f} "
      "{:>8} {:>9.2f}\n",
      row.law, row.parcels,
      row.threads_used == row.threads ? std::to_string(row.threads)
                                      : fmt::format("{}/{}", row.threads_used, row.threads),
      1e9 * row.per_particle_step(), 1e-6 / row.per_particle_step(),
      row.per_parcel(static_cast<double>(row.contacts)), row.per_parcel(static_cast<double>(row.near_pairs)),
      static_cast<double>(row.rebuilds) / row.steps, row.per_parcel(static_cast<double>(row.bytes)),
      share(row, Task::pairs), share(row, Task::walls), share(row, Task::near_lists),
      faster ? fmt::format("{:.2f}", *faster) : "-", over_smallest(rows, row));
}

Json to_json(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) list.push_back(json_of(rows, row));
  return list;
}

}  // namespace pulvis::yardstick
