// SPDX-License-Identifier: Apache-2.0
#include "report/pictures.hpp"

#include <fmt/format.h>

#include "engine/base/failure.hpp"
#include "report/json_entry.hpp"

namespace pulvis::report {

std::vector<PictureName> last_pictures() {
  return {{"pictures/whole.png", "The whole die at the end"},
          {"picture.png", "Cut open at the end, coloured by contacts per parcel"},
          {"pictures/speed.png", "Cut open at the end, coloured by speed"},
          {"pictures/size.png", "Cut open at the end, coloured by size"}};
}

std::vector<PictureName> phase_pictures(const RunData& run) {
  std::vector<PictureName> list;
  for (std::size_t k = 0; k + 1 < run.phases.size(); ++k)
    list.push_back(
        {"pictures/after-" + run.phases[k].name + ".png",
         fmt::format("Cut open after \"{}\", coloured by contacts per parcel", run.phases[k].name)});
  return list;
}

PageImage picture_of(const RunData& run, const PictureName& name, const std::string& prefix) {
  const std::string words = prefix.empty() ? name.words : fmt::format("{}: {}", prefix, name.words);
  std::string fault = "is missing";
  try {
    if (const auto bytes = read_bytes(run.file(name.file))) {
      if (auto image = png_image(*bytes, words, words)) return *image;
      fault = "is not a whole PNG image";
    }
  } catch (const Failure& failure) {
    fault = failure.what();
  }
  PageImage missing;
  missing.caption = fmt::format("{}: {} {}.", words, name.file, fault);
  return missing;
}

}  // namespace pulvis::report
