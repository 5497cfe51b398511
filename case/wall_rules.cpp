// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "case/build_walls.hpp"
#include "case/rules.hpp"

namespace pulvis::case_file {
namespace {

std::string length_text(double value) { return format_quantity(value, dimension::length, 6); }

/// A list beside another must be as long; true if it is, or is not there.
bool as_long(const Section& section, const std::string& list, const std::string& other,
             ProblemList& problems) {
  const Setting *one = section.find(list), *two = section.find(other);
  if (one == nullptr || two == nullptr || one->numbers.size() == two->numbers.size()) return true;
  problems.add(one->place,
               fmt::format("{} has {} elements, and {} {}", one->path, one->numbers.size(), other,
                           two->numbers.size()),
               fmt::format("expected one element for each of {}", other) + problems.see(places_of({two})));
  return false;
}

bool ascending(const Section& section, const std::string& list, ProblemList& problems) {
  const Setting* setting = section.find(list);
  if (setting == nullptr) return true;
  for (std::size_t i = 1; i < setting->numbers.size(); ++i) {
    if (setting->numbers[i - 1] < setting->numbers[i]) continue;
    problems.add(setting->item_places[i], setting->path + " is not ascending",
                 "expected each element above the one before");
    return false;
  }
  return true;
}

// What the values of a motion make of it together.
void motion_makes_sense(const Section& motion, ProblemList& problems) {
  bool sound = ascending(motion, "times", problems);
  for (const char* list : {"x", "y", "z"}) sound = as_long(motion, list, "times", problems) && sound;
  for (const char* list : {"frequencies", "phases"})
    sound = as_long(motion, list, "amplitudes", problems) && sound;
  const std::string* kind = motion.optional_text("kind");
  if (!sound || kind == nullptr || !problems.empty()) return;  // a value may be missing
  const bool moves = *kind != "path" || motion.find("x") || motion.find("y") || motion.find("z");
  if (!moves)
    return problems.add(motion.place, motion.path + " is a path without places", "expected x, y or z");
  if (const auto fault = motions::fault(build_motion(motion).motion))
    problems.add(motion.place, fmt::format("{}: {}", motion.path, *fault),
                 "expected a motion that can be made" + problems.see(places_in(motion)));
}

void rectangle_has_right_angles(const Section& wall, ProblemList& problems) {
  if (wall.find("along") == nullptr || wall.find("across") == nullptr) return;
  const Vec3 along = wall.vector("along"), across = wall.vector("across");
  if (norm(along) == 0.0 || norm(across) == 0.0)
    return problems.add(wall.place, wall.path + " has an edge of no length", "expected two edges, e.g. 5 mm");
  if (magnitude(dot(along, across)) > 1e-9 * norm(along) * norm(across))
    problems.add(wall.place_of("across"), wall.path + ": along and across are not at right angles",
                 "expected edges at right angles" + problems.see(places_of({wall.find("along")})));
}

void hole_is_inside(const Section& wall, ProblemList& problems) {
  const Setting *hole = wall.find("hole_radius"), *radius = wall.find("radius");
  if (hole == nullptr || radius == nullptr || hole->numbers[0] < radius->numbers[0]) return;
  problems.add(hole->place,
               fmt::format("{} is not below {}: {}", hole->path, radius->path, length_text(hole->numbers[0])),
               "expected less than " + length_text(radius->numbers[0]) + problems.see(places_of({radius})));
}

/// It stands in the headings of results.
bool is_plain(const std::string& name) {
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

// Walls of one body move as one.
void bodies_move_as_one(const Section& root, ProblemList& problems) {
  std::map<std::string, const Section*> first_of;
  for (const Section& wall : root.group("walls")) {
    const Setting *body = wall.find("body"), *motion = wall.find("motion");
    const std::string& name =
        body != nullptr ? body->texts.front() : wall.name;  // alone, it has its own name
    if (!is_plain(name)) {
      if (body != nullptr)  // of a wall's own name the checker has told
        problems.add(body->place, body->path + " is no name",
                     "expected at most 64 letters a to z, digits, _ or -");
      continue;
    }
    const auto [entry, is_first] = first_of.emplace(name, &wall);
    const Setting* other = entry->second->find("motion");
    const std::vector<std::string> none;
    if (is_first || (motion ? motion->texts : none) == (other ? other->texts : none)) continue;
    problems.add(wall.place_of("motion"),
                 fmt::format("{} and {} are parts of the body \"{}\", and have different motions", wall.path,
                             entry->second->path, entry->first),
                 "expected the same motion for both" + problems.see(places_of({other, motion, body})));
  }
}

void gravity_table_is_complete(const Section& gravity, ProblemList& problems) {
  ascending(gravity, "times", problems);
  if (const Setting* times = gravity.find("times"))
    if (!gravity.find("factors") && !gravity.find("x") && !gravity.find("y") && !gravity.find("z"))
      problems.add(times->place, "gravity.times stands alone", "expected factors, x, y or z beside it");
  for (const char* list : {"factors", "x", "y", "z"}) {
    const Setting* setting = gravity.find(list);
    if (setting == nullptr) continue;
    if (gravity.find("times") == nullptr && !gravity.settings.contains("times"))
      problems.add(setting->place, setting->path + " needs gravity.times",
                   "expected e.g. times = [\"0 s\", \"1 s\"]");
    as_long(gravity, list, "times", problems);
  }
}

}  // namespace

void check_wall_rules(const Section& root, ProblemList& problems) {
  for (const Section& wall : root.group("walls")) {
    rectangle_has_right_angles(wall, problems);
    hole_is_inside(wall, problems);
  }
  for (const Section& motion : root.group("motions")) motion_makes_sense(motion, problems);
  bodies_move_as_one(root, problems);
  gravity_table_is_complete(root.table("gravity"), problems);
}

}  // namespace pulvis::case_file
