// SPDX-License-Identifier: Apache-2.0
#include "case/toml_source.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <tuple>

namespace pulvis::case_file {
namespace {

Place place_of(const toml::source_region& region) {
  Place place;
  place.line = static_cast<int>(std::max(1u, region.begin.line));
  place.column = static_cast<int>(std::max(1u, region.begin.column));
  // A value over several lines is underlined by its first character only.
  const bool one_line = region.begin.line == region.end.line && region.end.column > region.begin.column;
  place.length = one_line ? static_cast<int>(region.end.column - region.begin.column) : 1;
  return place;
}

Value converted(const toml::node& node);

Value converted_table(const toml::table& table) {
  Value value;
  value.kind = Value::Kind::table;
  for (const auto& [key, node] : table)
    value.entries.push_back({std::string(key.str()), place_of(key.source()), converted(node)});
  // The library orders keys by name; indices in a `Case` follow the file.
  std::stable_sort(value.entries.begin(), value.entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  return value;
}

template <typename Date>
std::string text_of_date(const Date& date) {
  std::ostringstream stream;
  stream << date;
  return stream.str();
}

Value converted(const toml::node& node) {
  Value value;
  if (const toml::table* table = node.as_table()) {
    value = converted_table(*table);
  } else if (const toml::array* array = node.as_array()) {
    value.kind = Value::Kind::list;
    for (const toml::node& item : *array) value.items.push_back(converted(item));
  } else if (const auto* text = node.as_string()) {
    value.kind = Value::Kind::text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = Value::Kind::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(integer->get());
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = Value::Kind::number;
    value.number = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = Value::Kind::boolean;
    value.boolean = boolean->get();
  } else {
    value.kind = Value::Kind::date;
    if (const auto* date = node.as_date()) value.text = text_of_date(date->get());
    if (const auto* time = node.as_time()) value.text = text_of_date(time->get());
    if (const auto* date_time = node.as_date_time()) value.text = text_of_date(date_time->get());
  }
  value.place = place_of(node.source());
  return value;
}

SyntaxError syntax_error(std::string_view text, const toml::parse_error& error) {
  SyntaxError result;
  result.place = place_of(error.source());
  result.message = std::string(error.description());
  if (result.message.starts_with("Error while ")) result.message.replace(0, 5, "syntax error");
  if (result.message.find("expected a comment or whitespace") != std::string::npos)
    result.expected = "text and numbers with a unit stand in quotes";
  if (const auto open = open_bracket_at(text, result.place.line, result.place.column))
    result.expected =
        fmt::format("the bracket opened at line {}, column {} is not closed here", open->line, open->column);
  return result;
}

}  // namespace

std::variant<Value, SyntaxError> parse_toml(std::string_view text) {
  if (auto refused = refuse_text(text)) return *refused;
  try {
    return converted_table(toml::parse(text));
  } catch (const toml::parse_error& error) {
    return syntax_error(text, error);
  }
}

namespace {

bool is_listed_tables(const Value& value) {
  const auto is_table = [](const Value& item) { return item.kind == Value::Kind::table; };
  return value.kind == Value::Kind::list && !value.items.empty() &&
         std::all_of(value.items.begin(), value.items.end(), is_table);
}

// A list that makes a long line gets a line for each item: the guard refuses lines that no person writes.
std::string written_list(const Value& list) {
  std::string text = written_in_full(list);
  constexpr std::size_t readable = 100;
  if (list.kind != Value::Kind::list || text.size() <= readable) return text;
  text = "[\n";
  for (const Value& item : list.items) text += "  " + written_in_full(item) + ",\n";
  return text + "]";
}

// Keys with values before tables, since what follows a header belongs to it.
void append_table(const Value& table, const std::string& path, std::string& text) {
  for (const Entry& entry : table.entries)
    if (entry.value.kind != Value::Kind::table && !is_listed_tables(entry.value))
      text += fmt::format("{} = {}\n", written_key(entry.key), written_list(entry.value));
  for (const Entry& entry : table.entries) {
    const std::string below = path.empty() ? written_key(entry.key) : path + "." + written_key(entry.key);
    if (entry.value.kind == Value::Kind::table) {
      text += fmt::format("\n[{}]\n", below);
      append_table(entry.value, below, text);
    } else if (is_listed_tables(entry.value)) {
      for (const Value& item : entry.value.items) {
        text += fmt::format("\n[[{}]]\n", below);
        append_table(item, below, text);
      }
    }
  }
}

}  // namespace

std::string toml_text(const Value& table) {
  std::string text;
  append_table(table, "", text);
  return text;
}

}  // namespace pulvis::case_file
