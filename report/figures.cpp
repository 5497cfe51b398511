// SPDX-License-Identifier: Apache-2.0
#include "report/document.hpp"

namespace pulvis::report {

void add_figures(Document& document, const Beside& cut, const Beside& list,
                 const std::vector<const RunData*>& runs) {
  HtmlPage& page = document.page();
  page.heading("Where it is dense and where loose");
  document.show(porosity_cuts(cut), "No map of the porosity was measured.");
  if (list.size() > cut.size()) document.show(porosity_upright_cuts(list), "");
  document.show(porosity_profiles(list), "No profiles of the porosity were measured.");
  document.show(porosity_histogram(list), "No histogram of the porosity was measured.");
  page.heading("The surface of the powder");
  document.show(surface_maps(list), "The surface was not measured.");
  document.show(surface_profiles(list), "There are no profiles of the surface.");
  page.heading("Pressure on the walls");
  document.show(wall_pressure_maps(list), "No wall bore any pressure, or it was not measured.");
  page.heading("Contacts");
  document.show(coordination_histogram(list), "Contacts were not counted.");
  document.show(contact_force_distribution(list), "Contact forces were not measured.");
  page.heading("Layers");
  document.show(layer_profiles(list), "No layers were measured.");
  page.heading("Over time");
  document.show(time_series(runs), "There is no log and no measures over time.");
}

}  // namespace pulvis::report
