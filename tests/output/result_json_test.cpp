// SPDX-License-Identifier: Apache-2.0
#include "output/result_json.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "failures.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;
using nlohmann::ordered_json;

TEST(ResultJson, KeepsNumbersTextAndTheOrderOfKeys) {
  ScratchFolder folder;
  const ordered_json content{
      {"zeta", 1.0 / 3.0}, {"alpha", 4.6e-6}, {"count", 18446744073709551615u}, {"name", "µm"}};
  write_json(folder.file("r.json"), content);
  const auto text = content_of(folder.file("r.json"));
  EXPECT_EQ(ordered_json::parse(text), content);
  EXPECT_LT(text.find("zeta"), text.find("alpha"));
  EXPECT_EQ(text.back(), '\n');
}

TEST(ResultJson, RefusesNumbersThatAreNotFiniteAndSaysWhere) {
  ScratchFolder folder;
  ordered_json content;
  content["phases"] = {{{"measures", {{"porosity", 0.5}}}},
                       {{"measures", {{"porosity", std::numeric_limits<double>::quiet_NaN()}}}}};
  const auto message = failure_of(Exit::internal_check, [&] { write_json(folder.file("r.json"), content); });
  EXPECT_NE(message.find("phases[1].measures.porosity = nan is not a finite number"), std::string::npos)
      << message;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ResultJson, ReplacesBrokenLettersAndKeepsTheRest) {
  ScratchFolder folder;
  write_json(folder.file("r.json"), {{"name", "a\xFFz"}, {"value", 2.5}});
  EXPECT_EQ(ordered_json::parse(content_of(folder.file("r.json"))),
            (ordered_json{{"name", "a\xEF\xBF\xBDz"}, {"value", 2.5}}));
}

}  // namespace
}  // namespace pulvis
