// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as contact_kernels.cpp.
#include <cmath>

#include "engine/kernels/parcel_block.hpp"
#include "engine/math/four.hpp"

namespace pulvis::kernels {
namespace PULVIS_ISA {

/// Three numbers are taken as four, whose last nobody asks for. To add a zero is quicker than to find out whether to.
static void sum_pairs(const LoadsOfPairs& pairs, const SomeParcels& given, Load* sum) {
  constexpr double sign[2] = {1.0, -1.0};
  const PairLoad* const load = pairs.load;
  const std::uint32_t* const summands = pairs.summand;
  const SomeParcels some = given;  // nobody else writes to it
  for (std::size_t n = 0; n < some.count; ++n) {
    Four force{}, torque{};
    for (std::uint32_t k = pairs.begin[some[n]]; k < pairs.begin[some[n] + 1]; ++k) {
      ask_for(load[summands[k + summands_ahead] >> 1]);
      const std::uint32_t side = summands[k] & 1u;
      const double* in_place = &load[summands[k] >> 1].force.x;
      force += sign[side] * four_at(in_place);
      torque += four_at(in_place + 3 + 3 * side);
    }
    *sum++ = {{force[0], force[1], force[2]}, {torque[0], torque[1], torque[2]}};
  }
}

/// Parcels in lanes.
struct ParcelLanes {
  Lanes3 position, velocity, spin, force, torque, reference;
  alignas(64) Lane radius, mass, margin, names;  ///< names: id and species, which only pass through
  alignas(64) Lane second_crowd;                 ///< 1 for those of the second, else 0
};

static void read(ParcelLanes& b, const SomeParcels& some, const Load* load, const Parcel* parcels,
                 const Leeway& leeway) {
  const std::size_t count = some.count;
  for (std::size_t k = 0; k < count; k += 4) {
    const double *p[4], *f[4];
    for (std::size_t j = 0; j < 4; ++j) {
      const std::size_t lane = k + j < count ? k + j : count - 1;  // what is left over repeats the last
      p[j] = &parcels[some[lane]].position.x;
      f[j] = &load[lane].force.x;
    }
    const Quartet place = quartet(p, 0), velocity = quartet(p, 4), spin = quartet(p, 8);
    const Quartet force = quartet(f, 0), torque = quartet(f, 2);
    put_four(b.position.x + k, place.a), put_four(b.position.y + k, place.b);
    put_four(b.position.z + k, place.c), put_four(b.radius + k, place.d);
    put_four(b.velocity.x + k, velocity.a), put_four(b.velocity.y + k, velocity.b);
    put_four(b.velocity.z + k, velocity.c), put_four(b.mass + k, velocity.d);
    put_four(b.spin.x + k, spin.a), put_four(b.spin.y + k, spin.b);
    put_four(b.spin.z + k, spin.c), put_four(b.names + k, spin.d);
    put_four(b.force.x + k, force.a), put_four(b.force.y + k, force.b), put_four(b.force.z + k, force.c);
    put_four(b.torque.x + k, force.d), put_four(b.torque.y + k, torque.c), put_four(b.torque.z + k, torque.d);
  }
  for (std::size_t k = 0; k < count; ++k) {
    store(b.reference, static_cast<int>(k), leeway.reference[some[k]]);
    b.margin[k] = leeway.margin[some[k]];
    b.second_crowd[k] = leeway.crowd[some[k]];
  }
}

static void write(const ParcelLanes& b, const SomeParcels& some, Parcel* parcels) {
  std::size_t k = 0;
  for (; k + 4 <= some.count; k += 4) {
    double* p[4];
    for (std::size_t j = 0; j < 4; ++j) p[j] = &parcels[some[k + j]].position.x;
    put_quartet(p, 0,
                {four_at(b.position.x + k), four_at(b.position.y + k), four_at(b.position.z + k),
                 four_at(b.radius + k)});
    put_quartet(p, 4,
                {four_at(b.velocity.x + k), four_at(b.velocity.y + k), four_at(b.velocity.z + k),
                 four_at(b.mass + k)});
    put_quartet(p, 8,
                {four_at(b.spin.x + k), four_at(b.spin.y + k), four_at(b.spin.z + k), four_at(b.names + k)});
  }
  for (; k < some.count; ++k) {
    const int lane = static_cast<int>(k);
    Parcel& p = parcels[some[k]];
    p.position = load(b.position, lane);
    p.velocity = load(b.velocity, lane);
    p.spin = load(b.spin, lane);
  }
}

/// Where a periodic axis begins and ends; the other axes have no end.
struct Wrap {
  PULVIS_INLINE explicit Wrap(const PlainStep& step) {
    for (int axis = 0; axis < 3; ++axis)
      if (step.periodic[axis]) {
        low[axis] = step.low[axis], high[axis] = step.high[axis];
        length[axis] = high[axis] - low[axis];
      }
  }
  /// What to take off where an axis was left.
  PULVIS_INLINE static double off(double x, double low, double high, double length) {
    return select(x >= high, length, select(x < low, -length, 0.0));
  }
  PULVIS_INLINE Vec3 off(const Vec3& x) const {
    return {off(x.x, low.x, high.x, length.x), off(x.y, low.y, high.y, length.y),
            off(x.z, low.z, high.z, length.z)};
  }
  Vec3 low{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, high{HUGE_VAL, HUGE_VAL, HUGE_VAL}, length;
};

/// One parcel in its lane. What is noticed is counted in numbers as wide as the others: a whole number would have to be made
/// of every comparison.
PULVIS_INLINE void kick_and_drift(ParcelLanes& b, int k, const PlainStep& step, double& too_fast) {
  const double half = 0.5 * step.dt, mass = b.mass[k], radius = b.radius[k];
  const double by_mass = half / mass, by_inertia = half / (0.4 * mass * (radius * radius));
  const Vec3 change = by_mass * (load(b.force, k) + mass * step.gravity);
  const Vec3 turn = by_inertia * load(b.torque, k);
  const Vec3 velocity = (load(b.velocity, k) + change) + change;
  store(b.velocity, k, velocity);
  store(b.spin, k, (load(b.spin, k) + turn) + turn);
  const Vec3 move = step.dt * velocity;
  store(b.position, k, load(b.position, k) + move);
  too_fast += select(dot(move, move) > 0.25 * (radius * radius), 1.0, 0.0);
}

/// Brings what left a periodic axis back, and its reference with it.
PULVIS_INLINE void inspect(ParcelLanes& b, int k, const PlainStep& step, const Wrap& wrap, double& outside,
                           double& left, double& wrapped) {
  const Vec3 off = wrap.off(load(b.position, k));
  const Vec3 x = load(b.position, k) - off, reference = load(b.reference, k) - off;
  store(b.position, k, x);
  store(b.reference, k, reference);
  wrapped += select((off.x != 0.0) | (off.y != 0.0) | (off.z != 0.0), 1.0, 0.0);
  const Vec3 spin = load(b.spin, k), apart = step.drift[1] - step.drift[0];
  const Vec3 since = x - reference - (step.drift[0] + b.second_crowd[k] * apart);
  const double margin = b.margin[k];
  const bool inside = (x.x >= step.low.x) & (x.x <= step.high.x) & (x.y >= step.low.y) &
                      (x.y <= step.high.y) & (x.z >= step.low.z) & (x.z <= step.high.z) &
                      (dot(spin, spin) < 1e300);
  outside += select(inside, 0.0, 1.0);
  left += select(dot(since, since) > margin * margin, 1.0, 0.0);
}

/// What tells whether the parcels two blocks behind these left their margins: that is read once in a step, too little at a
/// time for the processor to foresee.
static void ask_for_leeway(const SomeParcels& some, const Leeway& leeway) {
  if (some.list) return;
  const std::size_t next = some.first + 2 * block_size;
  const char *reference = reinterpret_cast<const char*>(leeway.reference + next),
             *margin = reinterpret_cast<const char*>(leeway.margin + next);
  for (std::size_t at = 0; at < block_size * sizeof(Vec3); at += 64) __builtin_prefetch(reference + at);
  for (std::size_t at = 0; at < block_size * sizeof(double); at += 64) __builtin_prefetch(margin + at);
}

static void move_parcels(const PlainStep& given, const SomeParcels& wanted, const Load* load, Parcel* parcels,
                         const Leeway& where, StepNotice& notice) {
  const PlainStep step = given;
  const SomeParcels some = wanted;
  const Leeway leeway = where;
  const int count = static_cast<int>(some.count);
  const Wrap wrap(step);
  ParcelLanes b;
  read(b, some, load, parcels, leeway);
  ask_for_leeway(some, leeway);
  double too_fast = 0.0, outside = 0.0, left = 0.0, off = 0.0;
#pragma omp simd reduction(+ : too_fast)
  for (int k = 0; k < count; ++k) kick_and_drift(b, k, step, too_fast);
#pragma omp simd reduction(+ : outside, left, off)
  for (int k = 0; k < count; ++k) inspect(b, k, step, wrap, outside, left, off);
  const bool wrapped = off != 0.0;
  write(b, some, parcels);
  if (wrapped)
    for (int k = 0; k < count; ++k)
      leeway.reference[some[static_cast<std::size_t>(k)]] = kernels::load(b.reference, k);
  notice.too_fast |= too_fast != 0.0;
  notice.outside |= outside != 0.0;
  if (left != 0.0) notice.note_left(some[0], some[some.count - 1] + 1);
  notice.wrapped |= wrapped;
}

ParcelKernel parcel_kernel() { return {sum_pairs, move_parcels}; }

}  // namespace PULVIS_ISA
}  // namespace pulvis::kernels
