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
      {"gas", "Energy of an elastic gas",
       "Frictionless Hertz spheres of several sizes in a periodic box: kinetic energy and elastic energy of "
       "the "
       "contacts, summed from the positions by code of its own, stay what they were.",
       gas},
      {"rolling", "Rolling resistance",
       "The tests of Ai et al. (2011): which rolling friction holds a sphere on a slope, how far a sphere "
       "pushed "
       "without spin goes, and whether a heap comes to rest.",
       rolling},
      {"three_spheres", "Friction at large size ratios",
       "A small sphere on the saddle between two large ones leaves or stays as statics says, up to a size "
       "ratio of 100; "
       "an integration that takes velocity and contact plane half a step apart fails the same test.",
       three_spheres},
  };
  return all;
}

}  // namespace pulvis::validation
