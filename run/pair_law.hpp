// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "engine/laws/catalogue.hpp"

namespace pulvis {

laws::Choices law_choices(const ContactChoice& c);

/// How its numbers follow from grains to parcels.
laws::Similarity similarity(const ContactChoice& c);

/// The law as the case names its parts.
laws::Law named_law(const ContactChoice& c);

/// The numbers, by their names in MaterialPair, that the attraction of the case's law grows with; none if it knows no
/// attraction.
std::vector<std::string_view> cohesion_numbers(const ContactChoice& c);

/// The sum of their magnitudes for one pair: for comparison with 0 only.
double cohesion_strength(const ContactChoice& c, const laws::MaterialPair& pair);

/// The law that a pair really has: the case's, or the same without cohesion where the pair's strength is zero
/// (JKR then is Hertz, which is its limit and cheaper; a dry pair has no bridges, not even viscous ones).
laws::Law pair_law(const ContactChoice& c, const laws::MaterialPair& pair);

}  // namespace pulvis
