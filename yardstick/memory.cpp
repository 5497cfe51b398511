// SPDX-License-Identifier: Apache-2.0
#include "yardstick/memory.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace pulvis::yardstick {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// Of the machine (Linux).
double available() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  double kibibytes = 0.0;
  while (file >> word)
    if (word == "MemAvailable:" && file >> kibibytes) return kibibytes * 1024.0;
  return unknown;
}

/// What a container leaves (control groups, version 2).
double left_to_container() {
  double most = 0.0, used = 0.0;
  std::ifstream limit("/sys/fs/cgroup/memory.max"), now("/sys/fs/cgroup/memory.current");
  return limit >> most && now >> used ? std::max(most - used, 0.0) : unknown;  // "max" is no number
}

}  // namespace

double free_memory() { return std::min(available(), left_to_container()); }

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

}  // namespace pulvis::yardstick
