// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "validation/chapters.hpp"
#include "validation/references/law.hpp"
#include "validation/references/law_list.hpp"
#include "validation/worst.hpp"

namespace pulvis::validation {
namespace {

constexpr const char* equations = "the published equations (docs/laws.md) in 113 bits";
constexpr std::uint64_t states = 1000;

/// What a law gives; the memory is what normal laws and the rescaled spring keep besides springs.
enum Quantity { force, tangential, torque, spring, rolling_spring, memory, quantities };
constexpr std::array<const char*, quantities> quantity_names{
    "force", "tangential force", "torque", "tangential spring", "rolling spring", "memory"};

/// Largest error of each, over the sum of the magnitudes of its terms, and whether there was anything to it.
struct Errors {
  std::array<double, quantities> worst{};
  std::array<bool, quantities> seen{};

  void add(Quantity which, double error, Quad terms) {
    raise(worst[which], relative(error, terms));
    seen[which] |= terms > 0;
  }
  void add(Quantity which, double value, Quad reference, Quad terms) {
    add(which, static_cast<double>(quad_magnitude(value - reference)), terms);
  }
};

void add_errors(Errors& e, const laws::Response& ours, const ReferenceResponse& truth) {
  e.add(force, distance(ours.force, truth.force), truth.force_terms);
  e.add(tangential, distance(ours.tangential, truth.tangential), truth.tangential_terms);
  e.add(torque, distance(ours.roll_torque, truth.roll_torque), truth.torque_terms);
  e.add(spring, distance(ours.history.slide, truth.slide), truth.slide_terms);
  e.add(rolling_spring, distance(ours.history.roll, truth.roll), truth.torque_terms);
  e.add(memory, ours.history.plastic, truth.plastic, truth.plastic_terms);
  e.add(memory, ours.history.adhesion, truth.adhesion, truth.adhesion);
  e.add(memory, ours.history.grip, truth.grip, truth.grip);
}

/// Compares a law in 1,000 random states in which its contact exists, with every choice in turn. States so near a
/// change of branch (1e-9) that rounding decides are passed over; whether a contact exists is compared in all
/// others. `of_force`, if given, gets each error of the force.
void compare_law(const laws::Law& law, Errors& e, std::vector<double>* of_force = nullptr) {
  std::uint64_t compared = 0;
  for (std::uint64_t k = 0; compared < states && k < 10 * states; ++k) {
    const laws::Choices& choices = choices_to_test[k % std::size(choices_to_test)];
    const RandomState s = random_state(law, k);
    const ReferenceResponse truth = reference_response(law, s.touch, s.history, s.material, choices);
    if (truth.on_the_edge) continue;
    const laws::Response ours = law.evaluate(s.touch, s.history, law.mix(s.material, choices));
    if ((ours.touching > 0.5) != truth.touching) raise(e.worst[force], NAN);
    if (!truth.touching) continue;
    add_errors(e, ours, truth);
    if (of_force) of_force->push_back(relative(distance(ours.force, truth.force), truth.force_terms));
    ++compared;
  }
  if (compared < states) raise(e.worst[force], NAN);
}

bool solves_a_root(const laws::Law& law) { return law.normal->name == "jkr"; }

/// A row for each quantity asked for: the worst of these laws. Those in which a root is solved have their own.
void add_rows(Findings& f, const std::string& name, const std::vector<laws::Law>& list,
              const std::vector<Quantity>& asked) {
  for (const bool solved : {false, true}) {
    Errors e;
    std::size_t count = 0;
    for (const laws::Law& law : list)
      if (solves_a_root(law) == solved) compare_law(law, e), ++count;
    if (count == 0) continue;
    const std::string where = solved ? " on jkr" : count > 1 ? fmt::format(", {} laws", count) : "";
    for (const Quantity q : asked)
      if (e.seen[q])
        f.compare(fmt::format("{} of {}{}", quantity_names[q], name, where), equations, 0.0, e.worst[q],
                  Compare::bound, solved ? 1e-10 : 1e-12);
  }
}

/// The normal laws with these other parts.
std::vector<laws::Law> on_each_normal_law(laws::LawNames names) {
  std::vector<laws::Law> list;
  for (const auto& normal : laws::catalogue().normal) {
    names.normal = normal.name;
    list.push_back(laws::find_law(names));
  }
  return list;
}

void normal_laws(Findings& f) {
  for (const auto& normal : laws::catalogue().normal) {
    const std::string name(normal.name);
    add_rows(f, name + " alone", {laws::find_law(name, "none", "none", "none")}, {force, memory});
    add_rows(f, name + " with its dashpot", {laws::find_law(name, "restitution", "none", "none")}, {force});
  }
}

void cohesion(Findings& f) {
  for (const auto& part : laws::catalogue().cohesion)
    if (part.acts)
      add_rows(f, fmt::format("{} on hertz and hooke", part.name),
               {laws::find_law("hertz", "none", "none", "none", part.name),
                laws::find_law("hooke", "none", "none", "none", part.name)},
               {force});
}

void sliding_rolling_and_twisting(Findings& f) {
  for (const auto& part : laws::catalogue().sliding)
    if (part.name != "none")
      add_rows(f, std::string(part.name),
               on_each_normal_law({.damping = "restitution", .sliding = part.name, .rolling = "none"}),
               {tangential, spring, memory});
  for (const auto& part : laws::catalogue().rolling)
    if (part.name != "none")
      add_rows(f, fmt::format("{} rolling", part.name),
               on_each_normal_law({.damping = "restitution", .sliding = "none", .rolling = part.name}),
               {torque, rolling_spring});
  for (const auto& part : laws::catalogue().twisting)
    if (part.acts)
      add_rows(f, fmt::format("{} twisting", part.name),
               on_each_normal_law({.sliding = "none", .rolling = "none", .twisting = part.name}),
               {torque, rolling_spring});
}

void whole_laws(Findings& f) {
  add_rows(f, "all parts together", laws_to_test(),
           {force, tangential, torque, spring, rolling_spring, memory});
}

/// The errors of the force in ascending order, for each normal law.
void figure(Findings& f) {
  Figure figure{"law-errors",
                "Error of the force of each normal law in 1,000 random states",
                "share of the states",
                "error / sum of the terms",
                {}};
  figure.log_y = true;
  for (const laws::Law& law : on_each_normal_law({.damping = "restitution"})) {
    Errors unused;
    Curve curve{std::string(law.normal->name), {}, {}, false};
    compare_law(law, unused, &curve.y);
    std::sort(curve.y.begin(), curve.y.end());
    for (std::size_t k = 0; k < curve.y.size(); ++k) {
      curve.x.push_back((static_cast<double>(k) + 0.5) / static_cast<double>(curve.y.size()));
      curve.y[k] = std::max(curve.y[k], 1e-19);  // none at all would not stand on a logarithmic axis
    }
    figure.curves.push_back(std::move(curve));
  }
  f.figure(std::move(figure));
}

}  // namespace

void every_law(Findings& f, Effort) {
  normal_laws(f);
  cohesion(f);
  sliding_rolling_and_twisting(f);
  whole_laws(f);
  figure(f);
}

}  // namespace pulvis::validation
