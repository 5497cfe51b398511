// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "measures/shapes.hpp"

// Packings whose porosity, contacts and surface are known on paper.
namespace pulvis::measures::packings {

struct Packing {
  std::vector<Sphere> spheres;
  std::vector<Contact> contacts;
};

/// Simple cubic, n spheres along each axis, the first cell beginning at the origin; porosity 1 - pi/6.
/// With `wrap` the contacts across opposite faces are there too.
enum class Faces { free, wrap };
inline Packing simple_cubic(std::uint32_t n, double diameter, Faces faces = Faces::free) {
  Packing packing;
  const auto place = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { return i + n * (j + n * k); };
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        packing.spheres.push_back(
            {{(i + 0.5) * diameter, (j + 0.5) * diameter, (k + 0.5) * diameter}, 0.5 * diameter});
        const auto here = place(i, j, k);
        if (i + 1 < n || faces == Faces::wrap) packing.contacts.push_back({here, place((i + 1) % n, j, k)});
        if (j + 1 < n || faces == Faces::wrap) packing.contacts.push_back({here, place(i, (j + 1) % n, k)});
        if (k + 1 < n || faces == Faces::wrap) packing.contacts.push_back({here, place(i, j, (k + 1) % n)});
      }
  return packing;
}

/// Body-centred cubic in a periodic cube of n cells of edge a, spheres touching along the diagonals:
/// radius sqrt(3)/4 a, porosity 1 - sqrt(3)/8 pi, coordination 8.
inline Packing body_centred(std::uint32_t n, double a) {
  Packing packing;
  const double radius = std::sqrt(3.0) / 4.0 * a;
  const auto corner = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return 2 * (i % n + n * (j % n + n * (k % n)));
  };
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        packing.spheres.push_back({{i * a, j * a, k * a}, radius});
        packing.spheres.push_back({{(i + 0.5) * a, (j + 0.5) * a, (k + 0.5) * a}, radius});
        for (std::uint32_t c = 0; c < 8; ++c)
          packing.contacts.push_back(
              {corner(i, j, k) + 1, corner(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))});
      }
  return packing;
}

/// Uniform numbers in [low, high) that are the same everywhere (the standard's distributions are not).
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

/// Equal spheres that do not overlap, wholly inside a cube of edge 1 from the origin: each is put anywhere
/// until it touches none of those before.
inline std::vector<Sphere> random_apart(std::size_t count, double radius, std::uint64_t seed) {
  Uniform uniform(seed);
  std::vector<Sphere> spheres;
  while (spheres.size() < count) {
    const auto place = [&] { return uniform(radius, 1.0 - radius); };
    const Vec3 centre{place(), place(), place()};
    const auto meets = [&](const Sphere& other) { return norm(centre - other.centre) < 2.0 * radius; };
    if (std::none_of(spheres.begin(), spheres.end(), meets)) spheres.push_back({centre, radius});
  }
  return spheres;
}

}  // namespace pulvis::measures::packings
