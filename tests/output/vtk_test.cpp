// SPDX-License-Identifier: Apache-2.0
#include "output/vtk.hpp"

#include <cstring>
#include <stdexcept>

#include "failures.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;

TEST(Vtk, DeclaresByteOrderHeadersAndCompression) {
  ScratchFolder folder;
  write_points_vtp(folder.file("p.vtp"), {}, {}, 0.5);
  const auto text = content_of(folder.file("p.vtp"));
  EXPECT_NE(
      text.find("byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\""),
      std::string::npos);
  EXPECT_NE(text.find("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">\n0.5\n"), std::string::npos);
}

TEST(Vtk, PointsEachOffsetAtTheHeaderOfItsArray) {
  ScratchFolder folder;
  const std::vector<Vec3> points{{1, 2, 3}, {4, 5, 6}};
  const std::vector<std::uint32_t> ids{7, 8};
  const std::vector<Field> fields{{"id", std::span(ids)}, {"velocity", std::span(points)}};
  write_points_vtp(folder.file("p.vtp"), points, fields, 0.0);
  const auto text = content_of(folder.file("p.vtp"));
  const auto data = text.find("\n_") + 2;
  // Uncompressed sizes: 2 UInt32, 6 Float32, 6 Float64, then 2 Int64 each for connectivity and offsets.
  std::size_t from = 0;
  for (const std::uint64_t size : {8u, 24u, 48u, 16u, 16u}) {
    from = text.find(" offset=\"", from) + 9;
    std::uint64_t header[3];
    std::memcpy(header, text.data() + data + std::stoul(text.substr(from)), sizeof(header));
    EXPECT_EQ(header[0], 1u);
    EXPECT_EQ(header[2], size);
  }
}

TEST(Vtk, EscapesTheNamesOfFields) {
  ScratchFolder folder;
  const std::vector<Vec3> points{{0, 0, 0}};
  const std::vector<double> values{1.0};
  const std::vector<Field> fields{{"a<b & \"c\"", std::span(values)}};
  write_points_vtp(folder.file("p.vtp"), points, fields, 0.0);
  EXPECT_NE(content_of(folder.file("p.vtp")).find("Name=\"a&lt;b &amp; &quot;c&quot;\""), std::string::npos);
}

TEST(Vtk, RefusesAFieldOfAWrongLengthAndWritesNothing) {
  ScratchFolder folder;
  const std::vector<Vec3> points{{0, 0, 0}, {1, 1, 1}};
  const std::vector<double> values{1.0, 2.0, 3.0};
  const std::vector<Field> fields{{"radius", std::span(values)}};
  EXPECT_THROW(write_points_vtp(folder.file("p.vtp"), points, fields, 0.0), std::invalid_argument);
  EXPECT_THROW(write_grid_vti(folder.file("g.vti"), {{}, {1, 1, 1}, {2, 2, 2}}, fields, 0.0),
               std::invalid_argument);
  EXPECT_THROW(write_grid_vti(folder.file("g.vti"), {{}, {1, 1, 1}, {0, 2, 2}}, {}, 0.0),
               std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Vtk, FailsClearlyWithoutItsFolder) {
  ScratchFolder folder;
  const auto message =
      failure_of(Exit::io, [&] { write_points_vtp(folder.file("missing/p.vtp"), {}, {}, 0.0); });
  EXPECT_NE(message.find("cannot write " + folder.file("missing/p.vtp")), std::string::npos) << message;
}

}  // namespace
}  // namespace pulvis
