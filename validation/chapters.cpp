// SPDX-License-Identifier: Apache-2.0
#include "validation/chapters.hpp"

namespace pulvis::validation {

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> all{
      {"jkr", "Adhesion after Johnson, Kendall and Roberts",
       "The force curve at sixteen overlaps against the equations solved with 30 digits; the pull-off force, "
       "the "
       "work of separation and the sticking speed against closed forms.",
       jkr},
      {"restitution", "Restitution asked for and shown",
       "Head-on impacts of like and unlike spheres and at a wall, at 0.01, 0.5 and 5 m/s, touching at eleven "
       "instants of a step; each row has the outcome furthest from what was asked for. Peaks without "
       "damping.",
       restitution},
      {"chung_ooi", "Single impacts after Chung and Ooi",
       "The eight tests of C.-Y. Chung, J. Y. Ooi, Granul. Matter 13 (2011) 643-656: in gross sliding "
       "against closed "
       "forms, in stick and micro-slip against the law integrated apart, and against digitised curves. Each "
       "row has "
       "the outcome furthest from the reference of eleven instants of first touch.",
       chung_ooi},
  };
  return all;
}

}  // namespace pulvis::validation
