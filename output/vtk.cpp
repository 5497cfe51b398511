// SPDX-License-Identifier: Apache-2.0
#include "output/vtk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "output/safe_file.hpp"
#include "output/vtk_blocks.hpp"
#include "output/xml_text.hpp"

namespace pulvis {
namespace {

constexpr std::size_t block_size = 256 * 1024;  // in a core's cache, and few enough headers for millions

template <class Number>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<Number, float>) return "Float32";
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::uint32_t>) return "UInt32";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
}

// Collects the XML of a file and its data arrays, which follow the XML in one piece.
class VtkFile {
 public:
  VtkFile(const char* type, double time) {
    xml_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n",
        type);
    close_with_ = fmt::format("</{}>\n", type);
    time_ = fmt::format(
        "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">\n{}\n"
        "</DataArray>\n</FieldData>\n",
        time);
  }

  void line(const std::string& text) { xml_ += text + "\n"; }
  void add_time() { xml_ += time_; }

  // `value(i)` is the i-th number.
  template <class Number, class Value>
  void add_numbers(const std::string& name, int components, std::size_t count, const Value& value) {
    xml_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        vtk_type<Number>(), xml_escape(name), components, offset_);
    const auto read = [&](std::size_t offset, std::span<std::byte> block) {
      const std::size_t first = offset / sizeof(Number);
      for (std::size_t i = 0; i < block.size() / sizeof(Number); ++i) {
        const Number number = value(first + i);
        std::memcpy(block.data() + i * sizeof(Number), &number, sizeof(Number));
      }
    };
    arrays_.push_back(encode_vtk_blocks(count * sizeof(Number), block_size, read));
    offset_ += arrays_.back().size();
  }

  void add_points(std::span<const Vec3> points) {
    xml_ += "<Points>\n";
    add_numbers<double>("Points", 3, 3 * points.size(),
                        [&](std::size_t i) { return points[i / 3][static_cast<int>(i % 3)]; });
    xml_ += "</Points>\n";
  }

  void add_fields(const char* section, std::span<const Field> fields, std::size_t tuples) {
    xml_ += fmt::format("<{}>\n", section);
    for (const Field& field : fields)
      std::visit([&](auto values) { add_field(field, values, tuples); }, field.values);
    xml_ += fmt::format("</{}>\n", section);
  }

  void write(const std::string& path) const {
    SafeFile file(path);
    file.write(xml_);
    file.write(close_with_ + "<AppendedData encoding=\"raw\">\n_");
    for (const std::string& array : arrays_) file.write(array);
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.commit();
  }

 private:
  template <class Number>
  void add_field(const Field& field, std::span<const Number> values, std::size_t tuples) {
    constexpr bool vectors = std::is_same_v<Number, Vec3>;
    const std::size_t wanted = vectors ? tuples : tuples * static_cast<std::size_t>(field.components);
    if (field.components < 1 || values.size() != wanted)
      throw std::invalid_argument(
          fmt::format("field {} has {} values where {} are due", field.name, values.size(), wanted));
    if constexpr (vectors) {
      add_reals(field, 3, 3 * values.size(),
                [&](std::size_t i) { return values[i / 3][static_cast<int>(i % 3)]; });
    } else if constexpr (std::is_same_v<Number, double>) {
      add_reals(field, field.components, values.size(), [&](std::size_t i) { return values[i]; });
    } else {
      add_numbers<Number>(field.name, field.components, values.size(),
                          [&](std::size_t i) { return values[i]; });
    }
  }

  template <class Value>
  void add_reals(const Field& field, int components, std::size_t count, const Value& value) {
    if (field.stored == Stored::double_precision) {
      add_numbers<double>(field.name, components, count, value);
    } else {
      add_numbers<float>(field.name, components, count,
                         [&](std::size_t i) { return static_cast<float>(value(i)); });
    }
  }

  std::string xml_, close_with_, time_;
  std::vector<std::string> arrays_;
  std::size_t offset_ = 0;
};

// Cells of `corners` points each, point `corner(i)` for the i-th corner of all.
template <class Corner>
void add_cells(VtkFile& file, const char* section, std::size_t cells, std::size_t corners,
               const Corner& corner) {
  file.line(fmt::format("<{}>", section));
  file.add_numbers<std::int64_t>("connectivity", 1, cells * corners, corner);
  file.add_numbers<std::int64_t>("offsets", 1, cells,
                                 [&](std::size_t i) { return static_cast<std::int64_t>((i + 1) * corners); });
  file.line(fmt::format("</{}>", section));
}

}  // namespace

void write_points_vtp(const std::string& path, std::span<const Vec3> points, std::span<const Field> fields,
                      double time) {
  VtkFile file("PolyData", time);
  file.line("<PolyData>");
  file.add_time();
  file.line(
      fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" "
                  "NumberOfStrips=\"0\" NumberOfPolys=\"0\">",
                  points.size()));
  file.add_fields("PointData", fields, points.size());
  file.add_points(points);
  add_cells(file, "Verts", points.size(), 1, [](std::size_t i) { return static_cast<std::int64_t>(i); });
  file.line("</Piece>");
  file.write(path);
}

void write_surface_vtp(const std::string& path, const SurfaceMesh& mesh, std::span<const Field> fields,
                       double time) {
  VtkFile file("PolyData", time);
  file.line("<PolyData>");
  file.add_time();
  file.line(
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
                  "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">",
                  mesh.points.size(), mesh.triangles.size()));
  file.add_fields("CellData", fields, mesh.triangles.size());
  file.add_points(mesh.points);
  add_cells(file, "Polys", mesh.triangles.size(), 3,
            [&](std::size_t i) { return static_cast<std::int64_t>(mesh.triangles[i / 3][i % 3]); });
  file.line("</Piece>");
  file.write(path);
}

void write_grid_vti(const std::string& path, const Grid& grid, std::span<const Field> fields, double time) {
  const auto& n = grid.cells;
  if (std::ranges::any_of(n, [](int cells) { return cells < 1; }))
    throw std::invalid_argument("a grid needs a cell along each axis");
  const auto extent = fmt::format("0 {} 0 {} 0 {}", n[0], n[1], n[2]);
  VtkFile file("ImageData", time);
  file.line(fmt::format("<ImageData WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\">", extent,
                        grid.origin.x, grid.origin.y, grid.origin.z, grid.spacing.x, grid.spacing.y,
                        grid.spacing.z));
  file.add_time();
  file.line(fmt::format("<Piece Extent=\"{}\">", extent));
  file.add_fields("CellData", fields, static_cast<std::size_t>(n[0]) * n[1] * n[2]);
  file.line("</Piece>");
  file.write(path);
}

}  // namespace pulvis
