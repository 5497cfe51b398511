// SPDX-License-Identifier: Apache-2.0
#include "report/judgement.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/quantity_text.hpp"
#include "tests/output/scratch_folder.hpp"
#include "tests/report/sample_run.hpp"

using namespace pulvis;
using namespace pulvis::report;
using namespace pulvis::test;

namespace {

Judgement judgement_of(const SampleRun& run) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"), run);
  return judge(read_run(scratch.file("run")));
}

bool says(const std::vector<std::string>& sentences, const std::string& words) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& s) { return s.find(words) != std::string::npos; });
}

TEST(Judgement, SaysByHowMuchTheLowerThirdIsDenser) {
  // Slices at 1/12, 3/12, ..., the lowest and the highest left out: thirds are single slices half the height apart.
  EXPECT_TRUE(
      says(judgement_of({.lower_denser = 0.03}).uniformity, "The lower third of the powder is 1.5 % denser"));
  EXPECT_TRUE(
      says(judgement_of({.lower_denser = -0.06}).uniformity, "The lower third of the powder is 3 % looser"));
  EXPECT_TRUE(says(judgement_of({.lower_denser = 0.0}).uniformity,
                   "The lower third of the powder is as dense as the upper third (difference 0 %)"));
}

TEST(Judgement, SaysWhatEachPhaseChanged) {
  const Judgement j = judgement_of({.porosity = 0.48});
  EXPECT_TRUE(says(j.changes, "In \"shake\" the powder became denser by 4 % (porosity 0.5 to 0.48)"));
}

TEST(Judgement, ComparesNoDensitiesWhilePowderArrives) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  RunData run = read_run(scratch.file("run"));
  for (Scalar& m : run.phases[0].measures)
    if (m.name == "fill_mass") m.value *= 0.5;
  const Judgement j = judge(run);
  EXPECT_TRUE(says(j.changes, "the mass in the die changed by +100 %"));
  EXPECT_FALSE(says(j.changes, "denser"));
  EXPECT_FALSE(says(j.to_try, "longer shaking"));
}

TEST(Judgement, AdvisesLongerShakingWhileItStillCompacts) {
  EXPECT_TRUE(says(judgement_of({}).to_try, "still made the powder denser (+4 %)"));
}

TEST(Judgement, AdvisesOnlyWhatItsLimitsAskFor) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  const RunData run = read_run(scratch.file("run"));
  JudgementRules lenient;
  lenient.few_parcels = 13.0;
  EXPECT_FALSE(says(judge(run, lenient).to_try, "fit across"));
  EXPECT_FALSE(says(judge(run).to_try, "overlapped"));
  JudgementRules strict;
  strict.few_parcels = 14.0;
  strict.soft = 0.01;
  EXPECT_TRUE(says(judge(run, strict).to_try, "Only 13 parcels fit"));
  EXPECT_TRUE(says(judge(run, strict).to_try, "up to 2 % of their radius"));
  strict.few_parcels = 13.0;
  EXPECT_FALSE(says(judge(run, strict).to_try, "parcels fit"));
}

TEST(Judgement, ShowsTheLimitsItGoesBy) {
  JudgementRules rules;
  rules.changed = 0.0123;
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  bool shown = false;
  for (const auto& [words, limit] : judge(read_run(scratch.file("run")), rules).rules)
    shown = shown || limit.find("1.2 %") != std::string::npos;
  EXPECT_TRUE(shown);
}

TEST(Judgement, OfARunWithoutMeasuresIsEmpty) { EXPECT_TRUE(judge(RunData{}).rules.empty()); }

TEST(QuantityText, ChoosesTheUnitByTheSize) {
  EXPECT_EQ(value_text(0.0063, "m"), "6.3 mm");
  EXPECT_EQ(value_text(0.00022, "m", 2), "220 um");
  EXPECT_EQ(value_text(0.48, "1"), "0.48");
  EXPECT_EQ(value_text(5300, "kg/m^3"), "5.3 g/cm^3");
  EXPECT_EQ(value_text(std::numeric_limits<double>::quiet_NaN(), "m"), "-");
  EXPECT_EQ(value_text(3.0, "furlong"), "3 furlong");
}

}  // namespace
