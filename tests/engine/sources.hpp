// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <vector>

#include "validation/scene.hpp"

// Sources to draw from, and what must hold for what they give.
namespace pulvis::scenes {

inline SizeLaw size_law(SizeKind kind) {
  SizeLaw law;
  law.kind = kind;
  law.diameter = 1e-3;
  law.standard_deviation = 0.3e-3;
  law.geometric_deviation = 1.4;
  law.smallest = 0.5e-3;
  law.largest = 2e-3;
  law.diameters = {0.5e-3, 0.8e-3, 1.5e-3};
  law.shares = {0.2, 0.5, 0.3};
  law.by_mass = true;
  return law;
}

inline constexpr SizeKind kinds[] = {SizeKind::single, SizeKind::uniform, SizeKind::normal,
                                     SizeKind::lognormal, SizeKind::table};

inline Region box_region(const Vec3& low, const Vec3& high) {
  Region r;
  r.min = low;
  r.max = high;
  return r;
}

inline Region tilted_cylinder() {
  Region r;
  r.shape = Region::Shape::cylinder;
  r.base = {0.03, 0.02, 0.02};
  r.axis = Vec3{1, 2, 3} / std::sqrt(14.0);
  r.radius = 0.008;
  r.height = 0.02;
  return r;
}

inline SourceModel source(SourceModel::Kind kind, SizeKind sizes, const Region& region) {
  SourceModel m;
  m.name = "funnel";
  m.kind = kind;
  m.density = 8000.0;
  m.sizes.emplace(size_law(sizes));
  m.region = region;
  return m;
}

inline Box cube(double edge, bool periodic) {
  Box box;
  box.max = {edge, edge, edge};
  for (bool& axis : box.periodic) axis = periodic;
  return box;
}

inline std::vector<Parcel> draw_pack(const SourceModel& m, const Box& box, const Parcels& present = {},
                                     std::uint64_t seed = 1) {
  SourceState state;
  return draw_parcels(m, state, seed, 0, 0, 1e-5, present, box);
}

inline bool overlap(const Parcel& p, const Parcel& q, const Box& box) {
  const Vec3 d = NearestImage::of(box)(q.position - p.position);
  return norm(d) < (p.radius + q.radius) * (1.0 - 1e-14);
}

inline std::size_t overlaps(const std::vector<Parcel>& fresh, const std::vector<Parcel>& present,
                            const Box& box) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    for (std::size_t j = i + 1; j < fresh.size(); ++j) count += overlap(fresh[i], fresh[j], box);
    for (const Parcel& p : present) count += overlap(fresh[i], p, box);
  }
  return count;
}

inline bool inside(const Parcel& p, const Region& r) {
  const double slack = 1e-12 * p.radius;
  if (r.shape == Region::Shape::box) {
    for (int axis = 0; axis < 3; ++axis)
      if (p.position[axis] - p.radius < r.min[axis] - slack ||
          p.position[axis] + p.radius > r.max[axis] + slack)
        return false;
    return true;
  }
  const Vec3 from_base = p.position - r.base;
  const double along = dot(from_base, r.axis), across = norm(from_base - along * r.axis);
  return along >= p.radius - slack && along <= r.height - p.radius + slack &&
         across <= r.radius - p.radius + slack;
}

inline double total_mass(const std::vector<Parcel>& parcels) {
  double sum = 0.0;
  for (const Parcel& p : parcels) sum += p.mass;
  return sum;
}

}  // namespace pulvis::scenes
