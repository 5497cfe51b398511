// SPDX-License-Identifier: Apache-2.0
#include "meshes/stl_file.hpp"

#include <gtest/gtest.h>

#include <clocale>

#include "shapes.hpp"
#include "tests/output/failures.hpp"
#include "tests/output/scratch_folder.hpp"
#include "validation/draw.hpp"

namespace pulvis {
namespace {

using namespace test;

constexpr const char* one_facet =
    "facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 1 0\n endloop\nendfacet\n";

TriangleSoup read_text(const ScratchFolder& folder, const std::string& text) {
  put(folder.file("text.stl"), text);
  return read_stl(folder.file("text.stl"));
}

TEST(StlFile, ComesBackFromBinaryAsWrittenUpToRounding) {
  ScratchFolder folder;
  const auto written = cube_soup(7.0);
  write_stl(folder.file("a.stl"), written, StlForm::binary);
  EXPECT_EQ(std::filesystem::file_size(folder.file("a.stl")), 84u + 50u * 12u);
  EXPECT_FALSE(folder.has("a.stl.part"));
  const auto read = read_stl(folder.file("a.stl"));
  EXPECT_EQ(read.triangles, written.triangles);  // whole numbers are exact
  EXPECT_EQ(read.source, folder.file("a.stl"));
}

TEST(StlFile, ComesBackFromTextToTheLastBit) {
  ScratchFolder folder;
  validation::Draw draw(1);
  TriangleSoup written;
  for (int t = 0; t < 200; ++t)
    written.triangles.push_back(
        {draw.vector(1.0), draw.decades(1e-30, 1e30) * draw.direction(), draw.vector(1e-9)});
  write_stl(folder.file("a.stl"), written, StlForm::text);
  EXPECT_EQ(read_stl(folder.file("a.stl")).triangles, written.triangles);
}

TEST(StlFile, IsBinaryByItsSizeAlthoughItBeginsWithSolid) {
  ScratchFolder folder;
  write_stl(folder.file("a.stl"), cube_soup(), StlForm::binary);
  auto bytes = content_of(folder.file("a.stl"));
  bytes.replace(0, 12, "solid binary");
  put(folder.file("a.stl"), bytes);
  EXPECT_EQ(read_stl(folder.file("a.stl")).triangles.size(), 12u);
}

TEST(StlFile, ReadsKeywordsInEitherCaseAndAnyLineEnds) {
  ScratchFolder folder;
  const std::string text =
      "SOLID Part 7, solid facet\r\n  FACET NORMAL nan nan nan\r\nOuter Loop\rVERTEX +1.5E+0 -2e-1 .25\r\n"
      "vertex\t1. 0 -0\nvertex 1e-999 0 7 endloop endfacet\nEndSolid Part 7";
  const auto soup = read_text(folder, text);
  ASSERT_EQ(soup.triangles.size(), 1u);
  EXPECT_EQ(soup.triangles[0][0], (Vec3{1.5, -0.2, 0.25}));
  EXPECT_EQ(soup.triangles[0][1], (Vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(soup.triangles[0][2], (Vec3{0.0, 0.0, 7.0}));
}

TEST(StlFile, TakesSeveralSolidsAsOneAndAByteOrderMark) {
  ScratchFolder folder;
  const std::string block = std::string("solid\n") + one_facet + "endsolid\n";
  EXPECT_EQ(read_text(folder, "\xEF\xBB\xBF" + block + "\n\n" + block + block).triangles.size(), 3u);
}

TEST(StlFile, DoesNotCareForTheLocale) {
  ScratchFolder folder;
  const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed
  const auto soup = read_text(folder,
                              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.5 0 0\nvertex 1 0 0\n"
                              "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  if (german) std::setlocale(LC_ALL, "C");
  EXPECT_EQ(soup.triangles[0][0].x, 0.5);
}

TEST(StlFile, ReadsMillionsOfTrianglesInSeconds) {
  ScratchFolder folder;
  const auto mesh = sheet(1000, 1.0, [](double, double) { return 0.0; });
  TriangleSoup soup;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    soup.triangles.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  write_stl(folder.file("a.stl"), soup, StlForm::binary);
  EXPECT_EQ(read_stl(folder.file("a.stl")).triangles.size(), 2'000'000u);
}

TEST(StlFile, SaysWhyItCannotBeWritten) {
  ScratchFolder folder;
  const auto message =
      failure_of(Exit::io, [&] { write_stl(folder.file("none/a.stl"), cube_soup(), StlForm::text); });
  EXPECT_EQ(message, "cannot write " + folder.file("none/a.stl") +
                         ": No such file or directory; check that its folder exists and has room");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace pulvis
