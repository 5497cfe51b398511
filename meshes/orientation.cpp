// SPDX-License-Identifier: Apache-2.0
#include "meshes/orientation.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/math/bounds.hpp"

namespace pulvis {
namespace {

// Enough for a die in its housing, and the search stays linear for a file of a million crumbs.
constexpr std::size_t most_enclosing = 64;

struct Patch {
  Bounds bounds;
  double volume = 0.0;  ///< as oriented like its first triangle; m^3
  std::uint64_t alike = 0, opposite = 0;
  bool open = false;
  bool turned = false;  ///< against its first triangle

  bool most_opposite() const { return opposite > alike; }
};

class Orienter {
 public:
  Orienter(std::span<const Vec3> points, std::span<const EdgeUse> uses, std::span<Corners> triangles)
      : points_(points),
        uses_(uses),
        triangles_(triangles),
        sets_(triangles.size()),
        patches_(triangles.size()) {}

  Orientation run() {
    join_neighbours();
    gather_patches();
    choose_sides();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto place = sets_.find(t);
      if (place.opposite == patches_[place.first].turned) continue;
      std::swap(triangles_[t][1], triangles_[t][2]);
      ++result_.turned;
    }
    return result_;
  }

 private:
  void join_neighbours() {
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() != 2) return;
      const std::uint32_t a = edge[0].triangle, b = edge[1].triangle;
      const bool opposite = runs_upward(triangles_[a], edge[0]) == runs_upward(triangles_[b], edge[1]);
      if (!sets_.join(a, b, opposite)) ++result_.conflicts;
    });
  }

  void gather_patches() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto place = sets_.find(t);
      Patch& patch = patches_[place.first];
      ++(place.opposite ? patch.opposite : patch.alike);
      for (const std::uint32_t point : triangles_[t]) patch.bounds.include(points_[point]);
    }
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto place = sets_.find(t);
      Patch& patch = patches_[place.first];
      const double volume = signed_volume(points_, patch.bounds.centre(), triangles_[t]);
      patch.volume += place.opposite ? -volume : volume;
    }
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 1) patches_[sets_.find(edge[0].triangle).first].open = true;
    });
  }

  void choose_sides() {
    std::vector<std::uint32_t> closed;
    for (std::uint32_t p = 0; p < patches_.size(); ++p) {
      Patch& patch = patches_[p];
      patch.turned = patch.most_opposite();
      if (patch.alike > 0 && !patch.open && patch.volume != 0.0) closed.push_back(p);
    }
    const auto extent = [&](std::uint32_t p) {
      return dot(patches_[p].bounds.size(), patches_[p].bounds.size());
    };
    std::stable_sort(closed.begin(), closed.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return extent(a) > extent(b); });
    for (std::size_t k = 0; k < closed.size(); ++k) {
      Patch& patch = patches_[closed[k]];
      const Patch* around = nullptr;
      for (std::size_t j = 0; j < std::min(k, most_enclosing) && !around; ++j)
        if (patches_[closed[j]].bounds.holds(patch.bounds)) around = &patches_[closed[j]];
      if (around)
        patch.turned ^= around->turned != around->most_opposite();
      else
        patch.turned = patch.volume < 0.0;
    }
  }

  std::span<const Vec3> points_;
  std::span<const EdgeUse> uses_;
  std::span<Corners> triangles_;
  AgreementSets sets_;
  std::vector<Patch> patches_;  // at the number of each one's first triangle
  Orientation result_;
};

}  // namespace

double signed_volume(std::span<const Vec3> points, const Vec3& centre, const Corners& t) {
  return dot(points[t[0]] - centre, cross(points[t[1]] - centre, points[t[2]] - centre)) / 6.0;
}

Orientation orient(std::span<const Vec3> points, std::span<const EdgeUse> uses,
                   std::span<Corners> triangles) {
  return Orienter(points, uses, triangles).run();
}

}  // namespace pulvis
