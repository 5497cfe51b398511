// SPDX-License-Identifier: Apache-2.0
// One case from its file to its results, through the program.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;

namespace {

/// Run once for all tests that only look at it.
const RunOfCase& road() {
  static const RunOfCase run(small_die);
  return run;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

TEST(WholeRoad, EndsWithZeroAndSaysWhereTheResultsAre) {
  ASSERT_EQ(road().exit(), 0) << road().outcome().err;
  const std::string& out = road().outcome().out;
  for (const char* file : {"result.json", "log.csv", "parcels.pvd", "walls.pvd", "porosity.pvd"})
    EXPECT_TRUE(has(out, road().out(file))) << file << " is not named in\n" << out;
  EXPECT_TRUE(has(out, "24 mg asked for, difference"));
  EXPECT_FALSE(has(out, "picture")) << "the case asks for none";
}

TEST(WholeRoad, ResultHasEveryPromisedKeyInItsType) {
  const Json r = road().result();
  EXPECT_EQ(r.at("exit"), 0);
  EXPECT_TRUE(r.at("exit").is_number_integer());
  EXPECT_EQ(r.at("exit_reason"), "completed");
  for (const char* key : {"steps", "threads", "threads_used", "particles"})
    EXPECT_TRUE(r.at(key).is_number_unsigned()) << key;
  for (const char* key : {"simulated_time_s", "wall_time_s", "particle_steps_per_s"}) {
    EXPECT_TRUE(r.at(key).is_number_float()) << key;
    EXPECT_GT(r.at(key), 0.0) << key;
  }
  EXPECT_EQ(r.at("threads"), 1);
  const std::string hash = r.at("state_hash");
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos) << hash;
  EXPECT_NEAR(r.at("simulated_time_s"), r.at("steps").get<double>() * r.at("time_step_s").get<double>(),
              1e-12);
  EXPECT_TRUE(r.at("escapes").is_array());
  EXPECT_TRUE(r.at("warnings").is_array());
}

double sum_of(const Json& times) {
  double sum = 0.0;
  for (const auto& [task, seconds] : times.items()) sum += seconds.get<double>();
  return sum;
}

TEST(WholeRoad, TimesByTaskAddUpToAllTimeAndNameWhatTookSome) {
  const auto start = std::chrono::steady_clock::now();
  const RunOfCase run(small_die);
  const std::chrono::duration<double> outside = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  const Json r = run.result(), &times = r.at("time_table_s");
  EXPECT_NEAR(sum_of(times), r.at("wall_time_s").get<double>(), 1e-9);
  EXPECT_LT(r.at("wall_time_s").get<double>(), outside.count()) << "no time is booked twice";
  for (const auto& [task, seconds] : times.items()) EXPECT_GE(seconds.get<double>(), 0.0) << task;
  for (const char* task : {"preparation", "insertion", "bodies", "near_lists", "walls", "pairs", "guards",
                           "measures", "files", "checkpoints"}) {
    EXPECT_GT(times.at(task).get<double>(), 0.0) << task;
    EXPECT_TRUE(has(run.outcome().out, std::string("\n  ") + task + " ")) << run.outcome().out;
  }
  for (const char* task : {"pictures", "energy_ledger", "leaving"}) {
    EXPECT_EQ(times.at(task).get<double>(), 0.0) << task << ": the case has none";
    EXPECT_FALSE(has(run.outcome().out, std::string("\n  ") + task + " ")) << run.outcome().out;
  }
  const double steps = sum_of(times) - times.at("preparation").get<double>() -
                       times.at("measures").get<double>() - times.at("files").get<double>() -
                       times.at("checkpoints").get<double>() - times.at("rest").get<double>();
  EXPECT_NEAR(steps, r.at("stepping_time_s").get<double>(), 1e-9);
}

TEST(WholeRoad, LedgerBalancesInCountsAndMass) {
  const Json r = road().result(), &count = r.at("ledger"), &mass = r.at("ledger_mass");
  for (const char* key : {"inserted", "present", "removed", "escaped"}) {
    EXPECT_TRUE(count.at(key).is_number_unsigned()) << key;
    EXPECT_TRUE(mass.at(key).is_number_float()) << key;
  }
  EXPECT_GT(count.at("inserted"), 130u);
  EXPECT_EQ(count.at("inserted"), count.at("present"));
  EXPECT_EQ(count.at("present"), r.at("particles"));
  EXPECT_EQ(count.at("escaped"), 0u);
  EXPECT_EQ(count.at("removed"), 0u);
  EXPECT_NEAR(mass.at("inserted").get<double>(), mass.at("present").get<double>(), 1e-15 * 24e-6 * 145);
  const double smallest = 2500.0 * M_PI / 6.0 * std::pow(450e-6, 3);
  EXPECT_NEAR(mass.at("inserted").get<double>(), 24e-6, 0.5 * smallest) << "the mass asked for";
}

TEST(WholeRoad, PhasesFollowOneAnother) {
  const Json r = road().result();
  const Json& phases = r.at("phases");
  ASSERT_EQ(phases.size(), 4u);
  const char* names[] = {"fill", "settle", "shake", "measure"};
  double start = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(phases[k].at("name"), names[k]);
    EXPECT_EQ(phases[k].at("start_s"), start);
    EXPECT_GT(phases[k].at("end_s"), start);
    start = phases[k].at("end_s");
  }
  EXPECT_EQ(start, r.at("simulated_time_s"));
  EXPECT_EQ(phases[0].at("ended_by"), "inserted");
  EXPECT_EQ(phases[2].at("ended_by"), "cycles");
  EXPECT_NEAR(phases[2].at("end_s").get<double>() - phases[2].at("start_s").get<double>(), 0.02, 5e-6);
  EXPECT_EQ(phases[3].at("ended_by"), "time");
  EXPECT_NEAR(phases[3].at("end_s").get<double>() - phases[3].at("start_s").get<double>(), 0.01, 5e-6);
}

