// SPDX-License-Identifier: Apache-2.0
// STL files, text and binary, and the mending of what they hold.
#include "meshes/mending.hpp"
#include "meshes/stl_file.hpp"
#include "tests/fuzz/scratch.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const pulvis::fuzz::Scratch folder;
  const std::string path = folder.write("it.stl", pulvis::fuzz::text_of(data, size));
  pulvis::fuzz::may_refuse([&] { pulvis::mend(pulvis::read_stl(path, 100000), 1e-3); });
  return 0;
}
