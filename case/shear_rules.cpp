// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "case/rules.hpp"

namespace pulvis::case_file {
namespace {

bool is_periodic_all_around(const Section& root) {
  const Setting* periodic = root.table("domain").find("periodic");
  if (periodic == nullptr) return false;
  const auto has = [&](const char* axis) {
    return std::find(periodic->texts.begin(), periodic->texts.end(), axis) != periodic->texts.end();
  };
  return has("x") && has("y") && has("z");
}

void must_be_periodic(const Section& root, const Place& place, const std::string& what,
                      ProblemList& problems) {
  if (is_periodic_all_around(root)) return;
  problems.add(place, what + " needs a domain that is periodic all around",
               R"(expected domain.periodic = ["x", "y", "z"])");
}

void no_walls(const Section& root, const std::string& what, ProblemList& problems) {
  for (const Section& wall : root.group("walls"))
    problems.add(wall.place, fmt::format("{}: there can be no walls beside {}", wall.path, what),
                 "take the wall out");
}

/// Nothing bears weight in it: all would fall for ever.
void no_body_forces(const Section& root, ProblemList& problems) {
  const Section& gravity = root.table("gravity");
  const Setting* pull = gravity.find("acceleration");
  if (gravity.find("times") != nullptr)
    problems.add(gravity.place_of("times"), "gravity.times has no meaning in a sheared domain",
                 "take the table of gravity out");
  else if (pull != nullptr &&
           std::any_of(pull->numbers.begin(), pull->numbers.end(), [](double g) { return g != 0.0; }))
    problems.add(pull->given ? pull->place : root.table("domain").table("shear").place,
                 "nothing bears weight in a sheared domain, but gravity is not 0",
                 R"(expected gravity.acceleration = ["0 m/s^2", "0 m/s^2", "0 m/s^2"])");
  if (root.table("rotating_frame").given)
    problems.add(root.table("rotating_frame").place, "a sheared domain cannot be seen from a rotating frame",
                 "take [rotating_frame] out");
}

/// Parcels are placed while images still lie straight above: in the first step.
void sources_give_at_once(const Section& root, ProblemList& problems) {
  for (const Section& source : root.group("sources"))
    if (const std::string* kind = source.optional_text("kind"); kind != nullptr && *kind == "rain")
      problems.add(source.place_of("kind"), source.path + ": it cannot rain in a sheared domain",
                   R"(expected "dense", "pack" or "file")");
  const auto& phases = root.group("phases");
  for (std::size_t k = 1; k < phases.size(); ++k)
    if (const Setting* sources = phases[k].find("sources"); sources != nullptr && !sources->texts.empty())
      problems.add(sources->place, sources->path + ": a sheared domain is filled in the first phase only",
                   "open all sources there");
}

/// Measures of a die see no images that slide, and have an up.
void measured_as_a_whole(const Section& root, ProblemList& problems) {
  const Section& measures = root.table("measures");
  if (measures.table("region").given)
    problems.add(measures.table("region").place, "a sheared domain is measured as a whole",
                 "take [measures.region] out");
  for (const Section& surface : measures.group("surfaces"))
    problems.add(surface.place, surface.path + ": flow through surfaces is not measured in a sheared domain",
                 "take it out");
}

void sheared(const Section& root, ProblemList& problems) {
  const Section& shear = root.table("domain").table("shear");
  if (!shear.given) return;
  const std::string *flow = shear.optional_text("flow"), *gradient = shear.optional_text("gradient");
  if (flow != nullptr && gradient != nullptr && *flow == *gradient)
    problems.add(shear.place_of("gradient"), "domain.shear has its gradient along the flow",
                 "expected two different directions");
  if (const Setting* rate = shear.find("rate"); rate != nullptr && rate->numbers.front() == 0.0)
    problems.add(rate->place, "domain.shear.rate is 0",
                 "take [domain.shear] out, or give a rate that is not 0");
  must_be_periodic(root, shear.place, "domain.shear", problems);
  no_walls(root, "domain.shear", problems);
  no_body_forces(root, problems);
  sources_give_at_once(root, problems);
  measured_as_a_whole(root, problems);
}

void dense_source_is_alone(const Section& root, ProblemList& problems) {
  for (const Section& source : root.group("sources")) {
    const std::string* kind = source.optional_text("kind");
    if (kind == nullptr || *kind != "dense") continue;
    if (!root.table("domain").table("shear").given) {  // else said already
      must_be_periodic(root, source.place, source.path, problems);
      no_walls(root, source.path, problems);
    }
    if (root.group("sources").size() > 1)
      problems.add(source.place, source.path + " fills the whole domain, but there are other sources",
                   "expected it alone");
  }
}

}  // namespace

void check_shear_rules(const Section& root, ProblemList& problems) {
  sheared(root, problems);
  dense_source_is_alone(root, problems);
}

}  // namespace pulvis::case_file
