// SPDX-License-Identifier: Apache-2.0
#include "output/result_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/failure.hpp"
#include "output/safe_file.hpp"

namespace pulvis {
namespace {

using nlohmann::ordered_json;

// The place of the first number that is not finite, like ".measures.porosity.value"; empty if there is none.
std::string place_of_non_finite(const ordered_json& value) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    return fmt::format(" = {}", value.get<double>());
  if (!value.is_structured()) return {};
  std::size_t index = 0;
  for (const auto& entry : value.items()) {
    const auto inner = place_of_non_finite(entry.value());
    if (!inner.empty())
      return value.is_object() ? fmt::format(".{}{}", entry.key(), inner)
                               : fmt::format("[{}]{}", index, inner);
    ++index;
  }
  return {};
}

}  // namespace

void write_json(const std::string& path, const ordered_json& content) {
  const auto place = place_of_non_finite(content);
  if (!place.empty())
    throw Failure(
        Exit::internal_check,
        fmt::format("cannot write {}: {} is not a finite number; the measure behind it has no value, "
                    "please report this with the case file",
                    path, place.front() == '.' ? place.substr(1) : place));
  // Names from a case file may be broken UTF-8; the numbers matter more than those letters.
  write_file_safely(path, content.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace pulvis
