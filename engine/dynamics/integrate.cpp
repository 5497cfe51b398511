// SPDX-License-Identifier: Apache-2.0
#include "engine/dynamics/integrate.hpp"

#include <vector>

#include "engine/base/parallel.hpp"
#include "engine/math/four.hpp"

namespace pulvis {
namespace {

/// Half a step of the velocities under the present load.
inline void kick(Parcel& p, const Load& load, double half_dt) {
  p.velocity += (half_dt / p.mass) * load.force;
  p.spin += (half_dt / inertia(p)) * load.torque;
}

/// Half a step that begins with the velocities seen from a rotating frame.
inline void kick_rotating_first(Parcel& p, const Load& load, const ForceField& field, double half_dt) {
  const Vec3 by_frame =
      -2.0 * cross(field.spin, p.velocity) - cross(field.spin_rate, p.position - field.point);
  const Vec3 turning = -cross(field.spin, p.spin) - field.spin_rate;
  kick(p, load, half_dt);
  p.velocity += half_dt * by_frame;
  p.spin += half_dt * turning;
}

/// The x of x + w x x = b (with the cross product of w).
inline Vec3 solve_turning(const Vec3& w, const Vec3& b) {
  return (b - cross(w, b) + dot(w, b) * w) / (1.0 + dot(w, w));
}

/// Half a step that ends with them.
inline void kick_rotating_last(Parcel& p, const Load& load, const ForceField& field, double half_dt) {
  kick(p, load, half_dt);
  const Vec3 euler = -cross(field.spin_rate, p.position - field.point);
  p.velocity = solve_turning((2.0 * half_dt) * field.spin, p.velocity + half_dt * euler);
  p.spin = solve_turning(half_dt * field.spin, p.spin - half_dt * field.spin_rate);
}

/// Loads of all near pairs of parcel `i`, in the order of the partners' ids. Pairs that do not touch add zeros, which
/// change no bit of a sum that began with +0. Three numbers are taken as four, whose last nobody asks for.
inline Load sum_of_pairs(const NearPairs& pairs, std::size_t i) {
  static_assert(sizeof(PairLoad) == 9 * sizeof(double));
  constexpr double sign[2] = {1.0, -1.0};
  Four force{}, torque{};
  for (std::uint32_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k) {
    const std::uint32_t side = pairs.entry[k] & 1u;
    const double* load = &pairs.load[pairs.entry[k] >> 1].force.x;
    force += sign[side] * four_at(load);
    torque += four_at(load + 3 + 3 * side);
  }
  return {{force[0], force[1], force[2]}, {torque[0], torque[1], torque[2]}};
}

/// Moves a coordinate that left a periodic axis back by one length, and its reference with it; true if it did.
inline bool wrap(double& x, double& reference, double low, double high) {
  const double length = x >= high ? high - low : x < low ? low - high : 0.0;
  if (length == 0.0) return false;
  x -= length;
  reference -= length;
  return true;
}

/// Brings a parcel that left a sheared box across the gradient axis back as its image, and its reference with it.
inline bool slide_back(Parcel& p, Vec3& reference, const Box& box, const Slide& slide) {
  const double x = p.position[slide.gradient];
  const double out = x >= box.max[slide.gradient] ? 1.0 : x < box.min[slide.gradient] ? -1.0 : 0.0;
  if (out == 0.0) return false;
  for (Vec3* at : {&p.position, &reference}) {
    (*at)[slide.gradient] -= out * slide.height;
    (*at)[slide.flow] -= out * slide.shift;
  }
  p.velocity[slide.flow] -= out * slide.jump;
  return true;
}

/// What is left of a parcel's margin at a strain since the lists were made. A strain e shortens no distance r by more
/// than e r/2 (the smaller stretch of a simple shear is sqrt(1 + e^2/4) - e/2), and pairs that are not listed were
/// farther apart than both radii, both margins and the reach: each parcel answers for half of it.
inline double margin_left(double margin, double radius, const ShearedStep& shear) {
  return margin - 0.5 * magnitude(shear.strain) * (radius + margin + 0.5 * shear.reach);
}

/// False also where a coordinate is not a number.
inline bool inside(const Vec3& x, const Box& box) {
  return x.x >= box.min.x && x.x <= box.max.x && x.y >= box.min.y && x.y <= box.max.y && x.z >= box.min.z &&
         x.z <= box.max.z;
}

}  // namespace

StepNotice begin_step(Parcels& parcels, const Box& box, const ShearedStep& shear, const ForceField& field,
                      double dt, std::span<Vec3> reference, std::span<const double> margin, int threads) {
  const bool any_periodic = box.periodic[0] || box.periodic[1] || box.periodic[2];
  const bool sheared = shear.slide.any();
  std::vector<StepNotice> notice(static_cast<std::size_t>(threads < 1 ? 1 : threads));
  parallel_shares(parcels.size(), threads, [&](std::size_t from, std::size_t to, int thread) {
    StepNotice mine;
    for (std::size_t i = from; i < to; ++i) {
      Parcel& p = parcels.body[i];
      if (field.rotating)
        kick_rotating_first(p, parcels.load[i], field, 0.5 * dt);
      else
        kick(p, parcels.load[i], 0.5 * dt);
      Vec3 move = dt * p.velocity;
      double left = margin[i];
      p.position += move;
      if (sheared) {
        const Vec3 drift = dt * box.flow_velocity(reference[i]);
        reference[i] += drift;
        move -= drift;
        left = margin_left(left, p.radius, shear);
        slide_back(p, reference[i], box, shear.slide);
      }
      if (any_periodic)
        for (int axis = 0; axis < 3; ++axis)
          if (box.periodic[axis])
            mine.wrapped |= wrap(p.position[axis], reference[i][axis], box.min[axis], box.max[axis]);
      const Vec3 since = p.position - reference[i];
      mine.outside |= !inside(p.position, box) || !(dot(p.spin, p.spin) < 1e300);
      mine.too_fast |= dot(move, move) > 0.25 * (p.radius * p.radius);
      mine.stale |= dot(since, since) > left * left || left < 0.0;
    }
    notice[static_cast<std::size_t>(thread)] = mine;
  });
  StepNotice all;
  for (const auto& n : notice) {
    all.outside |= n.outside;
    all.too_fast |= n.too_fast;
    all.stale |= n.stale;
    all.wrapped |= n.wrapped;
  }
  return all;
}

void end_step(Parcels& parcels, const NearPairs& pairs, const NearWalls& walls, const ForceField& field,
              double dt, int threads) {
  parallel_shares(parcels.size(), threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i) {
      Parcel& p = parcels.body[i];
      Load sum = sum_of_pairs(pairs, i);
      for (std::uint32_t slot = walls.begin[i]; slot < walls.begin[i + 1]; ++slot) {
        if (!walls.touching[slot]) continue;
        sum.force += walls.load[slot].force;
        sum.torque += walls.load[slot].torque;
      }
      sum.force += p.mass * field.at(p.position);
      parcels.load[i] = sum;
      if (field.rotating)
        kick_rotating_last(p, sum, field, 0.5 * dt);
      else
        kick(p, sum, 0.5 * dt);
    }
  });
}

}  // namespace pulvis
