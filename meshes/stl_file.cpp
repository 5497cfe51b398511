// SPDX-License-Identifier: Apache-2.0
#include "meshes/stl_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <string_view>
#include <system_error>

#include "engine/base/failure.hpp"
#include "meshes/stl_text.hpp"

namespace pulvis {
namespace {

// A binary file is a header of 80 bytes, the number of facets, and 50 bytes for each: normal, three corners
// (little-endian 32-bit numbers) and two bytes that some programs use for colours.
constexpr std::uint64_t header_bytes = 84, facet_bytes = 50;
constexpr std::size_t normal_bytes = 12;

[[noreturn]] void fail(const std::string& path, const std::string& message) {
  throw Failure(Exit::bad_input, fmt::format("{}: error: {}", path, message));
}

std::uint32_t whole_number_at(const char* bytes) {
  std::uint32_t value = 0;
  for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

std::uint64_t size_of(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    fail(path, "there is no such file; check the path");
  if (std::filesystem::is_directory(status)) fail(path, "this is a folder; give the path of an STL file");
  if (error) fail(path, fmt::format("cannot be read: {}", error.message()));
  // A pipe or a device has no size to judge by, and may never end.
  if (!std::filesystem::is_regular_file(status))
    fail(path, "this is not a file; give the path of an STL file");
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) fail(path, fmt::format("cannot be read: {}", error.message()));
  if (size == 0) fail(path, "the file is empty; copy or export it again");
  return size;
}

std::ifstream open(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    fail(path, fmt::format("cannot be read: {}; check its permissions",
                           errno ? std::generic_category().message(errno) : "unknown reason"));
  return file;
}

// Which kind of file it is, and whether it is all there.
class Nature {
 public:
  Nature(const std::string& path, std::uint64_t size, std::string_view first_bytes)
      : path_(path), size_(size), first_bytes_(first_bytes) {}

  std::uint64_t promised_facets() const { return whole_number_at(first_bytes_.data() + 80); }
  bool is_binary() const { return has_header() && size_ == promised_size(); }

  /// After `is_binary` said no. A binary header holds a zero byte at the latest in the number of its facets,
  /// as long as these are less than 16 million; a text has none.
  void need_text() const {
    const bool zero_byte = first_bytes_.find('\0') != first_bytes_.npos;
    if (begins_with_solid(first_bytes_) && !zero_byte) return;
    if (!has_header())
      fail(path_,
           fmt::format("{} bytes are too few for a binary STL file (the header alone has {}), and it is no "
                       "text that begins with \"solid\"\n  copy or export it again",
                       size_, header_bytes));
    if (is_text())
      fail(path_, fmt::format("this is no STL file: it begins with \"{}\"", shown(first_bytes_)));
    fail(path_, damage());
  }

 private:
  bool has_header() const { return size_ >= header_bytes && first_bytes_.size() >= header_bytes; }
  std::uint64_t promised_size() const { return header_bytes + facet_bytes * promised_facets(); }
  bool is_text() const {
    return std::all_of(first_bytes_.begin(), first_bytes_.end(),
                       [](unsigned char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); });
  }

  std::string damage() const {
    const char* posing =
        begins_with_solid(first_bytes_) ? "the file begins with \"solid\" but is not text; " : "";
    const auto promise = fmt::format("{}its binary header promises {} facets, which take {} bytes, ", posing,
                                     promised_facets(), promised_size());
    if (size_ < promised_size())
      return promise + fmt::format(
                           "but the file has {} bytes ({} whole facets)\n  it was cut off or is no STL "
                           "file; copy or export it again",
                           size_, (size_ - header_bytes) / facet_bytes);
    return promise +
           fmt::format("but the file has {} bytes: rubbish follows from byte {} on\n  export it again", size_,
                       promised_size());
  }

  const std::string& path_;
  std::uint64_t size_;
  std::string_view first_bytes_;
};

std::array<Vec3, 3> corners_at(const char* facet) {
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 9; ++k)
    corners[k / 3][static_cast<int>(k % 3)] =
        std::bit_cast<float>(whole_number_at(facet + normal_bytes + 4 * k));
  return corners;
}

void check_finite(const std::string& path, const std::array<Vec3, 3>& corners, std::uint64_t facet) {
  for (const Vec3& c : corners)
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z))
      fail(path,
           fmt::format("a corner of facet {} (at byte {}) is ({:g}, {:g}, {:g}), which is no place\n  export "
                       "the surface again",
                       facet + 1, header_bytes + facet_bytes * facet, c.x, c.y, c.z));
}

// The size of the file has confirmed `facets`.
TriangleSoup read_binary(std::istream& file, const std::string& path, std::uint64_t facets) {
  constexpr std::uint64_t facets_at_once = 4096;
  TriangleSoup soup;
  soup.source = path;
  soup.triangles.reserve(facets);
  std::string bytes(facets_at_once * facet_bytes, '\0');
  file.seekg(static_cast<std::streamoff>(header_bytes));
  for (std::uint64_t facet = 0; facet < facets;) {
    const std::uint64_t count = std::min(facets_at_once, facets - facet);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(count * facet_bytes)))
      fail(path,
           fmt::format("the file cannot be read beyond byte {}; check the disk, and that no other program "
                       "writes it",
                       header_bytes + facet * facet_bytes));
    for (std::uint64_t k = 0; k < count; ++k, ++facet) {
      soup.triangles.push_back(corners_at(bytes.data() + k * facet_bytes));
      check_finite(path, soup.triangles.back(), facet);
    }
  }
  return soup;
}

TriangleSoup read_any(const std::string& path, std::uint64_t most_triangles) {
  const std::uint64_t size = size_of(path);
  std::ifstream file = open(path);
  std::string first_bytes(std::min(size, header_bytes), '\0');
  file.read(first_bytes.data(), static_cast<std::streamsize>(first_bytes.size()));
  if (!file) fail(path, "the file cannot be read; check the disk");
  const Nature nature(path, size, first_bytes);
  if (!nature.is_binary()) {
    nature.need_text();
    file.seekg(0);
    return read_stl_text(file, path, most_triangles);
  }
  const std::uint64_t facets = nature.promised_facets();
  if (facets == 0) fail(path, "there is no facet in the file; export the surface again");
  if (facets > most_triangles)
    fail(path, fmt::format("{} triangles are more than the {} that can be used; export a coarser surface",
                           facets, most_triangles));
  return read_binary(file, path, facets);
}

}  // namespace

TriangleSoup read_stl(const std::string& path, std::uint64_t most_triangles) {
  try {
    return read_any(path, std::min(most_triangles, most_stl_triangles));
  } catch (const std::bad_alloc&) {
    fail(path, "the surface does not fit into memory; export a coarser one");
  }
}

}  // namespace pulvis
