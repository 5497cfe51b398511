// SPDX-License-Identifier: Apache-2.0
#include "output/typeface.hpp"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

// The file of the font that comes nearest to DejaVu Sans; empty if there is none.
std::string font_file() {
  std::unique_ptr<FcConfig, void (*)(FcConfig*)> config(::FcInitLoadConfigAndFonts(), &::FcConfigDestroy);
  std::unique_ptr<FcPattern, void (*)(FcPattern*)> wanted(
      ::FcNameParse(reinterpret_cast<const FcChar8*>("DejaVu Sans:scalable=true")), &::FcPatternDestroy);
  if (!config || !wanted) return {};
  ::FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
  ::FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  std::unique_ptr<FcPattern, void (*)(FcPattern*)> found(::FcFontMatch(config.get(), wanted.get(), &result),
                                                         &::FcPatternDestroy);
  FcChar8* file = nullptr;
  if (!found || ::FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(file);
}

// Code points of UTF-8 text; a broken byte becomes the replacement character.
std::vector<std::uint32_t> code_points(std::string_view text) {
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80         ? 1
                               : lead >> 5 == 0x6  ? 2
                               : lead >> 4 == 0xE  ? 3
                               : lead >> 3 == 0x1E ? 4
                                                   : 0;
    std::uint32_t point = length == 1 ? lead : lead & (0x7Fu >> length);
    bool valid = length > 0 && i + length <= text.size();
    for (std::size_t k = 1; valid && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      valid = (next & 0xC0) == 0x80;
      point = point << 6 | (next & 0x3Fu);
    }
    points.push_back(valid ? point : 0xFFFD);
    i += valid ? length : 1;
  }
  return points;
}

}  // namespace

struct Typeface::Library {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  ~Library() {
    if (face != nullptr) ::FT_Done_Face(face);
    if (library != nullptr) ::FT_Done_FreeType(library);
  }

  // Calls `place(x, slot)` for each letter, x counted from the start of the text; returns the width.
  template <class Place>
  double each_letter(std::string_view text, int size, const Place& place) {
    ::FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
    double x = 0.0;
    for (const std::uint32_t point : code_points(text)) {
      if (::FT_Load_Char(face, point, FT_LOAD_RENDER) != 0) continue;
      place(x, face->glyph);
      x += static_cast<double>(face->glyph->advance.x) / 64.0;  // FreeType counts in 1/64 pixel
    }
    return x;
  }
};

Typeface::Typeface() : library_(std::make_unique<Library>()) {
  const std::string file = font_file();
  if (file.empty() || ::FT_Init_FreeType(&library_->library) != 0 ||
      ::FT_New_Face(library_->library, file.c_str(), 0, &library_->face) != 0)
    throw Failure(Exit::io,
                  "cannot label the picture: no usable font found; install the package fonts-dejavu-core");
}

Typeface::~Typeface() = default;

double Typeface::width(std::string_view text, int size) {
  return library_->each_letter(text, size, [](double, FT_GlyphSlot) {});
}

void Typeface::draw(Image& image, double x, double y, std::string_view text, int size, Colour colour,
                    TextAlign align) {
  const double shift = align == TextAlign::left ? 0.0 : align == TextAlign::centre ? 0.5 : 1.0;
  const double start = shift > 0.0 ? x - shift * width(text, size) : x;
  library_->each_letter(text, size, [&](double offset, FT_GlyphSlot slot) {
    const FT_Bitmap& bitmap = slot->bitmap;
    const int left = static_cast<int>(std::lround(start + offset)) + slot->bitmap_left;
    const int top = static_cast<int>(std::lround(y)) - slot->bitmap_top;
    for (unsigned row = 0; row < bitmap.rows; ++row)
      for (unsigned column = 0; column < bitmap.width; ++column)
        image.blend(left + static_cast<int>(column), top + static_cast<int>(row), colour,
                    static_cast<float>(
                        bitmap.buffer[static_cast<int>(row) * bitmap.pitch + static_cast<int>(column)]) /
                        255.0f);
  });
}

}  // namespace pulvis
