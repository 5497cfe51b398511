// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "case/value.hpp"

namespace pulvis::case_file {

/// A syntax error with its place.
struct SyntaxError {
  Place place;
  std::string message;
  std::string expected;
};

/// Looks over a text before the TOML library does, and refuses what that library is known to be slow,
/// wrong or fragile on: size, line length, depth, bytes that are no UTF-8, control characters, letters
/// beyond ASCII outside strings and comments. Also finds strings that are never closed.
std::optional<SyntaxError> refuse_text(std::string_view text);

/// The innermost bracket that is open at a place: a syntax error inside it is often its missing end.
std::optional<Place> open_bracket_at(std::string_view text, int line, int column);

}  // namespace pulvis::case_file
