// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace pulvis::yardstick {

inline constexpr std::size_t smallest_bed = 1000, largest_bed = 1'000'000'000;  // parcels

struct Request {
  std::vector<std::size_t> sizes{10'000, 100'000};
  std::vector<std::string> laws{"hertz"};
  std::vector<int> threads;  ///< to be given by the caller
  bool energy = false;       ///< with the ledger of energy
  int look_every = 16;       ///< steps between looks at the state, as a run has them
  int steps = 0;             ///< to be timed; 0: enough for 20 million particle-steps, at least 100
  std::string json;          ///< file; empty: none
};

struct KnownLaw {
  const char *name, *title;
};
/// What `laws` may ask for.
std::vector<KnownLaw> known_laws();

/// Seconds of the processor that the calling thread used. Those of the whole program would count threads that spin
/// while they wait for work.
double seconds_of_this_thread();

/// Times settled beds of the yardstick's spheres and prints a table; the JSON is complete after each row. Throws
/// Failure(usage) for a law that does not exist, or a bed too large for the memory that is free, before anything is
/// computed.
void bench(const Request& request);

}  // namespace pulvis::yardstick
