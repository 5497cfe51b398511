// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>
#include <variant>

#include "case/toml_guard.hpp"
#include "case/value.hpp"

namespace pulvis::case_file {

/// Parses TOML text into a table whose every key and value knows its place, or says where it is wrong.
/// No input crashes or hangs it; see toml_guard.hpp for what is refused beforehand.
std::variant<Value, SyntaxError> parse_toml(std::string_view text);

}  // namespace pulvis::case_file
