// SPDX-License-Identifier: Apache-2.0
// A run of a case that extends another: its folder holds the whole case, and a change of any of its files is seen.
#include <gtest/gtest.h>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;

namespace {

// A die that is filled for 20 ms, in two files.
class ExtendedCase : public testing::Test {
 protected:
  ExtendedCase() {
    folder_.file("base.toml", small_die);
    folder_.file("die.toml", over);
  }
  std::vector<std::string> run(const std::string& out, const std::string& file = "die.toml") const {
    return {"run", folder_ / file, "--threads", "1", "--out", folder_ / out};
  }
  static constexpr const char* over = R"(extends = "base.toml"
materials.glass.friction = 0.3
[[phases]]
name = "fill"
sources = ["rain"]
until = "time"
duration = "20 ms"
)";
  TemporaryFolder folder_;
};

TEST_F(ExtendedCase, LeavesItsWholeCaseInTheRunFolder) {
  const Outcome first = call(run("out"));
  ASSERT_EQ(first.exit, 0) << first.err;
  const Json keys = json_of(folder_ / "out/run.json");
  EXPECT_EQ(keys["extends"], Json::array({folder_ / "base.toml"}));
  EXPECT_EQ(keys["keys"]["materials.glass.friction"]["origin"], folder_ / "die.toml" + ":2");
  EXPECT_EQ(keys["keys"]["materials.glass.restitution"]["origin"], folder_ / "base.toml" + ":13");
  // By itself, elsewhere, without the files it was made of.
  folder_.file("alone.toml", text_of(folder_ / "out/case.toml"));
  std::filesystem::remove(folder_ / "base.toml");
  const Outcome again = call(run("again", "alone.toml"));
  ASSERT_EQ(again.exit, 0) << again.err;
  EXPECT_EQ(json_of(folder_ / "again/result.json")["state_hash"],
            json_of(folder_ / "out/result.json")["state_hash"]);
}

TEST_F(ExtendedCase, GoesOnOnlyIfNoneOfItsFilesMeansSomethingElse) {
  ASSERT_EQ(call(run("out")).exit, 0);
  auto resume = run("out");
  resume.push_back("--resume");
  folder_.file("base.toml", with(small_die, "A small die", "Another title"));
  folder_.file("die.toml",
               "# the friction stands elsewhere, and nothing else is changed\n" + std::string(over));
  const Outcome same = call(resume);
  EXPECT_EQ(same.exit, 0) << same.err;
  folder_.file("base.toml", with(small_die, "restitution = 0.4", "restitution = 0.45"));
  const Outcome changed = call(resume);
  EXPECT_EQ(changed.exit, 2);
  EXPECT_TRUE(has(changed.err, "materials.glass.restitution was 0.4, is 0.45")) << changed.err;
}

TEST_F(ExtendedCase, IsRefusedWhereResultsCouldReplaceItsBase) {
  std::filesystem::create_directory(folder_ / "out");
  folder_.file("out/case.toml", small_die);
  folder_.file("die.toml", with(over, "base.toml", "out/case.toml"));
  auto arguments = run("out");
  arguments.push_back("--force");
  const Outcome refused = call(arguments);
  EXPECT_EQ(refused.exit, 2);
  EXPECT_TRUE(has(refused.err, "out/case.toml lies in the results folder")) << refused.err;
  EXPECT_EQ(text_of(folder_ / "out/case.toml"), small_die);
}

TEST_F(ExtendedCase, EndsWithTheExitCodeOfWhatIsWrongWithItsFiles) {
  folder_.file("die.toml", "extends = \"nothing.toml\"\n");
  EXPECT_EQ(call({"check", folder_ / "die.toml"}).exit, 4);
  folder_.file("die.toml", "extends = \"die.toml\"\n");
  EXPECT_EQ(call({"check", folder_ / "die.toml"}).exit, 3);
}

}  // namespace
