// SPDX-License-Identifier: Apache-2.0
// A case that shears its domain: what it measures, and what it may not have beside it.
#include "run/sheared_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "case/reader.hpp"
#include "run/assemble.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

const std::string box = R"(
[domain]
min = ["0 mm", "0 mm", "0 mm"]
max = ["6 mm", "6 mm", "6 mm"]
periodic = ["x", "y", "z"]
shear = { rate = "20 1/s", flow = "y", gradient = "x" }

[gravity]
acceleration = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]

[materials.beads]
density = "2500 kg/m^3"
young_modulus = "10 MPa"
poisson_ratio = 0.3
restitution = 0.7
friction = 0.5

[powders.beads]
material = "beads"
size = { kind = "single", diameter = "1 mm" }

[contact]
normal = "hooke"
normal_stiffness = "1000 N/m"
tangential_ratio = 0.2857

[sources.beads]
kind = "dense"
solid_fraction = 0.62

[[phases]]
name = "shear"
sources = ["beads"]
until = "time"
duration = "10 ms"

[measures]
interval = "1 ms"

[output]
picture = false
report = false
)";

double measured(const Json& result, const char* name) {
  return result["measures"][name]["value"].get<double>();
}

TEST(ShearedBox, IsFilledShearedAndMeasured) {
  const RunOfCase run(with(box, "picture = false", "picture = true"));
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  const Json result = run.result();
  EXPECT_EQ(result["ledger"]["inserted"], 256);
  EXPECT_NEAR(measured(result, "solid_fraction"), 256 * M_PI / 6 / 216, 1e-12);
  EXPECT_GT(measured(result, "pressure"), 0.001 * 1e6) << "jammed: a share of k/d";
  EXPECT_LT(measured(result, "pressure"), 0.1 * 1e6);
  EXPECT_GT(measured(result, "shear_stress"), 0.1 * measured(result, "pressure"));
  EXPECT_GT(measured(result, "pressure_kinetic"), 0.0);
  EXPECT_GT(measured(result, "coordination"), 4.0);
  EXPECT_GT(measured(result, "granular_temperature"), 0.0);
  std::istringstream table(text_of(run.out("measures.csv")));
  std::string head;
  std::getline(table, head);
  for (const char* column :
       {"pressure_Pa", "shear_stress_Pa", "solid_fraction", "granular_temperature_m2_s2"})
    EXPECT_TRUE(has(head, column)) << head;
  EXPECT_TRUE(std::filesystem::exists(run.out("picture.png")));
}

TEST(ShearedBox, GoesOnFromACheckpointAsIfItHadNotBeenLeft) {
  const RunOfCase straight(box);
  TemporaryFolder folder;
  const std::string file = folder.file("case.toml", box), out = folder / "out";
  ASSERT_EQ(call({"run", file, "--out", out, "--threads", "1", "--max-wall", "0 s"}).exit, 75);
  ASSERT_EQ(call({"run", file, "--out", out, "--threads", "2", "--resume", "--max-wall", "0 s"}).exit, 75);
  ASSERT_EQ(call({"run", file, "--out", out, "--threads", "2", "--resume"}).exit, 0);
  EXPECT_EQ(json_of(out + "/result.json")["state_hash"], straight.result()["state_hash"]);
  EXPECT_EQ(text_of(out + "/measures.csv"), text_of(straight.out("measures.csv")));
}

/// Sheared the other way round, everything is a mirror image: stresses that resist have the same sign.
TEST(ShearedBox, ResistsWhicheverWayItIsSheared) {
  const RunOfCase back(with(box, "rate = \"20 1/s\"", "rate = \"-20 1/s\""));
  ASSERT_EQ(back.exit(), 0) << back.outcome().err;
  EXPECT_GT(measured(back.result(), "shear_stress"), 0.1 * measured(back.result(), "pressure"));
}

