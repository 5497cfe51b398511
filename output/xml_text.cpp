// SPDX-License-Identifier: Apache-2.0
#include "output/xml_text.hpp"

#include <array>
#include <utility>

namespace pulvis {
namespace {

constexpr std::array<std::pair<char, std::string_view>, 4> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}}};

}  // namespace

std::string xml_escape(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    std::string_view entity;
    for (const auto& [plain, name] : entities)
      if (letter == plain) entity = name;
    if (entity.empty()) {
      escaped += letter;
    } else {
      escaped += entity;
    }
  }
  return escaped;
}

}  // namespace pulvis
