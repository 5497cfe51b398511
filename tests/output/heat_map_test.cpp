// SPDX-License-Identifier: Apache-2.0
#include "output/heat_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace pulvis;

namespace {

std::size_t count(const std::string& text, const std::string& words) {
  std::size_t found = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
  return found;
}

HeatMap sample() {
  HeatMap map{"map", "It's a map", "porosity", {0.0, 1.0}, 2, {}};
  for (const char* title : {"first", "second", "third"})
    map.panels.push_back({title,
                          "x (mm)",
                          "y (mm)",
                          {0.0, 2.0},
                          {0.0, 1.0},
                          {{0.5, 0.5, 1.0, 1.0, 0.25}, {1.5, 0.5, 1.0, 1.0, std::nan("")}},
                          {{1.0, 0.5, "here"}},
                          {{1.0, 0.5, 2.0, 1.0, 0.0}}});
  return map;
}

TEST(HeatMap, HasAllItsPanelsAndOneColourBar) {
  const std::string svg = drawn_by_gnuplot(figure_script(sample()), "map");
  for (const char* words : {"It's a map", "first", "second", "third", "here", "porosity", "y (mm)"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  EXPECT_EQ(count(svg, ">porosity<"), 1u);
}

TEST(HeatMap, LeavesOutCellsWithoutAValue) {
  const std::string csv = figure_csv(sample());
  EXPECT_TRUE(csv.starts_with(
      "panel,x,y,width,height,\"porosity\"\n\"first: y (mm) over x (mm)\",0.5,0.5,1,1,0.25\n"));
  EXPECT_EQ(count(csv, "\n"), 4u);
}

TEST(HeatMap, ItsRangeHoldsAllValuesAndIsNeverEmpty) {
  HeatMap map = sample();
  map.panels[1].cells[1].value = 0.75;
  EXPECT_EQ(range_of_values(map.panels).low, 0.25);
  EXPECT_EQ(range_of_values(map.panels).high, 0.75);
  EXPECT_EQ(range_of_values({}).high, 1.0);
  const Range same = range_of_values(sample().panels);
  EXPECT_LT(same.low, 0.25);
  EXPECT_GT(same.high, 0.25);
}

TEST(HeatMap, DrawsPanelsWithoutAnyCell) {
  HeatMap map = sample();
  map.panels[0].cells.clear();
  EXPECT_NE(drawn_by_gnuplot(figure_script(map), "map").find("first"), std::string::npos);
}

TEST(FigureSheet, HasOneKeyForPanelsThatShareIt) {
  FigureSheet sheet{"sheet", "Three panels", {}, 3, 200, 150, true};
  for (const char* title : {"left", "middle", "right"})
    sheet.panels.push_back({"", title, "x", "y", {{"ours", {0, 1}, {0, 1}}, {"theirs", {0, 1}, {1, 0}}}});
  sheet.panels[0].marks.push_back({0.5, "shaking begins"});
  const std::string svg = drawn_by_gnuplot(figure_script(sheet), "sheet");
  EXPECT_EQ(count(svg, ">theirs<"), 1u);
  for (const char* words : {"left", "middle", "right", "shaking begins"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  sheet.common_key = false;
  EXPECT_EQ(count(drawn_by_gnuplot(figure_script(sheet), "sheet"), ">theirs<"), 3u);
  EXPECT_NE(figure_csv(sheet).find("\"middle\",\"theirs\",\"x\",1,\"y\",0\n"), std::string::npos);
}

}  // namespace
