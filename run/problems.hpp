// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>

#include <string>

#include "case/case.hpp"
#include "case/reader.hpp"
#include "case/units.hpp"
#include "engine/base/failure.hpp"

namespace pulvis {

/// What does not fit together in a case, collected so that the user sees all of it at once.
class Problems {
 public:
  explicit Problems(const Case& c) : case_(c) {}
  /// `key`: the key or table of the case to point at.
  void add(const std::string& key, const std::string& message) {
    text_ += fmt::format("{}{}: error: {}", text_.empty() ? "" : "\n", place_of(case_, key), message);
  }
  void throw_if_any() const {
    if (!text_.empty()) throw Failure(Exit::bad_case, text_);
  }

 private:
  const Case& case_;
  std::string text_;
};

inline std::string in_mm(double metres) { return format_quantity(metres, dimension::length); }

}  // namespace pulvis
