// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

// A small run folder made up for tests: the files that a run leaves, with plausible numbers.
namespace pulvis::test {

struct SampleRun {
  int seed = 1;
  double porosity = 0.48;      ///< at the end of the last phase; the first ends looser
  double lower_denser = 0.02;  ///< by how much the lowest slice is denser than the highest
  double surface_energy = 1e-4;
  std::vector<double> die{0.008, 0.006, 0.008};
  int layers_of_powder = 3;  ///< of the three that the die has cells for
  bool ended = true;
  bool measures = true;  ///< with measures/ and measures.csv, which older runs have not
  bool pictures = true;
  int version = 1;  ///< of the measures
};

/// Writes it into a folder, which is made.
void write_sample_run(const std::string& folder, const SampleRun& run = {});

}  // namespace pulvis::test
