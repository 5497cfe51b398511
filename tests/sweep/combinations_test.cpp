// SPDX-License-Identifier: Apache-2.0
// Which runs a sweep has, what they are called, and how they share the processors.
#include "sweep/combinations.hpp"

#include <gtest/gtest.h>

#include <set>

#include "engine/base/failure.hpp"
#include "sweep/overview.hpp"
#include "sweep/sweep.hpp"

namespace pulvis::sweep {
namespace {

std::vector<std::string> names_of(const Choice& choice) {
  std::vector<std::string> names;
  for (const Member& member : combinations(choice)) names.push_back(member.name);
  return names;
}

std::string fault_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::usage);
    return failure.what();
  }
  return "none";
}

using Names = std::vector<std::string>;

TEST(Combinations, AreEveryCaseWithEveryValue) {
  const Choice choice{{"a.toml", "b.toml"},
                      {{"materials.mo.friction", {"0.3", "0.5"}}, {"phases.shake.cycles", {"2"}}},
                      0,
                      {{"output.picture", "false"}}};
  EXPECT_EQ(names_of(choice), (Names{"a-friction-0.3-cycles-2", "a-friction-0.5-cycles-2",
                                     "b-friction-0.3-cycles-2", "b-friction-0.5-cycles-2"}));
  const Member last = combinations(choice).back();
  EXPECT_EQ(last.case_file, "b.toml");
  ASSERT_EQ(last.settings.size(), 3u);
  EXPECT_EQ(last.settings[0].key, "output.picture");
  EXPECT_EQ(last.settings[1].value, "0.5");
  EXPECT_EQ(last.varied.size(), 2u);
}

TEST(Combinations, HaveTheSeedChangeLast) {
  EXPECT_EQ(names_of({{"a.toml", "b.toml"}, {{"time.fraction", {"0.1", "0.2"}}}, 2, {}}),
            (Names{"a-fraction-0.1-seed-1", "a-fraction-0.2-seed-1", "b-fraction-0.1-seed-1",
                   "b-fraction-0.2-seed-1", "a-fraction-0.1-seed-2", "a-fraction-0.2-seed-2",
                   "b-fraction-0.1-seed-2", "b-fraction-0.2-seed-2"}));
}

TEST(Combinations, OfOneCaseAloneAreThatCase) {
  EXPECT_EQ(names_of({{"x/die.toml"}, {}, 0, {}}), Names{"die"});
}

TEST(Combinations, HaveNamesThatAreFoldersAnywhereAndDiffer) {
  EXPECT_EQ(names_of({{"small/sine.toml", "large/sine.toml"}, {}, 0, {}}),
            (Names{"small-sine", "large-sine"}));
  const Choice hard{
      {"my case.toml"}, {{"a.b", {"1 m/s", "1 m s", "-1 m/s", "../../etc", "[1, 2]", "\"x\""}}}, 0, {}};
  const Names names = names_of(hard);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const std::string& name : names) {
    EXPECT_EQ(name.find('/'), std::string::npos) << name;
    EXPECT_EQ(name.find(' '), std::string::npos) << name;
    EXPECT_TRUE(name.starts_with("my-case-b-")) << name;
  }
  EXPECT_NE(names_of({{"comparison.toml"}, {}, 0, {}}), Names{"comparison"}) << "that is the page's";
}

TEST(Combinations, RefuseWhatIsGivenTwice) {
  EXPECT_NE(fault_of([] {
              combinations({{"a.toml", "./a.toml"}, {}, 0, {}});
            }).find("given twice"),
            std::string::npos);
  EXPECT_NE(fault_of([] {
              combinations({{"a"}, {{"k", {"1"}}, {"k", {"2"}}}, 0, {}});
            }).find("given twice"),
            std::string::npos);
  EXPECT_NE(fault_of([] {
              combinations({{"a"}, {{"seed", {"1"}}}, 2, {}});
            }).find("seed is given twice"),
            std::string::npos);
  EXPECT_NE(fault_of([] {
              combinations({{"a"}, {{"k", {"1"}}}, 0, {{"k", "2"}}});
            }).find("varied, and set"),
            std::string::npos);
}

TEST(Factors, AreSplitAtCommasOutsideQuotesAndBrackets) {
  EXPECT_EQ(factor_from("a.b=1,2 , 3").values, (Names{"1", "2", "3"}));
  EXPECT_EQ(factor_from("a.b=[\"0 m\", \"1 m\"],[\"2 m\", \"3 m\"]").values,
            (Names{"[\"0 m\", \"1 m\"]", "[\"2 m\", \"3 m\"]"}));
  EXPECT_EQ(factor_from("a={ k = 1, l = 2 },'x,y'").values, (Names{"{ k = 1, l = 2 }", "'x,y'"}));
  EXPECT_EQ(factor_from("a.b=1e-4 J/m^2").values, Names{"1e-4 J/m^2"});
  for (const char* wrong : {"a.b", "=1", "a.b=", "a.b=1,,2", "a.b=1,1"})
    EXPECT_NE(fault_of([&] { factor_from(wrong); }), "none") << wrong;
}

TEST(Processors, AreSharedAmongTheRuns) {
  const auto of = [](int jobs, int threads, std::size_t runs, int processors) {
    const Shares s = shares(jobs, threads, runs, processors);
    return std::pair(s.jobs, s.threads);
  };
  EXPECT_EQ(of(0, 0, 100, 16), std::pair(16, 1));
  EXPECT_EQ(of(0, 0, 3, 16), std::pair(3, 5));
  EXPECT_EQ(of(0, 0, 1, 2), std::pair(1, 2));
  EXPECT_EQ(of(0, 4, 100, 16), std::pair(4, 4));
  EXPECT_EQ(of(0, 8, 100, 2), std::pair(1, 8));
  EXPECT_EQ(of(2, 0, 100, 16), std::pair(2, 8));
  EXPECT_EQ(of(8, 0, 2, 16), std::pair(8, 8)) << "only two will run";
  EXPECT_EQ(of(3, 2, 100, 4), std::pair(3, 2)) << "as asked for";
}

TEST(Overview, CountsTheRuns) {
  EXPECT_EQ(overview_text({3, 2, 4, 1, 0}, 720.0),
            "3 of 10 runs complete, 2 running, 1 failed, about 12 min 00 s left");
  EXPECT_EQ(overview_text({0, 0, 1, 0, 1}, {}), "0 of 2 runs complete, 1 stopped");
}

}  // namespace
}  // namespace pulvis::sweep
