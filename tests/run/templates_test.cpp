// SPDX-License-Identifier: Apache-2.0
// The cases that are shipped: what a new user starts from must work.
#include <gtest/gtest.h>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

TEST(Templates, NewWritesTheExampleCaseAndItChecks) {
  TemporaryFolder folder;
  const Outcome made = call({"new", "die-filling", folder / "my/first-case"});
  ASSERT_EQ(made.exit, 0) << made.err;
  const std::string file = folder / "my/first-case/case.toml";
  EXPECT_TRUE(has(made.out, file)) << made.out;
  EXPECT_EQ(text_of(file), text_of(source_folder() + "/cases/die-filling/quick.toml"));
  const Outcome check = call({"check", file});
  EXPECT_EQ(check.exit, 0) << check.err;
}

TEST(Templates, NewOverwritesNothing) {
  TemporaryFolder folder;
  folder.file("case.toml", "mine");
  const Outcome again = call({"new", "die-filling", folder.path().string()});
  EXPECT_EQ(again.exit, 2);
  EXPECT_TRUE(has(again.err, folder / "case.toml")) << again.err;
  EXPECT_EQ(text_of(folder / "case.toml"), "mine");
}

TEST(Templates, EveryCaseShippedChecksWithoutAWordOfOverlapAtRest) {
  std::size_t cases = 0;
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() + "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome check = call({"check", entry.path().string()});
    EXPECT_EQ(check.exit, 0) << entry.path() << "\n" << check.err;
    EXPECT_FALSE(has(check.err, "overlap at rest")) << check.err;
    EXPECT_FALSE(has(check.err, "adhesion")) << check.err;
    ++cases;
  }
  EXPECT_GE(cases, 1u);
}

// What a mode is compared by must be all that distinguishes it.
TEST(Templates, TheModesOfDieFillingAreShakenEquallyLongAndEquallyHard) {
  for (const char* mode : {"sine-5hz", "sine-10hz", "square-5hz", "square-10hz"})
    for (const char* size : {"", "small/"}) {
      const std::string file = source_folder() + "/cases/die-filling/" + size + mode + ".toml";
      const Outcome check = call({"check", file});
      ASSERT_EQ(check.exit, 0) << check.err;
      EXPECT_TRUE(has(check.out, "peak acceleration 12 m/s^2")) << file << "\n" << check.out;
      EXPECT_TRUE(has(check.out, *size == 0 ? "parcels 102595" : "parcels 10020")) << file << "\n"
                                                                                   << check.out;
    }
}

}  // namespace
