// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "report/illustration.hpp"

namespace pulvis::report {

std::optional<Illustration> coordination_histogram(const Beside& list) {
  Figure figure{"coordination",
                "How many others a parcel touches",
                "contacts with other parcels",
                "share of parcels",
                {}};
  double highest = 0.0;
  for (const Labelled& one : list) {
    if (!one.phase->detail) continue;
    const std::vector<double>& count = one.phase->detail->coordination;
    const double all = std::accumulate(count.begin(), count.end(), 0.0);
    if (!(all > 0.0)) continue;
    Curve curve{one.label, {}, {}, false, true};
    for (std::size_t k = 0; k < count.size(); ++k) {
      curve.x.push_back(static_cast<double>(k) - 0.5);
      curve.y.push_back(count[k] / all);
    }
    curve.x.push_back(static_cast<double>(count.size()) - 0.5);
    curve.y.push_back(0.0);
    highest = std::max(highest, curve.x.back());
    figure.curves.push_back(std::move(curve));
  }
  figure.x_range = Range{-0.5, highest};
  return illustrate(std::move(figure),
                    "Parcels whose centre is in the die; contacts with walls do not count.");
}

std::optional<Illustration> contact_force_distribution(const Beside& list) {
  Figure figure{"contact-forces",
                "Distribution of the contact forces",
                "normal force over its mean",
                "density",
                {},
                false,
                true};
  for (const Labelled& one : list) {
    if (!one.phase->detail || !one.phase->detail->forces) continue;
    const Histogram& h = *one.phase->detail->forces;
    Curve curve{one.label, {}, {}};
    // The last bin holds all that is larger too, which would stand there as a peak.
    for (std::size_t k = 0; k + 1 < h.heights.size(); ++k) {
      curve.x.push_back(0.5 * (h.edges[k] + h.edges[k + 1]));
      curve.y.push_back(h.heights[k]);
    }
    figure.curves.push_back(std::move(curve));
  }
  return illustrate(
      std::move(figure),
      "A straight line at the right means that strong contacts become rarer exponentially; a long tail "
      "that few contacts carry much. The few above six times the mean are not drawn.");
}

}  // namespace pulvis::report
