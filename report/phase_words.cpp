// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "case/units.hpp"
#include "report/case_words.hpp"

namespace pulvis::report {
namespace {

std::string names(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& name : list) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string end_words(const Phase& p) {
  using Until = Phase::Until;
  switch (p.until) {
    case Until::time:
      return "for " + format_quantity(p.duration, dimension::time);
    case Until::inserted:
      return "until the sources have given all";
    case Until::mass:
      return fmt::format("until {} are in the die", format_quantity(p.mass, dimension::mass));
    case Until::cycles:
      return fmt::format("for {:.6g} cycles", p.cycles);
    case Until::motions:
      return "until the motions have come to their end";
    case Until::rest:
      return "until the powder rests";
  }
  return "";
}

}  // namespace

std::string phase_words(const Case& c, const Phase& phase) {
  std::vector<std::string> sources, motions, without;
  for (const std::size_t k : phase.sources) sources.push_back(c.sources[k].name);
  for (const std::size_t k : phase.motions) motions.push_back(c.motions[k].name);
  for (const std::size_t k : phase.without) without.push_back(c.walls[k].name);
  std::string text = end_words(phase);
  if (!sources.empty()) text += "; powder from " + names(sources);
  if (!motions.empty()) text += "; moved by " + names(motions);
  if (!without.empty()) text += "; without the walls " + names(without);
  if (phase.time_limit > 0.0) text += "; at most " + format_quantity(phase.time_limit, dimension::time);
  return text;
}

}  // namespace pulvis::report
