// SPDX-License-Identifier: Apache-2.0
// What a run leaves of its measures: measures.csv, measures/after-PHASE.json, fields for ParaView.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

const std::string with_places = with(small_die, "[output]", R"([measures]
interval = "5 ms"

[measures.parts.corner]
min = ["0 mm", "0 mm", "0 mm"]
max = ["1.5 mm", "1.5 mm", "2 mm"]

[measures.surfaces.mouth]
point = ["1.5 mm", "1.5 mm", "4 mm"]
normal = [0, 0, -1]

[measures.surfaces.far_disc]
point = ["3.5 mm", "3.5 mm", "4 mm"]
normal = [0, 0, -1]
radius = "0.1 mm"

[output])");

const RunOfCase& measured_run() {
  static const RunOfCase run(with_places);
  EXPECT_EQ(run.exit(), 0) << run.outcome().err;
  return run;
}

Json after(const std::string& phase) {
  return json_of(measured_run().out("measures/after-" + phase + ".json"));
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char letter : line)
    if (letter == ',')
      cells.emplace_back();
    else
      cells.back() += letter;
  return cells;
}

/// measures.csv by columns.
std::map<std::string, std::vector<std::string>> series() {
  const auto lines = lines_of(text_of(measured_run().out("measures.csv")));
  const auto names = cells_of(lines.at(0));
  std::map<std::string, std::vector<std::string>> columns;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const auto cells = cells_of(lines[k]);
    EXPECT_EQ(cells.size(), names.size());
    for (std::size_t c = 0; c < names.size(); ++c) columns[names[c]].push_back(cells.at(c));
  }
  return columns;
}

TEST(MeasuresOfARun, StandInAFileForEachPhaseAndAgreeWithResultJson) {
  const Json result = measured_run().result();
  for (const Json& phase : result.at("phases")) {
    const Json measures = after(phase.at("name"));
    EXPECT_EQ(measures.at("format"), "pulvis measures");
    EXPECT_EQ(measures.at("version"), 1);
    EXPECT_EQ(measures.at("time_s"), phase.at("end_s"));
    EXPECT_EQ(measures.at("scalars"), phase.at("measures"));
  }
}

TEST(MeasuresOfARun, SayTheSameInEachForm) {
  const Json m = after("measure");
  const double mass = m["scalars"]["fill_mass"]["value"], mean = m["scalars"]["porosity_mean"]["value"];
  double solid = 0.0, volume = 0.0;
  for (std::size_t k = 0; k < m["porosity"]["values"].size(); ++k) {
    const double v = m["porosity"]["volume_m3"][k];
    if (v > 0.0) solid += v * (1.0 - m["porosity"]["values"][k].get<double>());
    volume += v;
  }
  EXPECT_NEAR(1.0 - solid / volume, mean, 1e-12);
  for (const Json& profile : m["porosity_profiles"]) {
    double sum = 0.0;
    for (const double v : profile["volume_m3"]) sum += v;
    EXPECT_NEAR(sum, volume, 1e-12 * volume);
  }
  double shares = 0.0;
  for (const double share : m["porosity_histogram"]["share"]) shares += share;
  EXPECT_NEAR(shares, 1.0, 1e-12);
  // Both lower and upper halves hold all of the powder below the surface.
  double halves = 0.0;
  for (int k : {0, 1}) halves += m["parts"][k]["mass_kg"].get<double>();
  EXPECT_NEAR(halves, mass, 0.05 * mass);  // what sticks out above the surface's columns is in no half
  EXPECT_EQ(m["parts"].size(), 7u);
  EXPECT_EQ(m["parts"][6]["name"], "corner");
  std::size_t parcels = 0;
  for (const std::size_t count : m["coordination"]["count"]) parcels += count;
  EXPECT_EQ(parcels, m["scalars"]["fill_count"]["value"]);
}

TEST(MeasuresOfARun, BearTheWeightOfThePowder) {
  const Json m = after("measure");
  const Json& layers = m["layers"];
  const double floor = 9e-6;  // m^2
  // Mean vertical stress of the lowest layer: at most the weight over the floor, walls bear the rest.
  const double weight = 9.81 * m["scalars"]["fill_mass"]["value"].get<double>() / floor;
  const double vertical = layers["stress_Pa"][0][2][2];
  EXPECT_GT(vertical, 0.3 * weight);
  EXPECT_LT(vertical, 1.1 * weight);
  double mass = 0.0;
  const double thickness = 4e-3 / static_cast<double>(layers["density_kg_m3"].size());
  for (const double density : layers["density_kg_m3"]) mass += density * thickness * floor;
  EXPECT_NEAR(mass, m["scalars"]["fill_mass"]["value"], 1e-9);
}

