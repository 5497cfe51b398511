// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "case/keys.hpp"
#include "case/reader.hpp"

namespace pulvis {
namespace {

using namespace case_file;

// With PULVIS_WRITE_DOCUMENTS set, the pages are written instead of compared.
void expect_current(const std::string& name, const std::string& content) {
  const std::string path = std::string(PULVIS_SOURCE_DIR) + "/docs/" + name;
  if (std::getenv("PULVIS_WRITE_DOCUMENTS") != nullptr) std::ofstream(path) << content;
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(text.str() == content) << "docs/" << name
                                     << " is older than the key table; renew it with\n"
                                        "PULVIS_WRITE_DOCUMENTS=1 case_tests --gtest_filter='Documents.*'";
}

TEST(Documents, ReferencePageIsThatOfTheKeyTable) {
  expect_current("case-keys.md", keys_reference_markdown());
}

TEST(Documents, SchemaIsThatOfTheKeyTable) { expect_current("case.schema.json", json_schema()); }

TEST(Documents, ReferenceHoldsEveryKey) {
  const std::string page = keys_reference_markdown();
  for (const Key& key : all_keys()) EXPECT_NE(page.find(key.help), std::string::npos) << key.pattern;
}

TEST(Documents, SchemaHoldsEveryKey) {
  const nlohmann::json schema = nlohmann::json::parse(json_schema());
  for (const Key& key : all_keys()) {
    // Down the schema along the pattern: "a.*.b", "a[].b", "a.b".
    const nlohmann::json* at = &schema;
    std::stringstream pattern(key.pattern);
    for (std::string part; std::getline(pattern, part, '.');) {
      const bool listed = part.ends_with("[]");
      if (listed) part.resize(part.size() - 2);
      if (part == "*")
        at = &at->at("patternProperties").begin().value();
      else
        at = &at->at("properties").at(part);
      if (listed) at = &at->at("items");
    }
    EXPECT_EQ(at->at("description"), key.help) << key.pattern;
  }
  EXPECT_EQ(schema.at("then").at("required"),
            (nlohmann::json{"domain", "materials", "powders", "sources", "phases"}));
}

}  // namespace
}  // namespace pulvis
