// SPDX-License-Identifier: Apache-2.0
#include "study/run_of_case.hpp"

#include <fmt/format.h>

#include "engine/base/failure.hpp"
#include "run/run_case.hpp"
#include "sweep/run_state.hpp"

namespace pulvis::study {

Json run_of_case(const Work& work, const std::string& case_file, const std::vector<Override>& settings) {
  const std::string folder = work.folder + "/run";
  const sweep::Standing standing = sweep::standing_of(folder);
  if (standing != sweep::Standing::complete) {
    RunRequest request;
    request.case_file = case_file;
    request.overrides = settings;
    request.out = folder;
    request.threads = work.threads;
    request.resume = standing == sweep::Standing::resumable;
    request.force = standing == sweep::Standing::broken_off;
    const Exit exit = run_case(request);
    if (exit == Exit::interrupted || exit == Exit::cancelled) throw Stopped{};
    if (exit != Exit::ok)
      throw Failure(exit, fmt::format("the run of {} failed; {}/result.json says how", case_file, folder));
  }
  return sweep::result_in(folder);
}

}  // namespace pulvis::study
