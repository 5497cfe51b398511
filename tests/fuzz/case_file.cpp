// SPDX-License-Identifier: Apache-2.0
// Whole case files, as far as a case by itself is checked.
#include "case/reader.hpp"

#include "tests/fuzz/scratch.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = pulvis::fuzz::text_of(data, size);
  // What another file would say is not the question here, and a path could lead anywhere.
  if (text.find("extends") != std::string::npos) return 0;
  pulvis::fuzz::may_refuse([&] { pulvis::read_case_text(text, "case.toml"); });
  return 0;
}
