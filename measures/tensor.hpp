// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "engine/math/vec3.hpp"

namespace pulvis::measures {

/// Nine numbers, e.g. a stress in Pa: rows[i][j].
struct Tensor {
  std::array<Vec3, 3> rows{};

  Tensor& operator+=(const Tensor& b) {
    for (std::size_t i = 0; i < 3; ++i) rows[i] += b.rows[i];
    return *this;
  }
  friend Tensor operator+(Tensor a, const Tensor& b) { return a += b; }
  friend Tensor operator*(double s, const Tensor& a) {
    return {{s * a.rows[0], s * a.rows[1], s * a.rows[2]}};
  }
  friend bool operator==(const Tensor&, const Tensor&) = default;

  double trace() const { return rows[0].x + rows[1].y + rows[2].z; }
};

/// a_i b_j.
inline Tensor outer(const Vec3& a, const Vec3& b) { return {{a.x * b, a.y * b, a.z * b}}; }

/// The same tensor in the coordinates of three unit vectors, e.g. a die's own axes (DieFrame::axes()).
inline Tensor along_axes(const Tensor& a, const std::array<Vec3, 3>& axes) {
  Tensor turned;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 column{dot(a.rows[0], axes[j]), dot(a.rows[1], axes[j]), dot(a.rows[2], axes[j])};
      turned.rows[i][static_cast<int>(j)] = dot(axes[i], column);
    }
  return turned;
}

}  // namespace pulvis::measures
