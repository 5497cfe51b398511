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
  HtmlPage& page = document.page();
  page.heading("Where it is dense and where loose");
  document.show(porosity_cuts(all), "No run has a map of the porosity.");
  document.show(porosity_profiles(all), "No run has profiles of the porosity.");
  document.show(porosity_histogram(all), "No run has a histogram of the porosity.");
  page.heading("The surface of the powder");
  document.show(surface_maps(all), "No run has a map of the surface.");
  document.show(surface_profiles(all), "No run has profiles of the surface.");
  page.heading("Pressure on the walls");
  document.show(wall_pressure_maps(all), "No run has pressures on walls.");
  page.heading("Contacts");
  document.show(coordination_histogram(all), "No run has counts of contacts.");
  document.show(contact_force_distribution(all), "No run has contact forces.");
  page.heading("Layers");
  document.show(layer_profiles(all), "No run has layers.");
  page.heading("Over time");
  std::vector<const RunData*> each;
  for (const RunData& run : runs) each.push_back(&run);
  document.show(time_series(each), "No run has a log or measures over time.");
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
