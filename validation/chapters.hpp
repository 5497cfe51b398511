// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>
#include <vector>

#include "validation/findings.hpp"

namespace pulvis::validation {

/// How much time a chapter may take: together three minutes, or an hour.
enum class Effort { quick, full };

/// Comparisons that belong together. To add one: write its file, declare it below, name it in chapters.cpp.
struct Chapter {
  std::string_view name;   ///< for --only
  std::string_view title;  ///< of its part of the page
  std::string_view text;   ///< what is compared with what, and how
  void (*run)(Findings&, Effort);
};
const std::vector<Chapter>& chapters();

void capillary(Findings&, Effort);
void chung_ooi(Findings&, Effort);
void every_law(Findings&, Effort);
void jkr(Findings&, Effort);
void restitution(Findings&, Effort);
void symmetry(Findings&, Effort);
void triangulated_walls(Findings&, Effort);

}  // namespace pulvis::validation
