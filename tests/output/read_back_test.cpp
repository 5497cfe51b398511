// SPDX-License-Identifier: Apache-2.0
// What VTK's own readers find in the files; see read_back.py.
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "failures.hpp"
#include "output/vtk.hpp"
#include "output/vtk_series.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;
using nlohmann::json;

// Runs the script; its messages go to `log`.
int read_back(const ScratchFolder& folder, const json& expected, std::string& log) {
  const auto expectations = folder.path() + ".expected.json", output = folder.path() + ".log";
  put(expectations, expected.dump());
  const auto command = std::string("/usr/bin/python3 " PULVIS_READ_BACK " '") + folder.path() + "' '" +
                       expectations + "' >'" + output + "' 2>&1";
  const int status = std::system(command.c_str());
  log = content_of(output);
  std::filesystem::remove(expectations);
  std::filesystem::remove(output);
  return status;
}

bool vtk_is_installed() {
  return std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOXML' >/dev/null 2>&1") == 0;
}

json numbers(const std::vector<Vec3>& vectors) {
  json values = json::array();
  for (const Vec3& v : vectors) values.insert(values.end(), {v.x, v.y, v.z});
  return values;
}

class ReadBack : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!vtk_is_installed()) GTEST_SKIP() << "python3-vtk9 is not installed";
  }
  void expect_readable(const json& expected) {
    std::string log;
    EXPECT_EQ(read_back(folder_, expected, log), 0) << log;
  }
  ScratchFolder folder_;
};

