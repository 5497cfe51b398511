// SPDX-License-Identifier: Apache-2.0
#include "case/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "case/keys.hpp"
#include "case/toml_source.hpp"

namespace pulvis {

std::vector<Override> overrides_from(const std::vector<std::string>& settings) {
  std::vector<Override> list;
  for (const std::string& s : settings) {
    const auto equals = s.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Failure(Exit::usage, fmt::format("--set {}: expected key.path=value", s));
    list.push_back({s.substr(0, equals), s.substr(equals + 1)});
  }
  return list;
}

namespace case_file {
namespace {

// A part of a path: a key, or the index of an element.
struct Step {
  std::string key;
  std::optional<std::size_t> index;
};

constexpr std::size_t longest_path = 256;  // characters; the deepest key has some forty

std::optional<std::vector<Step>> steps_of(const std::string& path) {
  if (path.empty() || path.size() > longest_path) return std::nullopt;
  std::vector<Step> steps;
  std::string_view rest = path;
  while (true) {
    const std::size_t end = std::min(rest.find('.'), rest.size());
    std::string_view part = rest.substr(0, end);
    const std::size_t bracket = std::min(part.find('['), part.size());
    if (bracket == 0) return std::nullopt;
    steps.push_back({std::string(part.substr(0, bracket)), std::nullopt});
    part.remove_prefix(bracket);
    while (!part.empty()) {
      std::size_t index = 0;
      const auto [stop, error] = std::from_chars(part.data() + 1, part.data() + part.size(), index);
      if (part.front() != '[' || error != std::errc{} || stop == part.data() + part.size() || *stop != ']')
        return std::nullopt;
      steps.push_back({"", index});
      part.remove_prefix(static_cast<std::size_t>(stop + 1 - part.data()));
    }
    if (end == rest.size()) return steps;
    rest.remove_prefix(end + 1);
  }
}

void set_places(Value& value, const Place& whole, int shift) {
  const auto moved = [&](Place place) {
    // Only a value on one line keeps its inner places; the line shown is the assignment's.
    if (place.line != 1 || place.column + shift < 1) return whole;
    return Place{whole.source, 1, place.column + shift, place.length};
  };
  value.place = moved(value.place);
  for (Value& item : value.items) set_places(item, whole, shift);
  for (Entry& entry : value.entries) {
    entry.place = moved(entry.place);
    set_places(entry.value, whole, shift);
  }
}

int length_of(std::string_view text) {
  return static_cast<int>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

// TOML if it is that and one value only; else the text as it stands.
Value value_of(const Override& given, const Place& place) {
  static constexpr std::string_view prefix = "value = ";
  auto parsed = parse_toml(std::string(prefix) + given.value);
  Value* root = std::get_if<Value>(&parsed);
  Value value;
  if (root != nullptr && root->entries.size() == 1 && root->entries.front().value.kind != Value::Kind::date) {
    value = std::move(root->entries.front().value);
    set_places(value, place, length_of(given.key) + 1 - static_cast<int>(prefix.size()));
  } else {
    value.kind = Value::Kind::text;
    value.text = given.value;
  }
  value.place = place;
  return value;
}

class Walk {
 public:
  Walk(const Place& place, ProblemList& problems) : place_(place), problems_(problems) {}

  void assign(Value& root, const std::vector<Step>& steps, Value value) {
    Value* at = &root;
    for (const Step& step : steps) {
      const bool last = &step == &steps.back();
      at = step.index                      ? element(*at, *step.index)
           : at->kind == Value::Kind::list ? named_element(*at, step.key)
                                           : member(*at, step.key, last);
      if (at == nullptr) return;
    }
    *at = std::move(value);
  }

 private:
  Value* fail(std::string message, std::string expected = "") {
    problems_.add(place_, std::move(message), std::move(expected));
    return nullptr;
  }

  // Of a table: the value of a key, made if it is not there. A name is not made on the way:
  // "powders.nosuch.keep" is a typing error and no new powder.
  Value* member(Value& table, const std::string& key, bool last) {
    if (table.kind != Value::Kind::table)
      return fail(fmt::format("{} is {}", path_, kind_with_article(table.kind)), "it holds no keys");
    Entry* entry = table.find(key);
    if (entry == nullptr && has_names(path_) && !last) {
      std::vector<std::string> names;
      for (const Entry& other : table.entries) names.push_back(other.key);
      const auto guess = nearest(key, names);
      return fail(fmt::format("there is no \"{}\" in [{}]", key, path_),
                  guess           ? fmt::format("did you mean \"{}\"?", *guess)
                  : names.empty() ? ""
                                  : "expected " + enumerate(names));
    }
    path_ += (path_.empty() ? "" : ".") + key;
    if (entry == nullptr) {
      Value made;
      made.place = place_;
      table.entries.push_back({key, place_, std::move(made)});
      entry = &table.entries.back();
    } else if (last) {
      entry->place = place_;
    }
    return &entry->value;
  }

  // Of listed tables: the one with this name.
  Value* named_element(Value& list, const std::string& name) {
    std::vector<std::string> names;
    for (Value& item : list.items) {
      const Entry* entry = item.find("name");
      if (entry == nullptr || entry->value.kind != Value::Kind::text) continue;
      if (entry->value.text == name) return path_ += "." + name, &item;
      names.push_back(entry->value.text);
    }
    const auto guess = nearest(name, names);
    return fail(fmt::format("there is no \"{}\" in [[{}]]", name, path_),
                guess           ? fmt::format("did you mean \"{}\"?", *guess)
                : names.empty() ? fmt::format("expected an index, e.g. {}[0]", path_)
                                : "expected " + enumerate(names));
  }

  Value* element(Value& list, std::size_t index) {
    if (list.kind != Value::Kind::list)
      return fail(fmt::format("{} is {}", path_, kind_with_article(list.kind)), "it has no elements");
    if (index >= list.items.size())
      return fail(fmt::format("{} has no element {}", path_, index),
                  fmt::format("it has {}, counted from 0", list.items.size()));
    path_ += fmt::format("[{}]", index);
    return &list.items[index];
  }

  static bool has_names(const std::string& path) {
    const auto& keys = keys_in("");
    return std::any_of(keys.begin(), keys.end(), [&](const Key* key) {
      return key->kind == KeyKind::named_tables && key->pattern == path;
    });
  }

  Place place_;
  ProblemList& problems_;
  std::string path_;
};

}  // namespace

void apply_overrides(const std::vector<Override>& overrides, Value& root, ProblemList& problems) {
  for (const Override& given : overrides) {
    const int source = problems.add_override(given.key, given.key + "=" + given.value);
    const int key_length = length_of(given.key);
    const Place key_place{source, 1, 1, std::max(1, key_length)};
    const Place value_place{source, 1, key_length + 2, std::max(1, length_of(given.value))};
    const auto steps = steps_of(given.key);
    if (!steps) {
      problems.add(key_place, "this addresses no key",
                   "expected e.g. powders.mo.coarse_graining or phases[2].cycles");
      continue;
    }
    Walk(key_place, problems).assign(root, *steps, value_of(given, value_place));
  }
}

}  // namespace case_file
}  // namespace pulvis
