// SPDX-License-Identifier: Apache-2.0
#include "output/html_page.hpp"

#include <gtest/gtest.h>

#include "output/png_file.hpp"
#include "tests/output/scratch_folder.hpp"

using namespace pulvis;

namespace {

std::string png_bytes() {
  const test::ScratchFolder scratch;
  write_png(scratch.file("a.png"), Image(12, 7, {1.0f, 0.0f, 0.0f}));
  return test::content_of(scratch.file("a.png"));
}

TEST(HtmlPage, LinksItsHeadings) {
  HtmlPage page("title");
  page.paragraph("first");
  page.contents();
  page.heading("A & B");
  page.heading("below", 3);
  const std::string text = page.text();
  EXPECT_NE(text.find("<p>first</p>\n<nav>"), std::string::npos);
  EXPECT_NE(text.find("<a href=\"#section-1\">A &amp; B</a>"), std::string::npos);
  EXPECT_NE(text.find("<h2 id=\"section-1\">A &amp; B</h2>"), std::string::npos);
  EXPECT_EQ(text.find("section-2"), std::string::npos);
}

TEST(HtmlPage, PutsColumnsOfNumbersToTheRight) {
  HtmlPage page("title");
  page.table({"a", "b"}, {{{"1", "2"}}, {{"-", "words"}}});
  EXPECT_NE(page.text().find("<td class=\"number\">1</td><td>2</td>"), std::string::npos);
  EXPECT_NE(page.text().find("<thead>"), std::string::npos);
}

TEST(HtmlPage, LeavesOutAHeaderWithoutWords) {
  HtmlPage page("title");
  page.table({"", ""}, {{{"a", "b"}}});
  EXPECT_EQ(page.text().find("<thead>"), std::string::npos);
}

TEST(HtmlPage, HoldsPngImagesWithTheirSize) {
  const auto image = png_image(png_bytes(), "red", "a caption");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 12);
  EXPECT_EQ(image->height, 7);
  EXPECT_TRUE(image->source.starts_with("data:image/png;base64,iVBORw0KGgo"));
  HtmlPage page("title");
  page.images({*image, {"", 0, 0, "", "missing"}});
  EXPECT_NE(page.text().find("width=\"12\" height=\"7\""), std::string::npos);
  EXPECT_NE(page.text().find("<figure><figcaption>missing"), std::string::npos);
}

TEST(HtmlPage, RefusesPngImagesThatAreNotWhole) {
  const std::string bytes = png_bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(png_image(bytes.substr(0, size), "red"));
  EXPECT_FALSE(png_image("x" + bytes.substr(1), "red"));
}

TEST(HtmlPage, KnowsTheSizeOfSvgImages) {
  const PageImage image =
      svg_image("<svg width=\"720\" height=\"440\" viewBox=\"0 0 1 1\"></svg>", "a curve");
  EXPECT_EQ(image.width, 720);
  EXPECT_EQ(image.height, 440);
  EXPECT_EQ(svg_image("no image", "").width, 0);
}

}  // namespace
