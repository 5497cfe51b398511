// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "validation/chapters.hpp"

namespace pulvis::validation {

/// A chapter and what it found.
struct Result {
  const Chapter* chapter = nullptr;
  Findings findings;
  double seconds = 0.0;
};

/// A table for the terminal: all rows of chapters that failed or `complete`, else one line a chapter.
std::string table_text(const std::vector<Result>& results);

/// {"rows": [{"chapter", "name", "source", "reference", "value", "deviation", "limit", "pass"}]}; `limit` is
/// null where a row is only reported. Numbers that JSON does not know fail the row and stand as null.
std::string json_text(const std::vector<Result>& results);

/// The page with every row and figure.
std::string page_text(const std::vector<Result>& results, bool quick);

bool all_passed(const std::vector<Result>& results);

}  // namespace pulvis::validation
