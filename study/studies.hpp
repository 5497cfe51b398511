// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "study/study.hpp"

// Every study: one file each. Named in catalogue.cpp, too.
namespace pulvis::study {

Study box_filling();
Study collision();
Study converge();
Study sheared_box();

}  // namespace pulvis::study