TEST(MeasuresOfARun, CountWhatFlowsThroughASurface) {
  double through = 0.0;
  const Json result = measured_run().result();
  for (const Json& phase : result.at("phases")) {
    const Json flow = after(phase.at("name")).at("flow");
    ASSERT_EQ(flow.size(), 2u);
    const Json& m = phase.at("measures");
    if (phase.at("name") == "fill") {  // it is still raining through the mouth: what has passed lies below
      EXPECT_NEAR(flow[0]["mass_kg"].get<double>(), m["fill_mass"]["value"].get<double>(), 1e-15);
    }
    EXPECT_EQ(flow[0]["surface"], "mouth");
    through += flow[0]["mass_kg"].get<double>();
    EXPECT_EQ(flow[1]["count"], 0) << "nothing falls beside the die";
  }
  // All that was inserted above the mouth lies below it in the end (the die is shaken back to its place).
  const double inserted = result.at("ledger_mass").at("inserted");
  EXPECT_NEAR(through, inserted, 1e-12 * inserted);
  const auto columns = series();
  double integral = 0.0, before = 0.0;
  for (std::size_t k = 0; k < columns.at("time_s").size(); ++k) {
    const double time = std::stod(columns.at("time_s")[k]);
    integral += (time - before) * std::stod(columns.at("flow_mouth_kg_s")[k]);
    before = time;
  }
  EXPECT_NEAR(integral, inserted, 1e-9 * inserted);
}

TEST(MeasuresOfARun, AreASeriesWithoutGapsThatEndsAsTheResultDoes) {
  const auto columns = series();
  const Json measures = measured_run().result().at("measures");
  EXPECT_EQ(std::stod(columns.at("porosity_mean").back()), measures["porosity_mean"]["value"].get<double>());
  EXPECT_EQ(std::stod(columns.at("apparent_density_kg_m3").back()),
            measures["apparent_density"]["value"].get<double>());
  const auto& times = columns.at("time_s");
  for (std::size_t k = 1; k < times.size(); ++k) {
    EXPECT_GT(std::stod(times[k]), std::stod(times[k - 1]));
    EXPECT_LT(std::stod(times[k]) - std::stod(times[k - 1]), 5.1e-3);
  }
}

TEST(MeasuresOfARun, LeaveFieldsForParaViewAtTheEndOfEachPhase) {
  const std::string list = text_of(measured_run().out("fields.pvd"));
  for (const char* frame : {"fields-000000.vti", "fields-000003.vti"}) {
    EXPECT_TRUE(has(list, frame));
    EXPECT_TRUE(has(text_of(measured_run().out(std::string("frames/") + frame)), "contact_stress"));
  }
}

TEST(PageOfARun, IsMadeAtItsEndAndKnowsWhatIsAssumed) {
  const RunOfCase run(with(with(small_die, "report = false", "report = true"), "mass_rate = \"600 mg/s\"",
                           "mass_rate = \"600 mg/s\"  # ASSUMED: \"quick\" # as it comes"));
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  EXPECT_TRUE(has(run.outcome().out, "report.html")) << run.outcome().out;
  EXPECT_EQ(json_of(run.out("run.json"))["keys"]["sources.rain.mass_rate"]["comment"],
            "ASSUMED: \"quick\" # as it comes");
  const std::string page = text_of(run.out("report.html"));
  EXPECT_TRUE(has(page, "sources.rain.mass_rate")) << "assumed values are listed";
  EXPECT_TRUE(has(page, "A small die, filled and shaken"));
}

TEST(PageOfARun, GoesWithTheResultsThatForceReplaces) {
  const RunOfCase run(with(small_die, "report = false", "report = true"));
  ASSERT_TRUE(fs::exists(run.out("report.html")));
  const Outcome again =
      call({"run", run.case_file(), "--out", run.out(), "--force", "--set", "output.report=false"});
  ASSERT_EQ(again.exit, 0) << again.err;
  EXPECT_FALSE(fs::exists(run.out("report.html")));
  EXPECT_FALSE(fs::exists(run.out("report"))) << "nor its figures";
}

TEST(MeasuresOfARun, WithoutADieAreThoseOfTheParcelsAlone) {
  const RunOfCase run(
      with(with(thrown("[\"0 m/s\", \"0 m/s\", \"0 m/s\"]"), "shape = \"box\"", "shape = \"plane\""),
           R"(min = ["0 mm", "0 mm", "0 mm"]
max = ["3 mm", "3 mm", "4 mm"]
open = ["+z"]
)",
           R"(point = ["0 mm", "0 mm", "0 mm"]
normal = [0, 0, 1]
)"));
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  const Json m = json_of(run.out("measures/after-fly.json"));
  EXPECT_FALSE(m.contains("porosity"));
  EXPECT_TRUE(m["scalars"].contains("potential_energy"));
  EXPECT_FALSE(fs::exists(run.out("fields.pvd")));
}

}  // namespace
