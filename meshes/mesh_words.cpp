// SPDX-License-Identifier: Apache-2.0
#include "meshes/mesh_words.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

namespace pulvis {
namespace {

std::string with_commas(std::uint64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string text;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) text += ',';
    text += digits[k];
  }
  return text;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", with_commas(count), count == 1 ? one : many);
}

// Four digits, but never an exponent for a large size: that of a die read in the wrong unit should be plain.
std::string in_mm(double metres) {
  const double mm = 1e3 * metres;
  return mm >= 1e4 ? fmt::format("{:.0f}", mm) : fmt::format("{:.4g}", mm);
}

std::string in_mm(const Vec3& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x, 1e3 * p.y, 1e3 * p.z);
}

std::string mended_parts(const MeshReport& r) {
  std::string parts;
  const auto add = [&](std::uint64_t count, std::string_view one, std::string_view many) {
    if (count > 0) parts += (parts.empty() ? "" : ", ") + counted(count, one, many);
  };
  add(r.points_welded, "point welded", "points welded");
  add(r.duplicates, "duplicate triangle removed", "duplicate triangles removed");
  add(r.degenerate, "triangle without area removed", "triangles without area removed");
  add(r.slivers, "sliver removed", "slivers removed");
  add(r.turned, "triangle turned round", "triangles turned round");
  return parts;
}

}  // namespace

std::string describe(const MeshReport& r, const std::string& name) {
  const Vec3 size = r.bounds.size();
  std::string text = fmt::format("{}: {} x {} x {} mm, {}", name, in_mm(size.x), in_mm(size.y), in_mm(size.z),
                                 counted(r.triangles, "triangle", "triangles"));
  if (r.shells > 1) text += fmt::format(" in {} pieces", with_commas(r.shells));
  text += r.watertight ? ", watertight" : ", not watertight";
  if (r.volume) text += fmt::format(" ({:.4g} mm^3)", 1e9 * *r.volume);
  const std::string parts = mended_parts(r);
  return parts.empty() ? text : text + "; mended: " + parts;
}

std::vector<std::string> warnings_of(const MeshReport& r, const std::string& name) {
  std::vector<std::string> warnings;
  if (r.open_edges.count > 0)
    warnings.push_back(fmt::format(
        "{}: {} of {}, {} mm long in all, one of them at {}: powder may escape there, unless it is the "
        "opening of "
        "a vessel",
        name, counted(r.holes, "hole", "holes"), counted(r.open_edges.count, "open edge", "open edges"),
        in_mm(r.open_edges.length), in_mm(r.open_edges.place)));
  if (r.crowded_edges.count > 0)
    warnings.push_back(
        fmt::format("{}: {} of more than two triangles, one of them at {}: surfaces cross or stand on "
                    "each other there",
                    name, counted(r.crowded_edges.count, "edge", "edges"), in_mm(r.crowded_edges.place)));
  if (r.not_orientable > 0)
    warnings.push_back(
        fmt::format("{}: a surface has one side only ({} whose two triangles cannot agree which side is "
                    "outside): pictures may be wrong",
                    name, counted(r.not_orientable, "edge", "edges")));
  if (r.slivers_kept > 0)
    warnings.push_back(fmt::format("{}: {} lower than {} mm could not be removed without opening the surface",
                                   name, counted(r.slivers_kept, "triangle", "triangles"),
                                   in_mm(r.weld_distance)));
  return warnings;
}

}  // namespace pulvis
