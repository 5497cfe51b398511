// SPDX-License-Identifier: Apache-2.0
#include "run/pair_law.hpp"

#include <cmath>

#include "run/species.hpp"

namespace pulvis {
namespace {

laws::LawNames names_of(const ContactChoice& c) {
  return {c.normal, c.damping, c.sliding, c.rolling, c.cohesion, c.twisting};
}

}  // namespace

laws::Choices law_choices(const ContactChoice& c) {
  laws::Choices choices;
  choices.limit_includes_dashpot = c.friction_limit == "total";
  choices.damping_on_jkr_radius = c.damping_radius == "jkr_radius";
  choices.tangential_damping = c.tangential_damping;
  choices.cohesion_limit = c.cohesion_in_limit == "without"   ? laws::CohesionLimit::without
                           : c.cohesion_in_limit == "with"    ? laws::CohesionLimit::with
                           : c.cohesion_in_limit == "shifted" ? laws::CohesionLimit::shifted
                                                              : laws::CohesionLimit::standard;
  choices.bridges_form_on_approach = c.bridges_form == "approach";
  choices.linear_loading = c.loading_exponent == 1.0;
  choices.adhesion_exponent = c.adhesion_exponent;
  return choices;
}

laws::Similarity similarity(const ContactChoice& c) { return laws::similarity_named(c.similarity); }

laws::Law named_law(const ContactChoice& c) { return laws::find_law(names_of(c)); }

std::vector<std::string_view> cohesion_numbers(const ContactChoice& c) {
  if (c.normal == "jkr" || c.cohesion == "dmt") return {"work_of_adhesion"};
  if (c.normal == "edinburgh") return {"work_of_adhesion", "constant_pull"};
  if (c.normal == "luding") return {"adhesion_ratio"};
  if (c.cohesion == "hamaker") return {"hamaker_constant"};
  if (c.cohesion.starts_with("capillary")) return {"surface_tension"};
  if (c.cohesion.starts_with("sjkr")) return {"cohesion_energy_density"};
  return {};
}

double cohesion_strength(const ContactChoice& c, const laws::MaterialPair& pair) {
  double strength = 0.0;
  for (const std::string_view name : cohesion_numbers(c))
    strength += std::abs(name == "work_of_adhesion" ? pair.work_of_adhesion : law_number(pair, name));
  return strength;
}

laws::Law pair_law(const ContactChoice& c, const laws::MaterialPair& pair) {
  laws::LawNames names = names_of(c);
  if (cohesion_strength(c, pair) == 0.0) {
    names.cohesion = "none";
    if (c.normal == "jkr") names.normal = "hertz";
  }
  return laws::find_law(names);
}

}  // namespace pulvis
