// SPDX-License-Identifier: Apache-2.0
// Coarse graining as a case asks for it: what `pulvis check` says, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "case/reader.hpp"
#include "run/preflight.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

constexpr double alpha = 10.0;  // of the small die

struct Checked {
  Forecast forecast;
  std::string report;
};

Checked checked(const std::string& text, const std::vector<Override>& overrides = {}) {
  const Case c = read_case_text(text, "case.toml", overrides);
  const Assembly assembly = assemble(c);
  Checked k{forecast(c, assembly), {}};
  k.report = check_report(c, assembly, k.forecast);
  return k;
}

std::string refusal(const std::string& text, const std::vector<Override>& overrides = {}) {
  try {
    checked(text, overrides);
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_case);
    return failure.what();
  }
  return {};
}

const Counterpart& number(const std::vector<Counterpart>& list, const std::string& name) {
  for (const Counterpart& n : list)
    if (n.name.starts_with(name)) return n;
  throw std::logic_error("no number " + name);
}

bool warns(const Checked& k, const std::string& part) {
  return std::any_of(k.forecast.warnings.begin(), k.forecast.warnings.end(),
                     [&](const std::string& w) { return has(w, part); });
}

TEST(Graining, ByStressKeepsAllOfAContactButTheBondNumber) {
  const Graining g = checked(small_die).forecast.graining;
  ASSERT_EQ(g.pairs.size(), 2u);
  for (const PairGraining& p : g.pairs)
    for (const Counterpart& n : p.numbers) {
      if (n.name == "Bond number")
        EXPECT_NEAR(n.parcel / n.grain, 1.0 / alpha, 1e-6);
      else
        EXPECT_TRUE(n.is_kept(alpha)) << p.pair << ": " << n.name << " " << n.grain << " " << n.parcel;
    }
  EXPECT_NEAR(
      number(g.pairs[0].numbers, "contact time").parcel / number(g.pairs[0].numbers, "contact time").grain,
      alpha, 0.01 * alpha);
  EXPECT_TRUE(number(g.whole, "time step").is_kept(alpha));
  EXPECT_NEAR(number(g.whole, "number").grain, 145e3, 1e3);
  EXPECT_NEAR(number(g.whole, "inertial").ratio(alpha), alpha, 1e-9);
}

TEST(Graining, ByBondKeepsTheBondNumberAndRaisesTheStrength) {
  const Graining g = checked(small_die, {{"contact.similarity", "\"bond\""}}).forecast.graining;
  for (const PairGraining& p : g.pairs) {
    EXPECT_TRUE(number(p.numbers, "Bond").is_kept(alpha));
    EXPECT_NEAR(number(p.numbers, "pull-off").ratio(alpha), alpha, 1e-6);
    EXPECT_FALSE(number(p.numbers, "sticking").is_kept(alpha));
  }
}

TEST(Graining, WithoutSimilarityLeavesTheGrainsNumbersAndLosesStrength) {
  const Case c = read_case_text(small_die, "case.toml", {{"contact.similarity", "\"none\""}});
  const Assembly a = assemble(c);
  EXPECT_EQ(a.pairs[0].simulated.work_of_adhesion, a.pairs[0].real.work_of_adhesion);
  const Graining g = forecast(c, a).graining;
  EXPECT_NEAR(number(g.pairs[0].numbers, "pull-off").ratio(alpha), 1.0 / alpha, 1e-6);
  EXPECT_NEAR(number(g.pairs[0].numbers, "Bond").ratio(alpha), 1.0 / (alpha * alpha), 1e-6);
}

TEST(Graining, IsPrintedSideBySideWithWhatIsKept) {
  const std::string report = checked(small_die).report;
  for (const char* part :
       {"coarse graining 10, similarity stress", "grain         parcel", "Bond number", "contact time",
        "sticking speed", "time step", "number", "as factor^1", "kept: stresses", "not kept: pull-off"})
    EXPECT_TRUE(has(report, part)) << part << " is not in\n" << report;
  const std::string grains = checked(small_die, {{"powders.beads.coarse_graining", "1"},
                                                 {"walls.die.max", R"(["0.3 mm", "0.3 mm", "0.4 mm"])"}})
                                 .report;
  EXPECT_FALSE(has(grains, "not kept")) << "there are no parcels";
}

