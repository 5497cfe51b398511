// SPDX-License-Identifier: Apache-2.0
#include "output/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pulvis {
namespace {

// Every 17th of the 256 colours of viridis by Smith, van der Walt and Firing (matplotlib), released under
// CC0; straight lines between them stay within 0.02 of the rest.
constexpr std::array<Colour, 16> control{{{0.267004f, 0.004874f, 0.329415f},
                                          {0.282656f, 0.100196f, 0.422160f},
                                          {0.277134f, 0.185228f, 0.489898f},
                                          {0.253935f, 0.265254f, 0.529983f},
                                          {0.221989f, 0.339161f, 0.548752f},
                                          {0.190631f, 0.407061f, 0.556089f},
                                          {0.163625f, 0.471133f, 0.558148f},
                                          {0.139147f, 0.533812f, 0.555298f},
                                          {0.120565f, 0.596422f, 0.543611f},
                                          {0.134692f, 0.658636f, 0.517649f},
                                          {0.208030f, 0.718701f, 0.472873f},
                                          {0.327796f, 0.773980f, 0.406640f},
                                          {0.477504f, 0.821444f, 0.318195f},
                                          {0.647257f, 0.858400f, 0.209861f},
                                          {0.824940f, 0.884720f, 0.106217f},
                                          {0.993248f, 0.906157f, 0.143936f}}};

constexpr Colour no_value{0.6f, 0.6f, 0.6f};

}  // namespace

Colour viridis(float value) {
  if (std::isnan(value)) return no_value;
  const float place = std::clamp(value, 0.0f, 1.0f) * static_cast<float>(control.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), control.size() - 2);
  const float part = place - static_cast<float>(low);
  const Colour &a = control[low], &b = control[low + 1];
  return {std::lerp(a.red, b.red, part), std::lerp(a.green, b.green, part), std::lerp(a.blue, b.blue, part)};
}

}  // namespace pulvis