/// Two parcels that press each other across the moving face: the contact counts with the short way between the images.
TEST(ShearedBox, StressTakesTheImagesWayBetweenPartnersAcrossTheFace) {
  Model m = assemble(read_case_text(box, "case.toml", {})).model;
  m.domain.shear.shift_at_start = 0.0013;
  State state = Simulation::initial_state(m);
  state.sources[0].done = true;
  const double mass = 2500.0 * sphere_volume(0.5e-3);
  for (std::uint32_t k = 0; k < 2; ++k) {
    Parcel p;
    p.id = k;
    p.radius = 0.5e-3;
    p.mass = mass;
    p.position = k == 0 ? Vec3{5.8e-3, 3e-3, 2e-3} : Vec3{0.75e-3, 3e-3 - 0.0013, 2e-3};
    p.velocity = m.domain.flow_velocity(p.position);
    state.parcels.body.push_back(p);
    state.parcels.load.push_back({});
  }
  state.pairs.begin = state.walls.begin = {0, 0, 0};
  state.next_id = 2;
  state.ledger.inserted = 2;
  Simulation simulation(m, state, 1);
  simulation.step();
  const ShearedBox seen = look_at_sheared_box(simulation);
  const double force = 1000.0 * 0.05e-3, branch = 0.95e-3;
  EXPECT_NEAR(seen.stress.contact.rows[0].x, force * branch / std::pow(6e-3, 3),
              0.01 * force * branch / std::pow(6e-3, 3));
  EXPECT_LT(std::fabs(seen.stress.contact.rows[2].z), 1e-9);
  EXPECT_LT(seen.stress.kinetic_pressure(), 1e-3 * seen.stress.pressure())
      << "the flow itself is no fluctuation";
  EXPECT_EQ(seen.coordination, 1.0);
}

void expect_refused(const std::string& text, const std::vector<std::string>& parts) {
  TemporaryFolder folder;
  const Outcome check = call({"check", folder.file("case.toml", text)});
  EXPECT_EQ(check.exit, 3) << check.err;
  for (const std::string& part : parts)
    EXPECT_TRUE(has(check.err, part)) << "no \"" << part << "\" in\n" << check.err;
}

TEST(ShearedBox, ThatCannotBeIsRefused) {
  const std::string wall = R"([walls.floor]
shape = "plane"
point = ["0 mm", "0 mm", "1 mm"]
normal = [0, 0, 1]
material = "beads"

[sources.beads])";
  expect_refused(with(box, "[sources.beads]", wall),
                 {"case.toml:27", "walls.floor", "no walls beside domain.shear"});
  expect_refused(with(box, R"(["x", "y", "z"])", R"(["x", "y"])"),
                 {"domain.shear needs", "periodic all around"});
  expect_refused(with(box, R"("0 m/s^2"])", R"("-9.81 m/s^2"])"),
                 {"nothing bears weight", "gravity.acceleration"});
  expect_refused(with(box, "rate = \"20 1/s\"", "rate = \"0 1/s\""), {"domain.shear.rate is 0"});
  expect_refused(with(box, R"(gradient = "x")", R"(gradient = "y")"), {"gradient along the flow"});
  expect_refused(with(box, R"(max = ["6 mm")", R"(max = ["4 mm")"), {"narrower than 5 parcels", "along x"});
  const std::string later = R"([[phases]]
name = "rest"
until = "time"
duration = "1 ms"

[[phases]])";
  expect_refused(with(box, "[[phases]]", later), {"filled in the first phase only"});
  const std::string rain = R"(kind = "rain"
count = 5
mass_rate = "1 g/s"
region = { min = ["1 mm", "1 mm", "1 mm"], max = ["4 mm", "4 mm", "4 mm"] })";
  expect_refused(with(with(box, "kind = \"dense\"", rain), "solid_fraction = 0.62", ""), {"cannot rain"});
  expect_refused(
      box + "[measures.region]\nmin = [\"0 mm\", \"0 mm\", \"0 mm\"]\nmax = [\"5 mm\", \"5 mm\", \"5 mm\"]\n",
      {"measured as a whole"});
}

TEST(DenseSource, NeedsAPeriodicDomainForItself) {
  const std::string at_rest = with(box, R"(shear = { rate = "20 1/s", flow = "y", gradient = "x" })", "");
  expect_refused(with(at_rest, R"(["x", "y", "z"])", R"(["x", "y"])"),
                 {"sources.beads needs", "periodic all around"});
  expect_refused(with(at_rest, "[sources.beads]", R"([sources.more]
kind = "dense"
solid_fraction = 0.1

[sources.beads])"),
                 {"there are other sources"});
  expect_refused(with(at_rest, "solid_fraction = 0.62", "solid_fraction = 0.8"),
                 {"sources.beads.solid_fraction"});
}

}  // namespace
