// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "report/compare.hpp"
#include "report/pictures.hpp"

namespace pulvis::report {

void add_compared_figures(Document& document, const std::vector<RunData>& runs,
                          const std::vector<const PhaseData*>& last) {
  Beside all;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (last[k]) all.push_back({runs[k].label, last[k]});
  std::vector<const RunData*> each;
  for (const RunData& run : runs) each.push_back(&run);
  add_figures(document, all, all, each);
}

void add_compared_pictures(HtmlPage& page, const std::vector<RunData>& runs) {
  page.heading("Pictures");
  for (const PictureName& name : last_pictures()) {
    std::vector<PageImage> images;
    for (const RunData& run : runs) images.push_back(picture_of(run, name, run.label));
    page.images(images);
  }
}

}  // namespace pulvis::report
