// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "engine/base/failure.hpp"
#include "study/study.hpp"

namespace pulvis::study {

struct Request {
  std::string name;  ///< of the study
  Options options;
  std::string out;
  int jobs = 0;       ///< points at once; 0: as many as there are processors
  std::string point;  ///< compute only this point of the study that `out` holds
  int threads = 0;    ///< of each point; 0: one, or more if there are fewer points than processors
};

/// Computes all points of a study, each as a process of this program in OUT/points/NAME, and concludes: figures,
/// study.html, study.json. What is complete in `out` is kept, so that the same request goes on with a study that was
/// stopped. Returns Exit::ok, or Exit::target_missed if a limit is not kept; if points are missing, what
/// sweep::exit_of says of them. Throws Failure(usage) for a study that does not exist and a folder with other things.
Exit conduct(const Request& request);

}  // namespace pulvis::study
