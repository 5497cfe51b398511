// SPDX-License-Identifier: Apache-2.0
#include "case/checker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "case/setting_reader.hpp"
#include "case/toml_source.hpp"

namespace pulvis::case_file {
namespace {

std::string joined(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

// Names stand in paths of --set and in file names, so they keep to plain characters.
bool is_plain_name(const std::string& name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  constexpr std::size_t longest = 64;
  return !name.empty() && name.size() <= longest && std::all_of(name.begin(), name.end(), plain);
}

KnownNames collect_names(const Value& root) {
  KnownNames names;
  for (const Key* key : keys_in("")) {
    if (key->kind != KeyKind::named_tables) continue;
    const Entry* entry = root.find(key->pattern);
    if (entry == nullptr) continue;
    for (const Entry& element : entry->value.entries) names.of_table[key->pattern].insert(element.key);
  }
  return names;
}

class Checker {
 public:
  Checker(const Value& root, ProblemList& problems)
      : names_(collect_names(root)), problems_(problems), reader_(names_, problems) {}

  // `value` is null for a table that is not given: it then gets its defaults.
  Section table(const Value* value, const Place& place, std::string pattern, std::string name,
                std::string path) {
    Section section;
    section.name = std::move(name);
    section.path = std::move(path);
    section.pattern = std::move(pattern);
    section.given = value != nullptr;
    section.place = place;
    if (value != nullptr) unknown_keys(*value, section);
    const std::vector<const Key*> keys = keys_in(section.pattern);
    // Keys that conditions look at come first in the key table where it matters, but not everywhere.
    for (const Key* key : keys)
      if (key->only_when.key.empty()) one_key(*key, value, section);
    for (const Key* key : keys)
      if (!key->only_when.key.empty()) one_key(*key, value, section);
    return section;
  }

 private:
  enum class Holds { yes, no, unknown };

  void unknown_keys(const Value& value, const Section& section) {
    std::vector<std::string> known;
    for (const Key* key : keys_in(section.pattern)) known.push_back(leaf_of(key->pattern));
    for (const Entry& entry : value.entries) {
      if (problems_.full()) return;
      if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
      problems_.add(entry.place, "unknown key " + joined(section.path, shortened(entry.key)),
                    advice(entry.key, known));
    }
  }

  // The nearest key of this table, or the tables where a key of this very name belongs.
  static std::string advice(const std::string& key, const std::vector<std::string>& known) {
    if (const auto guess = nearest(key, known)) return fmt::format("did you mean \"{}\"?", *guess);
    std::vector<std::string> places;
    for (const Key& other : all_keys())
      if (leaf_of(other.pattern) == key && other.pattern != key)
        places.push_back(parent_pattern(other.pattern));
    constexpr std::size_t few = 3;
    if (!places.empty() && places.size() <= few) return "this is a key of " + enumerate(places);
    return "expected " + enumerate(known);
  }

  static std::string shortened(const std::string& key) {
    constexpr std::size_t room = 60;
    Value text;
    text.kind = Value::Kind::text;
    text.text = key.size() <= room ? key : key.substr(0, room);
    return is_plain_name(key) ? key : written(text);
  }

  Holds condition(const Key& key, const Section& section) const {
    if (key.only_when.key.empty()) return Holds::yes;
    const std::string* state = section.optional_text(key.only_when.key);
    if (state == nullptr) return Holds::unknown;  // its absence or error is reported there
    const auto& values = key.only_when.values;
    return std::find(values.begin(), values.end(), *state) != values.end() ? Holds::yes : Holds::no;
  }

  void one_key(const Key& key, const Value* value, Section& section) {
    const std::string leaf = leaf_of(key.pattern);
    const Entry* entry = value != nullptr ? value->find(leaf) : nullptr;
    const Entry* partner = value != nullptr && !key.partner.empty() ? value->find(key.partner) : nullptr;
    const Holds holds = condition(key, section);
    if (entry != nullptr) {
      if (holds == Holds::no) return out_of_place(key, *entry, section);
      if (partner != nullptr) both_given(key, *entry, *partner, section);
      return given(key, *entry, section);
    }
    if (holds == Holds::no || holds == Holds::unknown) return absent_group(key, section);
    const bool missing = key.presence == Presence::required ||
                         (key.presence == Presence::one_of && partner == nullptr && key.partner > leaf);
    // Of two keys that exclude each other, one reports for both.
    if (missing && (value != nullptr || section.path.empty())) return absent(key, section);
    if (is_table(key.kind)) return empty_table(key, section);
    if (!key.standard.empty() && partner == nullptr) standard(key, section);
  }

  void given(const Key& key, const Entry& entry, Section& section) {
    const std::string path = joined(section.path, entry.key);
    if (key.kind == KeyKind::table) {
      if (!is(Value::Kind::table, key, path, entry.value)) return empty_table(key, section);
      // A header or an inline table both point at their key.
      section.tables[entry.key] = table(&entry.value, entry.place, key.pattern, entry.key, path);
    } else if (key.kind == KeyKind::named_tables) {
      named(key, entry, path, section.groups[entry.key]);
    } else if (key.kind == KeyKind::listed_tables) {
      listed(key, entry, path, section.groups[entry.key]);
    } else {
      Setting& setting = section.settings[entry.key];
      setting.key = &key;
      setting.path = path;
      setting.given = true;
      setting.place = entry.value.place;
      setting.key_place = entry.place;
      reader_.read(entry.value, setting);
    }
  }

  void named(const Key& key, const Entry& entry, const std::string& path, std::vector<Section>& group) {
    if (!is(Value::Kind::table, key, path, entry.value)) return;
    if (key.presence == Presence::required && entry.value.entries.empty())
      problems_.add(entry.place, path + " is empty",
                    fmt::format("expected at least one [{}.NAME]", key.pattern));
    for (const Entry& element : entry.value.entries) {
      const std::string element_path = joined(path, shortened(element.key));
      if (!is_plain_name(element.key))
        problems_.add(element.place, fmt::format("{} is no name", element_path),
                      "expected at most 64 letters a to z, digits, _ or -");
      if (!is(Value::Kind::table, key, element_path, element.value)) continue;
      const Place& place = element.place;
      group.push_back(table(&element.value, place, element_pattern(key), element.key, element_path));
    }
  }

  void listed(const Key& key, const Entry& entry, const std::string& path, std::vector<Section>& group) {
    if (!is(Value::Kind::list, key, path, entry.value)) return;
    if (key.presence == Presence::required && entry.value.items.empty())
      problems_.add(entry.place, path + " is empty",
                    fmt::format("expected at least one [[{}]]", key.pattern));
    for (std::size_t i = 0; i < entry.value.items.size(); ++i) {
      const Value& element = entry.value.items[i];
      const std::string element_path = fmt::format("{}[{}]", path, i);
      if (!is(Value::Kind::table, key, element_path, element)) continue;
      group.push_back(table(&element, element.place, element_pattern(key), std::to_string(i), element_path));
    }
  }

  bool is(Value::Kind kind, const Key& key, const std::string& path, const Value& value) {
    if (value.kind == kind) return true;
    problems_.add(value.place, fmt::format("{} is {}", path, kind_with_article(value.kind)),
                  "expected " + describe_kind(key));
    return false;
  }

  void out_of_place(const Key& key, const Entry& entry, Section& section) {
    const std::string* state = section.optional_text(key.only_when.key);
    problems_.add(entry.place,
                  fmt::format("{} has no meaning where {} is \"{}\"", joined(section.path, entry.key),
                              key.only_when.key, state != nullptr ? *state : ""),
                  fmt::format("it counts where {}", describe_condition(key.only_when)) +
                      problems_.see(places_of({section.find(key.only_when.key)})));
    absent_group(key, section);
  }

  void both_given(const Key& key, const Entry& entry, const Entry& partner, const Section& section) {
    // Reported once, at the one that comes later: an override comes after the file.
    const auto position = [](const Place& p) { return std::tuple(p.source, p.line, p.column); };
    if (position(entry.place) < position(partner.place)) return;
    problems_.add(entry.place,
                  fmt::format("{} is given beside {}", joined(section.path, entry.key), key.partner),
                  "only one of them can hold");
  }

  void absent(const Key& key, Section& section) {
    const std::string leaf = leaf_of(key.pattern);
    const std::string path = joined(section.path, leaf);
    if (is_table(key.kind)) {
      const std::string header = key.kind == KeyKind::listed_tables  ? fmt::format("[[{}]]", path)
                                 : key.kind == KeyKind::named_tables ? fmt::format("[{}.NAME]", path)
                                                                     : fmt::format("[{}]", path);
      problems_.add(section.place, path + " is missing", fmt::format("expected {}: {}", header, key.help));
      return empty_table(key, section);
    }
    if (key.presence == Presence::one_of)
      problems_.add(section.place, fmt::format("{} is missing, and so is {}", path, key.partner),
                    "expected exactly one of them");
    else
      problems_.add(section.place, path + " is missing",
                    fmt::format("expected e.g. {} = {}", leaf, key.example));
  }

  // Tables are always there to be asked, even if empty.
  void absent_group(const Key& key, Section& section) {
    if (is_table(key.kind)) empty_table(key, section);
  }

  void empty_table(const Key& key, Section& section) {
    const std::string leaf = leaf_of(key.pattern);
    if (key.kind != KeyKind::table) {
      section.groups[leaf];
      return;
    }
    // Only of a table that may be left out do the defaults hold; one that is missing or that something
    // else excludes stays bare.
    const bool optional =
        key.presence == Presence::optional && key.partner.empty() && key.only_when.key.empty();
    const std::string path = joined(section.path, leaf);
    Section& empty = section.tables[leaf];
    if (optional) empty = table(nullptr, section.place, key.pattern, leaf, path);
    empty.name = leaf, empty.path = path, empty.pattern = key.pattern, empty.place = section.place;
  }

  // The default goes through the same reading as a value of the user.
  void standard(const Key& key, Section& section) {
    const auto parsed = parse_toml("value = " + key.standard);
    if (!std::holds_alternative<Value>(parsed))
      throw std::logic_error("the default of " + key.pattern + " is no TOML");
    const std::string leaf = leaf_of(key.pattern);
    Setting& setting = section.settings[leaf];
    setting.key = &key;
    setting.path = joined(section.path, leaf);
    setting.place = setting.key_place = section.place;
    reader_.read(std::get<Value>(parsed).entries.front().value, setting);
    setting.written = key.standard;
    if (!setting.valid)
      throw std::logic_error("the default of " + key.pattern + " does not fit its declaration");
  }

  KnownNames names_;
  ProblemList& problems_;
  SettingReader reader_;
};

}  // namespace

Section check_keys(const Value& root, ProblemList& problems) {
  return Checker(root, problems).table(&root, Place{0, 1, 1, 1}, "", "", "");
}

}  // namespace pulvis::case_file
