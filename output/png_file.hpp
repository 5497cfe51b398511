// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "output/image.hpp"

namespace pulvis {

/// Writes `image` to `path` as a PNG, completely or not at all; Failure(Exit::io) if that fails.
void write_png(const std::string& path, const Image& image);

}  // namespace pulvis
