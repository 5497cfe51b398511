// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <variant>

#include "case/toml_guard.hpp"
#include "case/value.hpp"

namespace pulvis::case_file {

/// Parses TOML text into a table whose every key and value knows its place, or says where it is wrong.
/// No input crashes or hangs it; see toml_guard.hpp for what is refused beforehand.
std::variant<Value, SyntaxError> parse_toml(std::string_view text);

/// A table as the text of a file that `parse_toml` reads as the same table, but for the order of keys beside
/// tables and for comments.
std::string toml_text(const Value& table);

}  // namespace pulvis::case_file
