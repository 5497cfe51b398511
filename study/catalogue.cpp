// SPDX-License-Identifier: Apache-2.0
#include "study/studies.hpp"

namespace pulvis::study {

const std::vector<Study>& studies() {
  static const std::vector<Study> all{box_filling(), collision(), converge(), sheared_box()};
  return all;
}

}  // namespace pulvis::study
