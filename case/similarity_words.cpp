// SPDX-License-Identifier: Apache-2.0
#include "case/similarity_words.hpp"

namespace pulvis {

std::string what_is_kept(const std::string& similarity) {
  if (similarity == "bond")
    return "stresses without cohesion, speeds, overlap over radius and restitution where cohesion is weak, "
           "pull-off force "
           "over weight (Bond number)";
  if (similarity == "none")
    return "what does not depend on a number of the law with a length in its unit: friction, and without "
           "cohesion and "
           "given stiffnesses also stresses, overlap over radius and restitution";
  return "stresses, speeds, overlap over radius, restitution, sticking speed, cohesive strength (pull-off "
         "force over "
         "diameter^2)";
}

std::string what_is_not_kept(const std::string& similarity) {
  const std::string always =
      "numbers of layers and parcels across; walls order layers of parcels, not of grains; inertial stresses "
      "grow with "
      "factor^2";
  if (similarity == "bond") return "cohesive strength and sticking speed, which grow; " + always;
  if (similarity == "none")
    return "cohesive strength, which falls: the powder flows and packs too well; " + always;
  return "pull-off force over weight (Bond number), which falls with 1/factor; " + always;
}

}  // namespace pulvis