TEST(WholeRoad, MeasuresStandBesideTheirUnitsAndWindows) {
  const Json r = road().result();
  for (const Json& phase : r.at("phases")) {
    for (const auto& [name, measure] : phase.at("measures").items()) {
      EXPECT_TRUE(measure.at("value").is_number_float()) << name;
      EXPECT_FALSE(measure.at("unit").get<std::string>().empty()) << name;
      EXPECT_FALSE(measure.at("window").get<std::string>().empty()) << name;
    }
  }
  const Json& last = r.at("measures");
  EXPECT_EQ(last, r.at("phases").back().at("measures"));
  EXPECT_EQ(last.at("fill_mass").at("unit"), "kg");
  EXPECT_EQ(last.at("porosity_mean").at("unit"), "1");
  EXPECT_EQ(last.at("porosity_std").at("unit"), "1");
  EXPECT_EQ(last.at("coordination_mean").at("unit"), "1");
}

TEST(WholeRoad, MeasuresAreThoseOfAPowderBed) {
  const Json r = road().result();
  const auto value = [&](const char* name) { return r.at("measures").at(name).at("value").get<double>(); };
  EXPECT_NEAR(value("fill_mass"), r.at("ledger_mass").at("present").get<double>(), 1e-12)
      << "all is in the die";
  EXPECT_GT(value("porosity_mean"), 0.3);
  EXPECT_LT(value("porosity_mean"), 0.9);
  EXPECT_GE(value("porosity_std"), 0.0);
  EXPECT_LT(value("porosity_std"), 0.3);
  EXPECT_GT(value("coordination_mean"), 1.5);
  EXPECT_LT(value("coordination_mean"), 7.0);
  // The bed lies as high as its mass at its porosity must.
  const double height = value("fill_mass") / 2500.0 / (1.0 - value("porosity_mean")) / (3e-3 * 3e-3);
  EXPECT_NEAR(value("free_surface_height_mean"), height, 0.25 * height);
}

TEST(WholeRoad, CaseIsKeptAsItWas) {
  EXPECT_EQ(text_of(road().out("case.toml")), small_die);
  EXPECT_EQ(text_of(road().out("case.toml")), text_of(road().case_file()));
}