TEST_F(ReadBack, FindsParcelsWithAllTheirFields) {
  const std::vector<Vec3> points{{1e-6, 0.1, 1.0 / 3.0}, {-4.6e-6, 2, 3}, {4, 5, 6}};
  const std::vector<Vec3> velocity{{0.1, -0.2, 0.3}, {1e-9, 0, 0}, {7, 8, 9}};
  const std::vector<std::int64_t> id{5'000'000'000, 1, 2};
  const std::vector<double> radius{2.3e-6, 1e-30, 0.5}, exact{1.0 / 3.0, 0.1, 0.2};
  const std::vector<std::uint32_t> coordination{0, 6, 4'000'000'000u};
  const std::vector<std::int32_t> material{-1, 0, 1};
  const std::vector<double> pairs{1, 2, 3, 4, 5, 6};
  const std::vector<Field> fields{{"id", std::span(id)},
                                  {"radius", std::span(radius)},
                                  {"velocity", std::span(velocity)},
                                  {"coordination", std::span(coordination)},
                                  {"material", std::span(material)},
                                  {"pairs", std::span(pairs), 2},
                                  {"exact", std::span(exact), 1, Stored::double_precision}};
  write_points_vtp(folder_.file("p.vtp"), points, fields, 0.1);
  json positions = json::array();
  for (const Vec3& p : points) positions.push_back({p.x, p.y, p.z});
  expect_readable({{"p.vtp",
                    {{"points", 3},
                     {"cells", 3},
                     {"cell_size", 1},
                     {"time", 0.1},
                     {"positions", positions},
                     {"point_data",
                      {{"id", {{"type", "long long"}, {"values", id}}},
                       {"radius", {{"type", "float"}, {"values", radius}}},
                       {"velocity", {{"type", "float"}, {"values", numbers(velocity)}}},
                       {"coordination", {{"type", "unsigned int"}, {"values", coordination}}},
                       {"material", {{"type", "int"}, {"values", material}}},
                       {"pairs", {{"type", "float"}, {"values", pairs}}},
                       {"exact", {{"type", "double"}, {"values", exact}}}}}}}});
}

TEST_F(ReadBack, FindsNoParcelsBeforeThePowderComes) {
  const std::vector<Field> fields{{"id", std::span<const std::int64_t>()},
                                  {"velocity", std::span<const Vec3>()}};
  write_points_vtp(folder_.file("p.vtp"), {}, fields, 0.0);
  expect_readable({{"p.vtp", {{"points", 0}, {"cells", 0}, {"time", 0.0}}}});
}

// Blocks hold 2^18 bytes: 32768 doubles fill one exactly, one more starts the next; positions fill three.
TEST_F(ReadBack, FindsArraysOfSeveralBlocks) {
  json expected;
  for (const std::size_t count : {32767u, 32768u, 32769u, 100'000u}) {
    std::vector<Vec3> points(count);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = std::sin(static_cast<double>(i));
      points[i] = {static_cast<double>(i), values[i], 1.0 / static_cast<double>(i + 1)};
    }
    const std::vector<Field> fields{{"value", std::span(values), 1, Stored::double_precision},
                                    {"velocity", std::span(points)}};
    const auto name = std::to_string(count) + ".vtp";
    write_points_vtp(folder_.file(name), points, fields, 0.0);
    json positions = json::array();
    for (const Vec3& p : points) positions.push_back({p.x, p.y, p.z});
    expected[name] = {{"points", count},
                      {"cells", count},
                      {"positions", positions},
                      {"point_data",
                       {{"value", {{"type", "double"}, {"values", values}}},
                        {"velocity", {{"type", "float"}, {"values", numbers(points)}}}}}};
  }
  expect_readable(expected);
}

TEST_F(ReadBack, FindsWallsAsTriangles) {
  const SurfaceMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const std::vector<std::int32_t> wall{3, 4};
  const std::vector<Field> fields{{"wall", std::span(wall)}};
  write_surface_vtp(folder_.file("w.vtp"), mesh, fields, 0.25);
  expect_readable({{"w.vtp",
                    {{"points", 4},
                     {"cells", 2},
                     {"cell_size", 3},
                     {"time", 0.25},
                     {"connectivity", {0, 1, 2, 0, 2, 3}},
                     {"cell_data", {{"wall", {{"type", "int"}, {"values", wall}}}}}}}});
}

TEST_F(ReadBack, FindsAGridWithCellsLeftOut) {
  const Grid grid{{-0.1, 0.2, 0.3}, {1e-3, 2e-3, 1.0 / 3.0}, {2, 3, 1}};
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> porosity{0.1, 0.2, none, 0.4, 0.5, 0.6};
  const std::vector<Field> fields{{"porosity", std::span(porosity)}};
  write_grid_vti(folder_.file("g.vti"), grid, fields, 1e-9);
  expect_readable(
      {{"g.vti",
        {{"points", 3 * 4 * 2},
         {"cells", 6},
         {"time", 1e-9},
         {"extent", {0, 2, 0, 3, 0, 1}},
         {"origin", {-0.1, 0.2, 0.3}},
         {"spacing", {1e-3, 2e-3, 1.0 / 3.0}},
         {"cell_data",
          {{"porosity", {{"type", "float"}, {"values", {0.1, 0.2, nullptr, 0.4, 0.5, 0.6}}}}}}}}});
}

TEST_F(ReadBack, FindsTheFramesOfASeries) {
  VtkSeries series(folder_.file("parcels.pvd"));
  std::filesystem::create_directory(folder_.file("frames"));
  const std::vector<Vec3> points{{0, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    const auto name = "frames/p_" + std::to_string(i) + ".vtp";
    write_points_vtp(folder_.file(name), points, {}, 0.1 * i);
    series.add(0.1 * i, name);
  }
  expect_readable(json::object());
}

// The check itself has to be able to fail.
TEST_F(ReadBack, NoticesWrongValuesDamageAndMissingFrames) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 3}};
  const std::vector<double> radius{0.5, 0.25};
  const std::vector<Field> fields{{"radius", std::span(radius)}};
  write_points_vtp(folder_.file("p.vtp"), points, fields, 0.0);
  std::string log;
  const auto wrong = [](const char* key, json value) { return json{{"p.vtp", {{key, std::move(value)}}}}; };
  EXPECT_NE(read_back(folder_, wrong("points", 3), log), 0) << log;
  EXPECT_NE(read_back(folder_,
                      wrong("point_data", {{"radius", {{"type", "float"}, {"values", {0.5, 0.26}}}}}), log),
            0)
      << log;
  EXPECT_NE(read_back(folder_, {{"other.vtp", json::object()}}, log), 0) << log;

  const auto whole = content_of(folder_.file("p.vtp"));
  auto damaged = whole;
  damaged[damaged.find("\n_") + 2] = '\x09';  // nine blocks instead of one
  put(folder_.file("p.vtp"), damaged);
  EXPECT_NE(read_back(folder_, json::object(), log), 0) << log;

  put(folder_.file("p.vtp"), whole);
  VtkSeries(folder_.file("a.pvd")).add(0.0, "missing.vtp");
  EXPECT_NE(read_back(folder_, json::object(), log), 0) << log;
}

}  // namespace
}  // namespace pulvis