TEST(Graining, WarnsOfADieNarrowerThanTenParcels) {
  // 3 mm: six parcels of half a millimetre, ten of 0.3.
  EXPECT_TRUE(warns(checked(small_die), "walls.die is only 5.45 of the largest parcels wide"));
  EXPECT_FALSE(warns(checked(small_die, {{"powders.beads.coarse_graining", "5"}}), "largest parcels wide"));
}

const char* const funnel = R"([walls.funnel]
shape = "cone"
base = ["1.5 mm", "1.5 mm", "7 mm"]
axis = [0, 0, 1]
radius = "1 mm"
top_radius = "3 mm"
height = "3 mm"
open = ["base", "top"]
material = "steel"

[motions.shaking])";

std::string with_funnel(const std::string& radius) {
  return with(with(small_die, "[motions.shaking]", funnel) + "[measures]\ndie = \"die\"\n",
              "radius = \"1 mm\"", "radius = \"" + radius + "\"");
}

TEST(Graining, WarnsOfAnOutletNarrowerThanTenParcelsAndRefusesOneThatOnlyGrainsPass) {
  EXPECT_TRUE(
      warns(checked(with_funnel("1 mm")), "the opening of walls.funnel is only 3.64 of the largest parcels"));
  const std::string refused = refusal(with_funnel("0.25 mm"));
  for (const char* part :
       {"case.toml:", "the opening of walls.funnel is 500 um wide", "lower coarse_graining"})
    EXPECT_TRUE(has(refused, part)) << refused;
  EXPECT_EQ(refusal(with_funnel("0.02 mm")), "") << "not even grains pass: it is closed";
}

TEST(Graining, WarnsOfFlowInWhichCollisionsOfParcelsCarryTheStress) {
  EXPECT_TRUE(warns(checked(small_die), "inertial number"));
  EXPECT_FALSE(warns(checked(small_die, {{"time.characteristic_speed", "\"1 mm/s\""}}), "inertial number"));
}

TEST(Graining, RefusesASimilarityThatTheLawDoesNotKnow) {
  const std::string yields = R"([contact]
similarity = "bond"
normal_stiffness = "1 N/m"
plastic_ratio = 5
adhesion_ratio = 0.2
plasticity_depth = 0.05
)";
  std::string text = with(small_die, "normal = \"jkr\"", "normal = \"luding\"");
  const std::string luding = refusal(with(text, "[contact]\n", yields));
  EXPECT_TRUE(has(luding, "case.toml:")) << luding;
  EXPECT_TRUE(
      has(luding,
          "contact.similarity = \"bond\" has no rule for this law: the pull-off force of \"luding\" is no "
          "power of its adhesion_ratio"))
      << luding;
  EXPECT_TRUE(has(luding, "take \"stress\"")) << luding;
  const std::string sjkr = refusal(small_die, {{"contact.similarity", "\"bond\""},
                                               {"contact.normal", "\"hooke\""},
                                               {"contact.characteristic_speed", "\"0.1 m/s\""},
                                               {"contact.cohesion", "\"sjkr\""},
                                               {"contact.cohesion_energy_density", "\"1e3 J/m^3\""}});
  EXPECT_TRUE(has(sjkr, "\"sjkr\" has a pull-off force with the normal law \"hertz\" only")) << sjkr;
}

TEST(Graining, RefusesAFactorBelowOneAndParcelsLargerThanAPartThatIsMeasured) {
  try {
    read_case_text(small_die, "case.toml", {{"powders.beads.coarse_graining", "0.9"}});
    ADD_FAILURE() << "a factor below 1";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_case);
    EXPECT_TRUE(has(failure.what(), "at least 1")) << failure.what();
  }
  const std::string thin = std::string(small_die) +
                           "[measures.parts.skin]\nmin = [\"0 mm\", \"0 mm\", \"0 mm\"]\n"
                           "max = [\"3 mm\", \"3 mm\", \"0.4 mm\"]\n";
  const std::string refused = refusal(thin);
  EXPECT_TRUE(has(refused, "measures.parts.skin is 400 um thin, less than the largest parcel (550 um)"))
      << refused;
}

}  // namespace
