// SPDX-License-Identifier: Apache-2.0
#include "run/time_table.hpp"

#include <fmt/format.h>

namespace pulvis {
namespace {

const char* words_of(Task task) {
  switch (task) {
    case Task::preparation:
      return "case, meshes, laws, before the first step";
    case Task::insertion:
      return "parcels from sources";
    case Task::bodies:
      return "moving walls, watching margins";
    case Task::near_lists:
      return "finding and sorting neighbours";
    case Task::walls:
      return "contacts with walls";
    case Task::pairs:
      return "contacts of parcels, sums of forces, motion";
    case Task::leaving:
      return "taking parcels out";
    case Task::energy_ledger:
      return "adding up energies";
    case Task::guards:
      return "looking for what must stop the run";
    case Task::measures:
      return "measures, loads on walls, logs";
    case Task::files:
      return "series for ParaView, tables";
    case Task::pictures:
      return "pictures";
    case Task::checkpoints:
      return "state and outputs brought to the disk";
    case Task::rest:
      break;
  }
  return "phases, progress";
}

}  // namespace

std::string time_table(const TaskSeconds& times) {
  const double total = times.total();
  const auto line = [&](const char* name, double seconds, const char* words) {
    return fmt::format("  {:<14}{:>12.3f} {:>6.1f} %  {}\n", name, seconds,
                       total > 0.0 ? 100.0 * seconds / total : 0.0, words);
  };
  std::string text = fmt::format("  {:<14}{:>12} {:>6}\n", "task", "time, s", "share");
  for (std::size_t k = 0; k < task_names.size(); ++k)
    if (times.of[k] > 0.0) text += line(task_names[k], times.of[k], words_of(static_cast<Task>(k)));
  return text + line("together", total, "");
}

}  // namespace pulvis
