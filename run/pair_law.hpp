// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "case/case.hpp"
#include "engine/laws/catalogue.hpp"

namespace pulvis {

laws::Choices law_choices(const ContactChoice& c);

/// The law as the case names its parts.
laws::Law named_law(const ContactChoice& c);

/// The number that the attraction of the case's law grows with, of one pair: W, k_c, sigma, A_H, k_c/k_1, or W and
/// f_0; 0 if the law knows none. For comparison with 0 only.
double cohesion_strength(const ContactChoice& c, const laws::MaterialPair& pair);

/// The law that a pair really has: the case's, or the same without cohesion where the pair's strength is zero
/// (JKR then is Hertz, which is its limit and cheaper; a dry pair has no bridges, not even viscous ones).
laws::Law pair_law(const ContactChoice& c, const laws::MaterialPair& pair);

}  // namespace pulvis
