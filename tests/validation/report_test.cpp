// SPDX-License-Identifier: Apache-2.0
#include "validation/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "case/case.hpp"
#include "validation/collisions.hpp"
#include "validation/validate.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

TEST(Findings, PassWhereTheDeviationIsWithinTheLimit) {
  Findings f;
  f.compare("within", "theory", 2.0, 2.001, Compare::relative, 1e-3);
  EXPECT_TRUE(f.passed());
  f.compare("reported", "theory", 2.0, 9.0, Compare::absolute, {});
  EXPECT_TRUE(f.passed());
  f.compare("beyond", "theory", 0.0, -0.2, Compare::bound, 0.1);
  EXPECT_FALSE(f.passed());
}

TEST(Findings, DoNotPassIfThereAreNoneOrANumberIsNotOne) {
  EXPECT_FALSE(Findings{}.passed());
  Findings f;
  f.compare("not a number", "theory", 1.0, std::nan(""), Compare::relative, 1e9);
  EXPECT_FALSE(f.passed());
  Findings g;
  g.compare("over nothing", "theory", 0.0, 0.0, Compare::relative, 1e9);
  EXPECT_FALSE(g.passed());
}

TEST(ValidationReport, HasEveryRowInTableJsonAndPage) {
  Result r{&chapters().front(), {}, 0.5};
  r.findings.compare("good one", "theory", 1.0, 1.0, Compare::relative, 1e-3).automatic = 1.25;
  r.findings.compare("bad one", "theory", 1.0, 2.0, Compare::relative, 1e-3);
  r.findings.compare("not judged", "theory", 1.0, 2.0, Compare::relative, {});
  const std::string table = table_text({r}), page = page_text({r}, true);
  for (const char* name : {"good one", "bad one", "not judged"}) {
    EXPECT_NE(table.find(name), std::string::npos);
    EXPECT_NE(page.find(name), std::string::npos);
  }
  const auto rows = nlohmann::json::parse(json_text({r}))["rows"];
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0]["pass"], true);
  EXPECT_EQ(rows[0]["value_at_automatic_step"], 1.25);
  EXPECT_EQ(rows[1]["pass"], false);
  EXPECT_EQ(rows[1]["deviation"], 1.0);
  EXPECT_TRUE(rows[2]["limit"].is_null());
  EXPECT_FALSE(all_passed({r}));
  EXPECT_FALSE(all_passed({}));
}

TEST(Validate, NoticesAFileItCannotWriteBeforeItRuns) {
  Request request;
  request.only = {"jkr"};
  request.threads = 1;
  request.json = "/nowhere/at/all.json";
  try {
    validate(request);
    ADD_FAILURE() << "wrote it";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::io);
  }
  request.only = {"alchemy"};
  try {
    validate(request);
    ADD_FAILURE() << "there is such a chapter";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::usage);
  }
}

TEST(AutomaticStep, TakesTheStandardShareOfTheSmallestLimit) {
  EXPECT_EQ(scenes::standard_step_fraction, Case{}.time.fraction);
  scenes::Collision c;
  c.material = scenes::on_rigid_plane(1e7, 0.3, 0.5, 0.0);
  c.radius = 1e-3;
  c.density = 2500;
  c.speed = 1e-6;
  c.at_wall = true;
  EXPECT_NEAR(scenes::automatic_step(c), 0.2 * laws::rayleigh_time(1e-3, 2500, 1e7, 0.3), 1e-12);
  c.speed = 1e6;
  EXPECT_NEAR(scenes::automatic_step(c), 0.2 * c.contact_time(), 1e-15);
}

}  // namespace
