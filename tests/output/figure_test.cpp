// SPDX-License-Identifier: Apache-2.0
#include "output/figure.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "engine/base/failure.hpp"
#include "output/html_page.hpp"

using namespace pulvis;

namespace {

Figure sample() {
  Figure f{"sample", "It's a title", "time (s)", "force (N)", {}, false, false};
  f.curves.push_back({"ours", {0, 1, 2}, {0, 1, 4}, false});
  f.curves.push_back({"mea\"sured", {0, 2}, {0.1, 3.9}, true});
  return f;
}

TEST(Figure, IsAnImageWithItsTitleLabelsAndCurves) {
  const std::string svg = figure_svg(sample());
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  for (const char* words : {"It's a title", "time (s)", "force (N)", "ours"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(Figure, ItsPointsReadBackAsTheSameNumbers) {
  EXPECT_EQ(
      figure_csv(sample()),
      "curve,\"time (s)\",\"force (N)\"\n\"ours\",0,0\n\"ours\",1,1\n\"ours\",2,4\n\"mea\"\"sured\",0,0.1\n"
      "\"mea\"\"sured\",2,3.9\n");
}

TEST(Figure, WithoutGnuplotSaysWhatToInstall) {
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  EXPECT_FALSE(can_draw_figures());
  try {
    figure_svg(sample());
    ADD_FAILURE() << "drawn without gnuplot";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::io);
    EXPECT_NE(std::string(failure.what()).find("gnuplot-nox"), std::string::npos);
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(can_draw_figures());
}

TEST(HtmlPage, EscapesTextAndAsksNothingOfTheNetwork) {
  HtmlPage page("a < b");
  page.paragraph("<script>alert(1)</script>");
  page.table({"name", "value"}, {{{"x & y", "1e-3"}, "bad"}});
  page.image(figure_svg(sample()), "a curve");
  const std::string text = page.text();
  EXPECT_EQ(text.find("<script"), std::string::npos);
  EXPECT_NE(text.find("x &amp; y"), std::string::npos);
  EXPECT_NE(text.find("<td class=\"number\">1e-3</td>"), std::string::npos);
  EXPECT_EQ(text.find("src=\"http"), std::string::npos);
  EXPECT_EQ(text.find("<link"), std::string::npos);
}

}  // namespace
