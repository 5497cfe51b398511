// SPDX-License-Identifier: Apache-2.0
#include "single_contact/curve.hpp"

namespace pulvis::single_contact {
namespace {

/// From -gap to the largest overlap: each side of first touch has its share of points, which lie closer towards
/// it (as u^3, so that a tail a hundred times as long as the well beside it still shows both).
std::vector<double> overlaps(double gap, double largest, int points, double touch) {
  std::vector<double> places;
  const int outside = gap > 0.0 ? points / 2 : 0, inside = points - outside;
  const auto cube = [](double u) { return u * u * u; };
  for (int k = outside; k > 0; --k)
    places.push_back(-gap * cube(static_cast<double>(k) / outside) * (1.0 - 1e-12));
  for (int k = 0; k < inside; ++k)
    places.push_back(touch + (largest - touch) * cube(static_cast<double>(k) / (inside - 1)));
  return places;
}

}  // namespace

Curve load_unload_curve(const Contact& contact, double largest_overlap, int points) {
  const double touch = 1e-15 * contact.radius();
  Curve curve;
  for (const double x : overlaps(contact.formation_gap(), largest_overlap, points, touch))
    curve.loading.push_back({x, contact.pressing(x)});
  // Back point by point, as a contact goes, with what it remembers from one to the next.
  const std::vector<double> places = overlaps(contact.separation_gap(), largest_overlap, points, touch);
  laws::Past past = contact.pressed_to(largest_overlap);
  for (auto x = places.rbegin(); x != places.rend(); ++x) {
    const laws::Response response = contact.in_motion(*x, 0.0, true, past, 0.0);
    curve.unloading.push_back({*x, push(response)});
    past = response.history;
  }
  return curve;
}

}  // namespace pulvis::single_contact
