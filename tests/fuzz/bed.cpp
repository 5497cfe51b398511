// SPDX-License-Identifier: Apache-2.0
// Beds: text dumps of LIGGGHTS and LAMMPS.
#include "run/bed_file.hpp"

#include "tests/fuzz/scratch.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const pulvis::fuzz::Scratch folder;
  const std::string path = folder.write("bed.dump", pulvis::fuzz::text_of(data, size));
  const pulvis::Box domain{{-1, -1, -1}, {1, 1, 1}, {false, true, false}};
  pulvis::fuzz::may_refuse([&] {
    const pulvis::Bed bed = pulvis::read_bed(path, 2500.0, 0, domain);
    if (bed.parcels.size() != bed.ids.size()) std::abort();
  });
  return 0;
}
