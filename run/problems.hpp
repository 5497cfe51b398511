// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "case/reader.hpp"
#include "case/units.hpp"
#include "engine/base/failure.hpp"

namespace pulvis {

/// What does not fit together in a case, collected so that the user sees all of it at once.
class Problems {
 public:
  explicit Problems(const Case& c) : case_(c) {}
  /// `key`: the key or table of the case to point at; `follows_from`: keys and tables whose values make it a problem.
  void add(const std::string& key, const std::string& message, std::vector<std::string> follows_from = {}) {
    const std::string place = place_of(case_, key);
    text_ += fmt::format("{}{}: error: {}", text_.empty() ? "" : "\n", place, message);
    follows_from.push_back(key);
    const std::string all = places_of(case_, follows_from);
    if (!all.empty() && all != place) text_ += "\n  see " + all;
  }
  void throw_if_any() const {
    if (!text_.empty()) throw Failure(Exit::bad_case, text_);
  }

 private:
  const Case& case_;
  std::string text_;
};

/// What `read` gives; if a file cannot be read, the failure says which key of the case names it, and where.
template <class Read>
auto named_by(const Case& c, const std::string& key, Read&& read) {
  try {
    return read();
  } catch (const Failure& failure) {
    throw Failure(failure.code(),
                  fmt::format("{}\n  {} names it: {}", failure.what(), place_of(c, key), key));
  }
}

inline std::string in_mm(double metres) { return format_quantity(metres, dimension::length); }

}  // namespace pulvis