TEST(WholeRoad, RunJsonTellsWhereEveryValueComesFrom) {
  const RunOfCase run(small_die, {"--threads", "1", "--set", "phases.shake.cycles=0.1", "--set", "seed=5"});
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  const Json json = json_of(run.out("run.json")), &keys = json.at("keys");
  EXPECT_FALSE(json.at("version").get<std::string>().empty());
  EXPECT_EQ(json.at("case"), run.case_file());
  EXPECT_EQ(keys.at("seed").at("value"), "5");
  EXPECT_EQ(keys.at("seed").at("origin"), "--set seed");
  EXPECT_EQ(keys.at("time.fraction").at("origin"), run.case_file() + ":83");
  EXPECT_EQ(keys.at("measures.cell_diameters").at("value"), "3");
  EXPECT_EQ(keys.at("measures.cell_diameters").at("origin"), "default");
  EXPECT_EQ(keys.at("materials.glass.density").at("value"), "\"2.5 g/cm^3\"");
  EXPECT_EQ(text_of(run.out("case.toml")), small_die) << "overrides stand in run.json, not in the copy";
  const Json& limits = json.at("time_step_limits");
  ASSERT_GE(limits.size(), 4u);
  for (std::size_t k = 1; k < limits.size(); ++k)
    EXPECT_LE(limits[k - 1].at("time_s"), limits[k].at("time_s")) << "the smallest first";
  EXPECT_DOUBLE_EQ(json.at("time_step_s"), limits[0].at("time_s")) << "time.fraction is 1";
  EXPECT_EQ(json.at("time_step_s"), run.result().at("time_step_s"));
}

TEST(WholeRoad, LogGrowsInTimeThroughAllPhases) {
  const Json r = road().result();
  const auto lines = lines_of(text_of(road().out("log.csv")));
  ASSERT_GT(lines.size(), 40u);
  EXPECT_EQ(lines[0],
            "step,time_s,phase,parcels,pair_contacts,wall_contacts,kinetic_energy_J,largest_speed_m_s,"
            "largest_overlap_over_radius,highest_point_m,inserted_mass_kg,escaped");
  double time = -1.0, mass = 0.0, most_overlap = 0.0;
  std::vector<std::string> phases;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const auto cells = cells_of(lines[k]);
    ASSERT_EQ(cells.size(), 12u) << lines[k];
    EXPECT_NEAR(std::stod(cells[1]), std::stod(cells[0]) * r.at("time_step_s").get<double>(), 1e-12);
    EXPECT_GT(std::stod(cells[1]), time) << lines[k];
    EXPECT_LT(std::stod(cells[1]) - time, 2.1e-3 + (k == 1)) << "a line every 2 ms at least";
    time = std::stod(cells[1]);
    if (phases.empty() || phases.back() != cells[2]) phases.push_back(cells[2]);
    EXPECT_GE(std::stod(cells[10]), mass);
    mass = std::stod(cells[10]);
    most_overlap = std::max(most_overlap, std::stod(cells[8]));
  }
  EXPECT_EQ(phases, (std::vector<std::string>{"fill", "settle", "shake", "measure"}));
  EXPECT_EQ(time, r.at("simulated_time_s"));
  EXPECT_EQ(mass, r.at("ledger_mass").at("inserted"));
  EXPECT_EQ(most_overlap, r.at("largest_overlap_over_radius"));
  EXPECT_EQ(cells_of(lines.back())[3], std::to_string(r.at("particles").get<int>()));
}

