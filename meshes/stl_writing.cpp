// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "engine/base/failure.hpp"
#include "meshes/stl_file.hpp"

namespace pulvis {
namespace {

constexpr std::size_t name_bytes = 80;

Vec3 normal_of(const std::array<Vec3, 3>& corners) {
  const Vec3 direction = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = norm(direction);
  return size > 0.0 ? direction / size : Vec3{};
}

void append(std::string& bytes, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFF);
}

void append(std::string& bytes, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis)
    append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(v[axis])));
}

void write_binary(std::ostream& file, const TriangleSoup& soup, const std::string& name) {
  // "solid" at the start would make other programs take it for text.
  std::string bytes = "STL " + name;
  bytes.resize(name_bytes, ' ');
  append(bytes, static_cast<std::uint32_t>(soup.triangles.size()));
  for (const auto& corners : soup.triangles) {
    append(bytes, normal_of(corners));
    for (const Vec3& corner : corners) append(bytes, corner);
    bytes.append(2, '\0');
    file << bytes;
    bytes.clear();
  }
  file << bytes;
}

// The shortest digits that give the same number again; negative zeros look like mistakes.
std::string three_numbers(const Vec3& v) { return fmt::format("{} {} {}", v.x + 0.0, v.y + 0.0, v.z + 0.0); }

void write_text(std::ostream& file, const TriangleSoup& soup, const std::string& name) {
  file << "solid " << name << '\n';
  for (const auto& corners : soup.triangles) {
    file << "facet normal " << three_numbers(normal_of(corners)) << "\n outer loop\n";
    for (const Vec3& corner : corners) file << "  vertex " << three_numbers(corner) << '\n';
    file << " endloop\nendfacet\n";
  }
  file << "endsolid " << name << '\n';
}

}  // namespace

void write_stl(const std::string& path, const TriangleSoup& soup, StlForm form, const std::string& name) {
  const std::string part = path + ".part";
  errno = 0;
  std::ofstream file(part, std::ios::binary);
  if (form == StlForm::binary)
    write_binary(file, soup, name);
  else
    write_text(file, soup, name);
  file.close();
  std::error_code error(errno, std::generic_category());
  if (file) std::filesystem::rename(part, path, error);
  if (file && !error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw Failure(Exit::io, fmt::format("cannot write {}: {}; check that its folder exists and has room", path,
                                      error ? error.message() : "unknown reason"));
}

}  // namespace pulvis
