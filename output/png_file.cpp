// SPDX-License-Identifier: Apache-2.0
#include "output/png_file.hpp"

#include <fmt/format.h>
#include <png.h>

#include "engine/base/failure.hpp"
#include "output/safe_file.hpp"

namespace pulvis {

void write_png(const std::string& path, const Image& image) {
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.width());
  description.height = static_cast<png_uint_32>(image.height());
  description.format = PNG_FORMAT_RGB;

  // Encoded in memory, so that the one safe way of writing files serves here too.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(description);
  std::string encoded(size, '\0');
  if (!png_image_write_to_memory(&description, encoded.data(), &size, 0, image.rgb().data(), 0, nullptr))
    throw Failure(Exit::unexpected,
                  fmt::format("cannot encode the picture {}: {}", path, description.message));
  encoded.resize(size);
  write_file_safely(path, encoded);
}

}  // namespace pulvis
