// SPDX-License-Identifier: Apache-2.0
#include "case/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace pulvis::case_file {

const Entry* Value::find(const std::string& key) const {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

Entry* Value::find(const std::string& key) { return const_cast<Entry*>(std::as_const(*this).find(key)); }

std::string kind_with_article(Value::Kind kind) {
  switch (kind) {
    case Value::Kind::text:
      return "text";
    case Value::Kind::integer:
      return "a whole number";
    case Value::Kind::number:
      return "a number";
    case Value::Kind::boolean:
      return "true or false";
    case Value::Kind::list:
      return "a list";
    case Value::Kind::table:
      return "a table";
    case Value::Kind::date:
      return "a date";
  }
  return "a value";
}

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n')
      result += "\\n";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + '"';
}

// `room` bounds the text and with it the recursion over deep or long values.
void append(const Value& value, std::size_t room, std::string& text) {
  if (text.size() > room) return;
  switch (value.kind) {
    case Value::Kind::text:
      text += quoted(value.text);
      return;
    case Value::Kind::integer:
      text += fmt::format("{}", value.integer);
      return;
    case Value::Kind::number:
      text += fmt::format("{}", value.number);
      return;
    case Value::Kind::boolean:
      text += value.boolean ? "true" : "false";
      return;
    case Value::Kind::date:
      text += value.text;
      return;
    case Value::Kind::list: {
      text += "[";
      for (const Value& item : value.items) {
        if (&item != &value.items.front()) text += ", ";
        append(item, room, text);
      }
      text += "]";
      return;
    }
    case Value::Kind::table: {
      text += "{";
      for (const Entry& entry : value.entries) {
        text += fmt::format("{}{} = ", &entry == &value.entries.front() ? " " : ", ", written_key(entry.key));
        append(entry.value, room, text);
      }
      text += " }";
      return;
    }
  }
}

}  // namespace

std::string written_key(const std::string& key) {
  const auto bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), bare) ? key : quoted(key);
}

std::string written_in_full(const Value& value) {
  std::string text;
  append(value, text.max_size(), text);
  return text;
}

std::string written(const Value& value) {
  constexpr std::size_t room = 4000;  // bytes; a table of some hundred sizes still fits whole
  std::string text;
  append(value, room, text);
  if (text.size() <= room) return text;
  std::size_t end = room;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // whole characters only
  return text.substr(0, end) + " ...";
}

}  // namespace pulvis::case_file
