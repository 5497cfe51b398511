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
      {"laws", "Every contact law against its equations",
       "Each part of the catalogue and each law made of them, in 1,000 random states of contact: materials "
       "from "
       "gel to steel, sizes from dust to gravel, every choice that changes a formula. The reference is an "
       "independent evaluation with 113 bits; an error counts relative to the sum of the magnitudes of the "
       "terms. What is compared is the scalar law; that the compiled kernels give its bits with every "
       "instruction set is among the tests.",
       every_law},
      {"capillary", "Capillary bridges",
       "Published values of forces and rupture distances, and the four laws along the gap, between two "
       "spheres "
       "held by the engine.",
       capillary},
      {"symmetry", "What no law may break",
       "Action equals reaction, also in torque; nothing depends on how or where the scene lies; nothing that "
       "is "
       "not a number comes of zeros. Each row is the worst of every law of a list that has each part at "
       "least "
       "once.",
       symmetry},
      {"walls", "Walls of triangles against walls as shapes",
       "The same sphere on the same wall, once as planes and rectangles, once as a mesh of random triangles, "
       "for "
       "every law of the list. Both sides take the same steps, so that whatever differs is the mesh.",
       triangulated_walls},
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
