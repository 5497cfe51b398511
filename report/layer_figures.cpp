// SPDX-License-Identifier: Apache-2.0
#include "report/illustration.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

struct Column {
  const char* words;
  const char* unit;
  std::vector<double> Layers::*values;
};

constexpr Column shown[] = {{"density", "kg/m^3", &Layers::density},
                            {"vertical stress", "Pa", &Layers::vertical_stress},
                            {"root mean square speed", "m/s", &Layers::speed}};

}  // namespace

std::optional<Illustration> layer_profiles(const Beside& list) {
  FigureSheet sheet{"layers", "Layers from the floor to the surface", {}, 3, 250, 270, true};
  std::vector<const Layers*> layers;
  double highest = 0.0;
  for (const Labelled& one : list)
    if (one.phase->detail && one.phase->detail->layers) {
      layers.push_back(&*one.phase->detail->layers);
      highest = std::max(highest, largest_of(layers.back()->height));
    }
  const DisplayUnit height = display_unit(highest, "m");
  for (const Column& column : shown) {
    double largest = 0.0;
    for (const Layers* l : layers) largest = std::max(largest, largest_of(l->*column.values));
    const DisplayUnit unit = display_unit(largest, column.unit);
    Figure panel{"", column.words, with_unit(column.words, unit), with_unit("height", height), {}};
    panel.y_range = Range{0.0, 1.02 * highest * height.factor};
    for (const Labelled& one : list) {
      if (!one.phase->detail || !one.phase->detail->layers) continue;
      const Layers& l = *one.phase->detail->layers;
      panel.curves.push_back({one.label, scaled(l.*column.values, unit), scaled(l.height, height)});
    }
    sheet.panels.push_back(std::move(panel));
  }
  return illustrate(
      std::move(sheet),
      "Height upwards. Where walls carry part of the weight, the stress grows less than linearly "
      "with depth.");
}

}  // namespace pulvis::report
