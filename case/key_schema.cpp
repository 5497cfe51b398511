// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "case/keys.hpp"
#include "case/reader.hpp"
#include "case/toml_source.hpp"

namespace pulvis {
namespace {

using namespace case_file;
using Json = nlohmann::ordered_json;

Json as_json(const Value& value) {
  switch (value.kind) {
    case Value::Kind::integer:
      return value.integer;
    case Value::Kind::number:
      return value.number;
    case Value::Kind::boolean:
      return value.boolean;
    case Value::Kind::list: {
      Json list = Json::array();
      for (const Value& item : value.items) list.push_back(as_json(item));
      return list;
    }
    default:
      return value.text;
  }
}

Json as_json(const std::string& toml) {
  const auto parsed = parse_toml("value = " + toml);
  if (!std::holds_alternative<Value>(parsed)) throw std::logic_error("the default " + toml + " is no TOML");
  return as_json(std::get<Value>(parsed).entries.front().value);
}

// A schema sees no dimensions: a quantity is text that starts with a number and ends with a unit.
Json quantity_schema() {
  return {{"type", "string"}, {"pattern", "^\\s*[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?\\s*\\S"}};
}

Json number_schema(const Key& key, const char* type) {
  Json schema{{"type", type}};
  const Range& range = key.range;
  if (range.low_end == Range::End::included) schema["minimum"] = range.low;
  if (range.low_end == Range::End::excluded) schema["exclusiveMinimum"] = range.low;
  if (range.high_end == Range::End::included) schema["maximum"] = range.high;
  if (range.high_end == Range::End::excluded) schema["exclusiveMaximum"] = range.high;
  return schema;
}

Json list_of(Json items, std::size_t length) {
  Json schema{{"type", "array"}, {"items", std::move(items)}};
  if (length > 0) schema["minItems"] = schema["maxItems"] = length;
  return schema;
}

Json table_schema(const std::string& pattern);

// Without its description and default.
Json value_schema(const Key& key) {
  constexpr std::size_t axes = 3;
  switch (key.kind) {
    case KeyKind::table:
      return table_schema(key.pattern);
    case KeyKind::named_tables:
      return {{"type", "object"},
              {"patternProperties", {{"^[A-Za-z0-9_-]{1,64}$", table_schema(element_pattern(key))}}},
              {"additionalProperties", false}};
    case KeyKind::listed_tables:
      return list_of(table_schema(element_pattern(key)), 0);
    case KeyKind::quantity:
      return quantity_schema();
    case KeyKind::number:
      return {{"anyOf", {number_schema(key, "number"), {{"type", "string"}, {"pattern", "%\\s*$"}}}}};
    case KeyKind::integer:
      return number_schema(key, "integer");
    case KeyKind::boolean:
      return {{"type", "boolean"}};
    case KeyKind::choice:
      return {{"enum", key.choices}};
    case KeyKind::choices:
      return list_of({{"enum", key.choices}}, key.length);
    case KeyKind::text:
    case KeyKind::name:
      return {{"type", "string"}};
    case KeyKind::names:
      if (key.length != 0) return list_of({{"type", "string"}}, key.length);
      return {{"anyOf", {{{"type", "string"}}, list_of({{"type", "string"}}, 0)}}};
    case KeyKind::quantities:
      return list_of(quantity_schema(), key.length);
    case KeyKind::numbers:
      return list_of(number_schema(key, "number"), key.length);
    case KeyKind::vector:
      return list_of(quantity_schema(), axes);
    case KeyKind::direction:
      return list_of({{"type", "number"}}, axes);
  }
  return {};
}

Json key_schema(const Key& key) {
  Json schema{{"description", key.help}};
  schema.update(value_schema(key));
  if (!key.standard.empty()) schema["default"] = as_json(key.standard);
  if (!key.example.empty()) schema["examples"] = Json::array({as_json(key.example)});
  return schema;
}

// What one condition asks for beyond the keys that are always required.
Json required_where(const Condition& condition, const std::vector<const Key*>& keys) {
  Json then = Json::object();
  for (const Key* key : keys) {
    const std::string leaf = leaf_of(key->pattern);
    if (key->presence == Presence::required) then["required"].push_back(leaf);
    if (key->presence == Presence::one_of && leaf < key->partner)
      then["oneOf"] = Json::array({{{"required", {leaf}}}, {{"required", {key->partner}}}});
  }
  return {{"if",
           {{"properties", {{condition.key, {{"enum", condition.values}}}}}, {"required", {condition.key}}}},
          {"then", then}};
}

// What may stand in a table.
Json table_schema(const std::string& pattern) {
  Json schema{{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
  for (const Key* key : keys_in(pattern)) {
    const std::string leaf = leaf_of(key->pattern);
    schema["properties"][leaf] = key_schema(*key);
    if (key->presence == Presence::optional && !key->partner.empty() && leaf < key->partner)
      schema["not"] = {{"required", {leaf, key->partner}}};
  }
  return schema;
}

Json complete_table(const std::string& pattern);

Json complete_value(const Key& key) {
  Json below = complete_table(element_pattern(key));
  if (below.empty() || key.kind == KeyKind::table) return below;
  return {{key.kind == KeyKind::named_tables ? "additionalProperties" : "items", std::move(below)}};
}

// What must stand in it, and in those below it; empty if nothing must.
Json complete_table(const std::string& pattern) {
  Json schema = Json::object();
  std::map<std::pair<std::string, std::vector<std::string>>, std::vector<const Key*>> conditional;
  for (const Key* key : keys_in(pattern)) {
    const std::string leaf = leaf_of(key->pattern);
    if (is_table(key->kind))
      if (Json below = complete_value(*key); !below.empty()) schema["properties"][leaf] = std::move(below);
    if (!key->only_when.key.empty() && key->presence != Presence::optional)
      conditional[{key->only_when.key, key->only_when.values}].push_back(key);
    else if (key->presence == Presence::required)
      schema["required"].push_back(leaf);
  }
  for (const auto& [state, keys] : conditional)
    schema["allOf"].push_back(required_where({state.first, state.second}, keys));
  return schema;
}

}  // namespace

std::string json_schema() {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "pulvis case file"}};
  schema.update(table_schema(""));
  // What must be there may stand in the file that another extends.
  schema["if"] = {{"not", {{"required", {"extends"}}}}};
  schema["then"] = complete_table("");
  return schema.dump(2) + "\n";
}

}  // namespace pulvis
