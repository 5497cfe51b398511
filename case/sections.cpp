// SPDX-License-Identifier: Apache-2.0
#include "case/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pulvis::case_file {

const Setting* Section::find(const std::string& key) const {
  const auto found = settings.find(key);
  if (found != settings.end()) return found->second.valid ? &found->second : nullptr;
  // Asking for what is not declared is a mistake of this program, found by any test that reads a case.
  const std::string declared = pattern.empty() ? key : pattern + "." + key;
  const auto& keys = all_keys();
  if (std::none_of(keys.begin(), keys.end(), [&](const Key& k) { return k.pattern == declared; }))
    throw std::logic_error("the key " + declared + " is not declared");
  return nullptr;
}

Place Section::place_of(const std::string& key) const {
  const auto found = settings.find(key);
  return found != settings.end() && found->second.given ? found->second.place : place;
}

const Setting& Section::setting(const std::string& key) const {
  const Setting* found = find(key);
  if (found == nullptr) throw std::logic_error(fmt::format("{}: the key {} has no value", path, key));
  return *found;
}

double Section::number(const std::string& key) const { return setting(key).numbers.front(); }

std::optional<double> Section::optional_number(const std::string& key) const {
  const Setting* found = find(key);
  return found != nullptr ? std::optional(found->numbers.front()) : std::nullopt;
}

std::int64_t Section::integer(const std::string& key) const { return setting(key).integer; }
bool Section::flag(const std::string& key) const { return setting(key).flag; }
const std::string& Section::text(const std::string& key) const { return setting(key).texts.front(); }
const std::vector<std::string>& Section::texts(const std::string& key) const { return setting(key).texts; }
const std::vector<double>& Section::numbers(const std::string& key) const { return setting(key).numbers; }

Vec3 Section::vector(const std::string& key) const {
  const std::vector<double>& n = setting(key).numbers;
  return {n[0], n[1], n[2]};
}

Vec3 Section::unit_vector(const std::string& key) const {
  // Scaled by its largest part first: the squares of very long or short vectors leave the number range.
  const Vec3 v = vector(key);
  const double largest = std::max({v.x < 0 ? -v.x : v.x, v.y < 0 ? -v.y : v.y, v.z < 0 ? -v.z : v.z});
  const Vec3 scaled = v / largest;
  return scaled / norm(scaled);
}

const std::string* Section::optional_text(const std::string& key) const {
  const Setting* found = find(key);
  return found != nullptr ? &found->texts.front() : nullptr;
}

const Section& Section::table(const std::string& key) const {
  static const Section none;
  const auto found = tables.find(key);
  return found != tables.end() ? found->second : none;
}
const std::vector<Section>& Section::group(const std::string& key) const {
  static const std::vector<Section> none;
  const auto found = groups.find(key);
  return found != groups.end() ? found->second : none;
}

std::vector<Place> places_of(std::initializer_list<const Setting*> settings) {
  std::vector<Place> places;
  for (const Setting* setting : settings)
    if (setting != nullptr && setting->given) places.push_back(setting->place);
  return places;
}

std::vector<Place> places_in(const Section& section) {
  std::vector<const Setting*> settings;
  list_settings(section, settings);
  std::vector<Place> places;
  for (const Setting* setting : settings)
    if (setting->given) places.push_back(setting->place);
  return places;
}

std::optional<std::size_t> index_of(const std::vector<Section>& group, const std::string& name) {
  const auto found =
      std::find_if(group.begin(), group.end(), [&](const Section& s) { return s.name == name; });
  if (found == group.end()) return std::nullopt;
  return static_cast<std::size_t>(found - group.begin());
}

void list_settings(const Section& section, std::vector<const Setting*>& settings) {
  for (const Key* key : keys_in(section.pattern)) {
    const std::string leaf = leaf_of(key->pattern);
    if (const auto found = section.settings.find(leaf); found != section.settings.end())
      settings.push_back(&found->second);
    if (const auto found = section.tables.find(leaf); found != section.tables.end())
      list_settings(found->second, settings);
    if (const auto found = section.groups.find(leaf); found != section.groups.end())
      for (const Section& element : found->second) list_settings(element, settings);
  }
}

}  // namespace pulvis::case_file
