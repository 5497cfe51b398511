// SPDX-License-Identifier: Apache-2.0
// Quantities with their units, as they stand in case files.
#include "case/units.hpp"

#include <cmath>

#include "tests/fuzz/scratch.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = pulvis::fuzz::text_of(data, size);
  const pulvis::QuantityReading reading = pulvis::read_quantity(text);
  // Either a finite quantity, or words about what is wrong.
  if (reading.quantity ? !std::isfinite(reading.quantity->value) : reading.message.empty()) std::abort();
  if (reading.quantity) pulvis::format_quantity(reading.quantity->value, reading.quantity->dimension);
  return 0;
}
