// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "output/html_page.hpp"
#include "report/run_data.hpp"

namespace pulvis::report {

/// A picture that a run leaves: its file and what it shows.
struct PictureName {
  std::string file, words;
};

/// Those at the end of a run: whole die, cut open, by speed, by size.
std::vector<PictureName> last_pictures();
/// Those after each phase before the last.
std::vector<PictureName> phase_pictures(const RunData& run);

/// A picture of a run within the page; one that is missing or damaged has a caption that says so, and no image.
PageImage picture_of(const RunData& run, const PictureName& name, const std::string& prefix = "");

}  // namespace pulvis::report