TEST(WholeRoad, SeriesOpenInVtk) {
  EXPECT_TRUE(vtk_reads_all_of(road().out()));
  const Json r = road().result();
  const Json parcels = open_series(road().out("parcels.pvd"));
  // One at the start, one every 20 ms, one at the end of each phase.
  ASSERT_GE(parcels.size(), 8u);
  std::set<double> times;
  for (const Json& frame : parcels) times.insert(frame.at("time").get<double>());
  EXPECT_EQ(times.size(), parcels.size()) << "no time twice";
  EXPECT_EQ(*times.begin(), 0.0);
  for (const Json& phase : r.at("phases")) EXPECT_TRUE(times.contains(phase.at("end_s").get<double>()));
  EXPECT_EQ(parcels.front().at("points"), 0);
  const Json& last = parcels.back();
  EXPECT_EQ(last.at("time"), r.at("simulated_time_s"));
  EXPECT_EQ(last.at("points"), r.at("particles"));
  for (const char* name : {"id", "type", "radius", "velocity", "omega", "force", "coordination"}) {
    const auto& names = last.at("point_arrays");
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
  const std::set<int> ids = last.at("id");
  EXPECT_EQ(ids.size(), r.at("particles").get<std::size_t>());
  double mass = 0.0;
  for (const double radius : last.at("radius")) {
    EXPECT_GE(radius, 225e-6 * (1 - 1e-6));
    EXPECT_LE(radius, 275e-6 * (1 + 1e-6));
    mass += 2500.0 * 4.0 / 3.0 * M_PI * std::pow(radius, 3);
  }
  EXPECT_NEAR(mass, r.at("ledger_mass").at("present").get<double>(), 1e-5 * mass);

  const Json walls = open_series(road().out("walls.pvd"));
  ASSERT_EQ(walls.size(), parcels.size());
  for (const Json& frame : walls) EXPECT_EQ(frame.at("cells"), 10) << "five rectangles";
}

TEST(WholeRoad, PorosityMapGivesTheMeanAndSpreadOfTheResult) {
  const Json r = road().result();
  const Json series = open_series(road().out("porosity.pvd"));
  ASSERT_GE(series.size(), 4u);
  const Json& map = series.back();
  EXPECT_EQ(map.at("time"), r.at("simulated_time_s"));
  double volume = 0.0, sum = 0.0, squares = 0.0;
  for (const int pass : {0, 1})
    for (std::size_t k = 0; k < map.at("porosity").size(); ++k) {
      if (map.at("porosity")[k].is_null()) continue;  // a cell left out
      const double counted = map.at("counted_volume")[k], porosity = map.at("porosity")[k];
      if (pass == 0)
        volume += counted, sum += counted * porosity;
      else
        squares += counted * std::pow(porosity - sum / volume, 2);
    }
  EXPECT_NEAR(sum / volume, r.at("measures").at("porosity_mean").at("value").get<double>(), 1e-9);
  EXPECT_NEAR(std::sqrt(squares / volume), r.at("measures").at("porosity_std").at("value").get<double>(),
              1e-9);
}

TEST(WholeRoad, PictureIsAPngAndChangesNoBitOfTheResult) {
  // Until nothing moves would be a waste here: a short fall is enough to draw.
  const std::string text = with(thrown(R"(["0 m/s", "0 m/s", "0 m/s"])", 12), "20 ms", "2 ms");
  const RunOfCase drawn(with(text, "picture = false", "picture = true"), {"--threads", "2"}), plain(text);
  ASSERT_EQ(drawn.exit(), 0) << drawn.outcome().err;
  ASSERT_EQ(plain.exit(), 0) << plain.outcome().err;
  const std::string picture = text_of(drawn.out("picture.png"));
  EXPECT_EQ(picture.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(picture.substr(picture.size() - 8, 4), "IEND");
  EXPECT_GT(picture.size(), 10000u) << "there is something to see";
  EXPECT_TRUE(has(drawn.outcome().out, "picture.png"));
  EXPECT_GT(drawn.result().at("time_table_s").at("pictures").get<double>(), 0.0);
  EXPECT_FALSE(std::filesystem::exists(plain.out("picture.png")));
  EXPECT_EQ(drawn.result().at("state_hash"), plain.result().at("state_hash"));
  EXPECT_EQ(drawn.result().at("threads"), 2);
  EXPECT_EQ(drawn.result().at("threads_used"), 1) << "a dozen parcels keep one busy";
}

TEST(WholeRoad, EachPhaseBeforeTheLastHasAPictureOfItsOwn) {
  const std::string next = "[[phases]]\nname = \"land\"\nuntil = \"time\"\nduration = \"1 ms\"\n\n[time]";
  const std::string text = with(thrown(R"(["0 m/s", "0 m/s", "0 m/s"])"), "20 ms", "1 ms");
  const RunOfCase run(with(with(text, "[time]", next), "picture = false", "picture = true"));
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  for (const char* name : {"pictures/after-fly.png", "picture.png"})
    EXPECT_EQ(text_of(run.out(name)).substr(1, 3), "PNG") << name;
  EXPECT_TRUE(has(run.outcome().out, "pictures/after-*.png")) << run.outcome().out;
  EXPECT_FALSE(std::filesystem::exists(run.out("pictures/after-land.png"))) << "it would be drawn twice";
}

TEST(WholeRoad, OverlapWithWallsCountsToo) {
  // One parcel falls onto the floor: there is nothing else to overlap with.
  const RunOfCase run(thrown(R"(["0 m/s", "0 m/s", "-1 m/s"])", 1),
                      {"--threads", "1", "--set", "output.log_interval=\"5 us\""});
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  const double overlap = run.result().at("largest_overlap_over_radius");
  EXPECT_GT(overlap, 0.01);
  EXPECT_LT(overlap, 0.5);
}

}  // namespace
