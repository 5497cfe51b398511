// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "output/image.hpp"

namespace pulvis {

/// The colour of `value` between 0 (dark blue) and 1 (yellow) in viridis, which is perceptually uniform and
/// safe for the colour-blind; values outside are clamped, NaN is grey.
Colour viridis(float value);

}  // namespace pulvis
