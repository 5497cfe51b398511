// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "case/build_walls.hpp"
#include "case/rules.hpp"

namespace pulvis::case_file {
namespace {

void names_once(const Section& root, ProblemList& problems) {
  std::map<std::string, Place> seen;
  for (const Section& phase : root.group("phases")) {
    const Setting* name = phase.find("name");
    if (name == nullptr) continue;
    const std::string& text = name->texts.front();
    const auto plain = [](unsigned char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
             c == '-';
    };
    // It stands in paths of --set and in the results.
    if (text.empty() || text.size() > 64 || !std::all_of(text.begin(), text.end(), plain))
      problems.add(name->place, name->path + " is no name",
                   "expected at most 64 letters a to z, digits, _ or -");
    const auto [before, is_first] = seen.emplace(text, name->place);
    if (!is_first)
      problems.add(name->place, fmt::format("{}: there is a phase \"{}\" before", name->path, text),
                   "each phase has a name of its own" + problems.see(std::span(&before->second, 1)));
  }
}

// Cycles and ends are asked of motions that have them.
void motions_have_an_end(const Section& phase, const std::string& criterion, const Section& root,
                         ProblemList& problems) {
  const Setting* names = phase.find("motions");
  if (names == nullptr || (criterion != "cycles" && criterion != "motions")) return;
  for (std::size_t i = 0; i < names->texts.size(); ++i) {
    const auto index = index_of(root.group("motions"), names->texts[i]);
    if (!index) continue;
    const Section& motion = root.group("motions")[*index];
    const std::string* kind = motion.optional_text("kind");
    if (kind == nullptr) continue;
    if (!problems.empty()) return;  // a value that is asked for below may be missing
    const motions::Motion made = build_motion(motion).motion;
    const double period = motions::fault(made) ? 0.0 : motions::cycle(made).value_or(0.0);
    const bool repeats = period > 0.0 && std::isfinite(period);
    const bool ends = *kind == "stroke" || *kind == "path" || motion.find("end") != nullptr;
    const auto of_motion_and = [&](const Setting* other) {
      std::vector<Place> places = places_in(motion);
      for (const Place& place : places_of({other})) places.push_back(place);
      return places;
    };
    if (criterion == "cycles" && i == 0 && !repeats)
      problems.add(names->item_places[i],
                   fmt::format("{} waits for cycles, and a {} has none", phase.path, *kind),
                   "expected until = \"time\" or \"motions\", or a motion that repeats" +
                       problems.see(of_motion_and(phase.find("until"))));
    const Setting* cycles = phase.find("cycles");
    if (criterion == "cycles" && i == 0 && repeats && cycles != nullptr &&
        made.end < made.start + cycles->numbers.front() * period * (1.0 - 1e-9))
      problems.add(
          names->item_places[i],
          fmt::format("{} waits for {:g} cycles of \"{}\", which ends before", phase.path,
                      cycles->numbers.front(), names->texts[i]),
          "expected a later end of the motion, or fewer cycles" + problems.see(of_motion_and(cycles)));
    if (criterion == "motions" && !ends)
      problems.add(names->item_places[i],
                   fmt::format("{} waits for the end of its motions, and \"{}\" has none", phase.path,
                               names->texts[i]),
                   "expected an end for this motion, or until = \"time\" or \"cycles\"" +
                       problems.see(of_motion_and(phase.find("until"))));
  }
}

void has_what_it_waits_for(const Section& phase, const Section& root, ProblemList& problems) {
  const Setting* until = phase.find("until");
  if (until == nullptr) return;
  const std::string& criterion = until->texts.front();
  const Setting *sources = phase.find("sources"), *motions = phase.find("motions");
  if (criterion == "inserted" && sources != nullptr && sources->texts.empty())
    problems.add(until->place, phase.path + " waits for its sources and has none",
                 "expected e.g. sources = [\"rain\"]");
  if ((criterion == "cycles" || criterion == "motions") && motions != nullptr && motions->texts.empty())
    problems.add(until->place, fmt::format("{} waits for {} and has no motion", phase.path, criterion),
                 "expected e.g. motions = [\"shaking\"]");
  motions_have_an_end(phase, criterion, root, problems);
  const Section& measures = root.table("measures");
  const bool measured =
      measures.settings.contains("die") || measures.table("region").given || !walls_with_inside(root).empty();
  if (criterion == "mass" && !measured)
    problems.add(until->place, phase.path + " waits for a mass, and nothing says where it is measured",
                 "expected [measures] with die or region");
}

void in_time(const Section& phase, ProblemList& problems) {
  const Setting *at_least = phase.find("at_least"), *limit = phase.find("time_limit");
  if (at_least == nullptr || limit == nullptr || !at_least->given || at_least->numbers[0] < limit->numbers[0])
    return;
  problems.add(at_least->place,
               fmt::format("{} is not below {}: {}", at_least->path, limit->path,
                           format_quantity(at_least->numbers[0], dimension::time)),
               "expected less than " + format_quantity(limit->numbers[0], dimension::time) +
                   problems.see(places_of({limit})));
}

// A source that no phase opens would be left out without a word.
void sources_are_opened(const Section& root, ProblemList& problems) {
  std::set<std::string> opened;
  for (const Section& phase : root.group("phases")) {
    if (phase.settings.contains("sources") && phase.find("sources") == nullptr)
      return;  // wrong; reported there
    if (const Setting* sources = phase.find("sources"))
      opened.insert(sources->texts.begin(), sources->texts.end());
  }
  if (root.group("phases").empty()) return;
  for (const Section& source : root.group("sources"))
    if (!opened.contains(source.name))
      problems.add(source.place, source.path + " is opened by no phase",
                   fmt::format("expected it in the sources of a phase: sources = [\"{}\"]", source.name));
}

// A wall that is to move does so only in phases that run its motion.
void motions_are_used(const Section& root, ProblemList& problems) {
  std::set<std::string> moving;
  for (const Section& wall : root.group("walls")) {
    if (wall.settings.contains("motion") && wall.find("motion") == nullptr) return;  // wrong; reported there
    if (const Setting* motion = wall.find("motion"))
      moving.insert(motion->texts.begin(), motion->texts.end());
  }
  for (const Section& phase : root.group("phases")) {
    const Setting* motions = phase.find("motions");
    if (motions == nullptr) continue;
    for (std::size_t i = 0; i < motions->texts.size(); ++i)
      if (!moving.contains(motions->texts[i]))
        problems.add(motions->item_places[i],
                     fmt::format("{}: no wall has the motion \"{}\"", motions->path, motions->texts[i]),
                     fmt::format("expected motion = \"{}\" in a wall", motions->texts[i]));
  }
}

}  // namespace

void check_phase_rules(const Section& root, ProblemList& problems) {
  names_once(root, problems);
  for (const Section& phase : root.group("phases")) {
    has_what_it_waits_for(phase, root, problems);
    in_time(phase, problems);
  }
  sources_are_opened(root, problems);
  motions_are_used(root, problems);
}

}  // namespace pulvis::case_file
