// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <limits>

#include "meshes/mending.hpp"
#include "meshes/stl_file.hpp"
#include "shapes.hpp"
#include "tests/output/failures.hpp"
#include "tests/output/scratch_folder.hpp"
#include "validation/draw.hpp"

namespace pulvis {
namespace {

using namespace test;

std::string facet_text(const std::string& third_vertex = "0 1 0") {
  return "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex " + third_vertex +
         "\n endloop\nendfacet\n";
}

std::string bytes_of_cube(StlForm form) {
  ScratchFolder folder;
  write_stl(folder.file("cube.stl"), cube_soup(), form);
  return content_of(folder.file("cube.stl"));
}

/// What is said about a file of this content, without its path.
std::string message_about(const std::string& content, std::uint64_t most = most_stl_triangles) {
  ScratchFolder folder;
  const std::string path = folder.file("die.stl");
  put(path, content);
  const std::string message = failure_of(Exit::bad_input, [&] { read_stl(path, most); });
  EXPECT_TRUE(message.starts_with(path)) << message;
  return message.substr(std::min(path.size(), message.size()));
}

std::string message_about_path(const std::string& path) {
  const std::string message = failure_of(Exit::bad_input, [&] { read_stl(path); });
  EXPECT_TRUE(message.starts_with(path)) << message;
  return message.substr(std::min(path.size(), message.size()));
}

TEST(StlBadInput, NoFileAFolderAndAPipeAreTold) {
  ScratchFolder folder;
  EXPECT_EQ(message_about_path(folder.file("no.stl")), ": error: there is no such file; check the path");
  EXPECT_EQ(message_about_path(folder.path()), ": error: this is a folder; give the path of an STL file");
  ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
  EXPECT_EQ(message_about_path(folder.file("pipe")),
            ": error: this is not a file; give the path of an STL file");
}

TEST(StlBadInput, AFileThatMayNotBeReadIsTold) {
  ScratchFolder folder;
  put(folder.file("a.stl"), "solid");
  ASSERT_EQ(::chmod(folder.file("a.stl").c_str(), 0), 0);
  if (std::ifstream(folder.file("a.stl"))) GTEST_SKIP() << "this user may read everything";
  EXPECT_EQ(message_about_path(folder.file("a.stl")),
            ": error: cannot be read: Permission denied; check its permissions");
}

TEST(StlBadInput, AnEmptyFileIsTold) {
  EXPECT_EQ(message_about(""), ": error: the file is empty; copy or export it again");
}

TEST(StlBadInput, AFileWithoutFacetsIsTold) {
  EXPECT_EQ(message_about(std::string(84, '\0')),
            ": error: there is no facet in the file; export the surface again");
  EXPECT_EQ(message_about("solid a\nendsolid a\n"),
            ":3: error: there is no facet in the file; export the surface again");
}

TEST(StlBadInput, ATruncatedBinaryFileSaysWhatItPromisesAndHolds) {
  EXPECT_EQ(
      message_about(bytes_of_cube(StlForm::binary).substr(0, 500)),
      ": error: its binary header promises 12 facets, which take 684 bytes, but the file has 500 bytes (8 "
      "whole facets)\n  it was cut off or is no STL file; copy or export it again");
  EXPECT_EQ(
      message_about(bytes_of_cube(StlForm::binary).substr(0, 60)),
      ": error: 60 bytes are too few for a binary STL file (the header alone has 84), and it is no text that "
      "begins with \"solid\"\n  copy or export it again");
}

TEST(StlBadInput, ABinaryFilePosingAsTextIsSeenThrough) {
  auto bytes = bytes_of_cube(StlForm::binary).substr(0, 683);
  bytes.replace(0, 10, "solid cube");
  EXPECT_EQ(
      message_about(bytes),
      ": error: the file begins with \"solid\" but is not text; its binary header promises 12 facets, which "
      "take "
      "684 bytes, but the file has 683 bytes (11 whole facets)\n  it was cut off or is no STL file; copy or "
      "export it again");
}

TEST(StlBadInput, AHugePromiseCostsNoMemory) {
  auto bytes = bytes_of_cube(StlForm::binary);
  bytes.replace(80, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_NE(message_about(bytes).find("promises 4294967295 facets, which take 214748364834 bytes"),
            std::string::npos);
}

TEST(StlBadInput, RubbishAfterABinaryFileIsTold) {
  EXPECT_EQ(message_about(bytes_of_cube(StlForm::binary) + "rubbish"),
            ": error: its binary header promises 12 facets, which take 684 bytes, but the file has 691 "
            "bytes: rubbish "
            "follows from byte 684 on\n  export it again");
}

TEST(StlBadInput, AnotherKindOfTextIsTold) {
  EXPECT_EQ(
      message_about("<!DOCTYPE html>\n" + std::string(100, ' ')),
      ": error: this is no STL file: it begins with \"<!DOCTYPE html>\\x0a                        ...\"");
  EXPECT_NE(
      message_about(facet_text() + "endsolid").find("this is no STL file: it begins with \"facet normal"),
      std::string::npos);
  EXPECT_NE(message_about("solidus").find("7 bytes are too few"), std::string::npos);
}

TEST(StlBadInput, ATextCutOffIsToldWithItsLine) {
  const std::string again = "\n  it was cut off; copy or export it again";
  EXPECT_EQ(message_about("solid a\n" + facet_text() + "facet normal 0 0 1\n outer loop\n  vertex 0 0"),
            ":11: error: the file ends after 1 facets where a coordinate should follow" + again);
  EXPECT_EQ(message_about("solid a\n" + facet_text()),
            ":9: error: the file ends after 1 facets where \"facet\" or \"endsolid\" should follow" + again);
  EXPECT_EQ(message_about("solid"),
            ":1: error: the file ends after 0 facets where \"facet\" or \"endsolid\" should follow" + again);
}

TEST(StlBadInput, WordsOutOfPlaceAreToldWithTheirLine) {
  EXPECT_EQ(message_about("solid a\n" + facet_text() + "endsolid a\nrubbish"),
            ":10: error: \"rubbish\" where the file should end or another \"solid\" begin");
  EXPECT_EQ(
      message_about("solid a\nfacet normal 0 0 1\n outer\n  vertex 0 0 0"),
      ":4: error: \"vertex\" where \"loop\" should stand in facet 1\n  the file is damaged; export it again");
  EXPECT_EQ(
      message_about("solid a\n" + facet_text("0 1 0\n vertex 1 1 0") + "endsolid"),
      ":7: error: \"vertex\" where \"endloop\" should stand in facet 1\n  a facet of an STL file has three "
      "corners; export triangles");
  EXPECT_EQ(message_about("solid a\n" + facet_text() + std::string(60, 'x')),
            ":9: error: \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...\" where \"facet\" or \"endsolid\" "
            "should stand\n  "
            "the file is damaged; export it again");
  EXPECT_NE(message_about("solid a\n" + facet_text() + std::string(90, '\0')).find("\"\\x00\\x00"),
            std::string::npos);
}

TEST(StlBadInput, CornersThatAreNoPlacesAreToldWithTheirFacet) {
  for (const char* number : {"nan", "-inf", "1e39", "1e999", "1.#QNAN", "1,5", "0x10", "1.5mm"})
    EXPECT_EQ(message_about("solid a\n" + facet_text() + facet_text(std::string("0 ") + number + " 0") +
                            "endsolid"),
              std::string(":13: error: \"") + number +
                  "\" is not a finite number, in facet 2\n  export the surface again");
  auto bytes = bytes_of_cube(StlForm::binary);
  const auto set = [&](std::size_t at, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(bits >> (8 * k));
  };
  set(84 + 50 * 3, std::numeric_limits<float>::quiet_NaN());  // a normal, which is not read
  set(84 + 50 * 7 + 12 + 16, std::numeric_limits<float>::infinity());
  EXPECT_EQ(message_about(bytes),
            ": error: a corner of facet 8 (at byte 434) is (8, inf, 8), which is no place\n  export the "
            "surface again");
}

TEST(StlBadInput, TooManyTrianglesAreTold) {
  EXPECT_EQ(message_about(bytes_of_cube(StlForm::binary), 11),
            ": error: 12 triangles are more than the 11 that can be used; export a coarser surface");
  EXPECT_EQ(message_about("solid a\n" + facet_text() + facet_text() + "endsolid", 1),
            ":15: error: more than 1 triangles; export a coarser surface");
}

TEST(StlBadInput, MoreTrianglesThanIndicesAreToldBeforeAnyIsRead) {
  ScratchFolder folder;
  const std::uint64_t facets = most_stl_triangles + 1;
  std::string header(84, ' ');
  for (std::size_t k = 0; k < 4; ++k) header[80 + k] = static_cast<char>(facets >> (8 * k));
  put(folder.file("a.stl"), header);
  std::error_code error;
  std::filesystem::resize_file(folder.file("a.stl"), 84 + 50 * facets, error);  // a file full of holes
  if (error) GTEST_SKIP() << "no files of this size here";
  EXPECT_EQ(message_about_path(folder.file("a.stl")),
            ": error: 1431655766 triangles are more than the 1431655765 that can be used; export a coarser "
            "surface");
}

// A damaged file is either read and mended or refused; nothing else may happen.
void expect_read_or_refused(const std::string& path, const std::string& content, int& refused) {
  std::ofstream(path, std::ios::binary) << content;
  try {
    mend(read_stl(path), 1e-3);
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_input);
    ++refused;
  }
}

char any_byte(validation::Draw& draw) { return static_cast<char>(static_cast<int>(draw.between(0, 256))); }

void damage_and_read(StlForm form, std::uint32_t stream) {
  const std::string sound = bytes_of_cube(form);
  ScratchFolder folder;
  int refused = 0;
  for (std::uint64_t trial = 0; trial < 2000; ++trial) {
    validation::Draw draw(trial, stream);
    auto content = sound;
    const auto at = static_cast<std::size_t>(draw.between(0, static_cast<double>(content.size())));
    if (draw.chance(0.2))
      content.resize(at);
    else if (draw.chance(0.1))
      content.insert(at, 1, any_byte(draw));
    else
      content[at] = any_byte(draw);
    expect_read_or_refused(folder.file("a.stl"), content, refused);
  }
  EXPECT_GT(refused, 400);  // the truncated ones at least
  EXPECT_LT(refused, 1900);
}

TEST(StlBadInput, RandomDamageToABinaryFileNeverCrashes) { damage_and_read(StlForm::binary, 1); }
TEST(StlBadInput, RandomDamageToATextNeverCrashes) { damage_and_read(StlForm::text, 2); }

}  // namespace
}  // namespace pulvis
