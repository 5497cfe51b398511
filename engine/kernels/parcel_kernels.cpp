// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as contact_kernels.cpp.
#include <cmath>

#include "engine/kernels/parcel_block.hpp"
#include "engine/math/four.hpp"

namespace pulvis::kernels {
namespace PULVIS_ISA {

static void sum_pairs(const LoadsOfPairs& given, const SomeParcels& wanted, Load* sum) {
  const LoadsOfPairs pairs = given;  // nobody else writes to these
  const SomeParcels some = wanted;
  for (std::size_t n = 0; n < some.count; ++n) {
    const Run run = pairs.run[some[n]];
    Four force_and_x{};
    Two rest{};
    const double* at = &pairs.load[run.begin].force.x;
    constexpr std::size_t numbers = Places::numbers;
    for (const double* const end = at + numbers * run.count; at != end; at += numbers) {
      force_and_x += four_at(at);
      rest += two_at(at + 4);
    }
    put_four(&sum[n].force.x, force_and_x);
    put_two(&sum[n].torque.y, rest);
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
  PULVIS_INLINE static Four off(const Four& x, double low, double high, double length) {
    const Four none{}, all = none + length;
    return x >= high ? all : x < low ? -all : none;
  }
  PULVIS_INLINE Four3 off(const Four3& x) const {
    return {off(x.x, low.x, high.x, length.x), off(x.y, low.y, high.y, length.y),
            off(x.z, low.z, high.z, length.z)};
  }
  Vec3 low{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, high{HUGE_VAL, HUGE_VAL, HUGE_VAL}, length;
};

/// What is noticed of four parcels at a time, in each lane all bits or none.
struct Noticed {
  FourTruths outside{}, too_fast{}, left{}, wrapped{};
};

/// Four parcels of the store, and of the loads on them; the fourth numbers only pass through.
struct FourParcels {
  PULVIS_INLINE FourParcels(double* const (&records)[4], const double* const (&loads)[4]) {
    const Quartet place = quartet(records, 0), motion = quartet(records, 4), turn = quartet(records, 8);
    position = {place.a, place.b, place.c}, radius = place.d;
    velocity = {motion.a, motion.b, motion.c}, mass = motion.d;
    spin = {turn.a, turn.b, turn.c}, id_and_species = turn.d;
    const Quartet begin = quartet(loads, 0), end = quartet(loads, 2);
    force = {begin.a, begin.b, begin.c}, torque = {begin.d, end.c, end.d};
  }
  PULVIS_INLINE void put(double* const (&records)[4]) const {
    put_quartet(records, 0, {position.x, position.y, position.z, radius});
    put_quartet(records, 4, {velocity.x, velocity.y, velocity.z, mass});
    put_quartet(records, 8, {spin.x, spin.y, spin.z, id_and_species});
  }
  Four3 position, velocity, spin, force, torque;
  Four radius, mass, id_and_species;
};

PULVIS_INLINE void kick_and_drift(FourParcels& p, const PlainStep& step, Noticed& noticed) {
  const double half = 0.5 * step.dt;
  const Four by_mass = half / p.mass, by_inertia = half / (0.4 * p.mass * (p.radius * p.radius));
  const Four3 change = by_mass * (p.force + p.mass * step.gravity);
  const Four3 turn = by_inertia * p.torque;
  p.velocity = (p.velocity + change) + change;
  p.spin = (p.spin + turn) + turn;
  const Four3 move = step.dt * p.velocity;
  p.position = p.position + move;
  noticed.too_fast |= dot(move, move) > 0.25 * (p.radius * p.radius);
}

/// What tells of four parcels whether they left their margins.
struct FourLeeways {
  Four3 reference;
  Four margin, second_crowd;
};

/// Brings what left a periodic axis back, and its reference with it; whether any did.
PULVIS_INLINE FourTruths inspect(FourParcels& p, FourLeeways& leeways, const PlainStep& step,
                                 const Wrap& wrap, Noticed& noticed) {
  const Four3 off = wrap.off(p.position), x = p.position - off;
  p.position = x;
  leeways.reference = leeways.reference - off;
  const Vec3 apart = step.drift[1] - step.drift[0];
  const Four3 since = x - leeways.reference - (step.drift[0] + leeways.second_crowd * apart);
  const FourTruths inside = (x.x >= step.low.x) & (x.x <= step.high.x) & (x.y >= step.low.y) &
                            (x.y <= step.high.y) & (x.z >= step.low.z) & (x.z <= step.high.z) &
                            (dot(p.spin, p.spin) < 1e300);
  noticed.outside |= ~inside;
  noticed.left |= dot(since, since) > leeways.margin * leeways.margin;
  return (off.x != 0.0) | (off.y != 0.0) | (off.z != 0.0);
}

/// Four parcels, wherever they stand, and their loads.
struct AnyFour {
  PULVIS_INLINE AnyFour(const SomeParcels& some, std::size_t k) {  // what is left over repeats the last
    for (std::size_t j = 0; j < 4; ++j) lane[j] = k + j < some.count ? k + j : some.count - 1;
    for (std::size_t j = 0; j < 4; ++j) of[j] = some[lane[j]];
  }
  PULVIS_INLINE std::size_t parcel(std::size_t j) const { return of[j]; }
  PULVIS_INLINE std::size_t load(std::size_t j) const { return lane[j]; }
  PULVIS_INLINE FourLeeways leeways(const Leeway& all) const {
    const Vec3 *const r = all.reference, &a = r[of[0]], &b = r[of[1]], &c = r[of[2]], &d = r[of[3]];
    const auto crowd = [&](std::size_t j) { return static_cast<double>(all.crowd[of[j]]); };
    return {{Four{a.x, b.x, c.x, d.x}, Four{a.y, b.y, c.y, d.y}, Four{a.z, b.z, c.z, d.z}},
            Four{all.margin[of[0]], all.margin[of[1]], all.margin[of[2]], all.margin[of[3]]},
            Four{crowd(0), crowd(1), crowd(2), crowd(3)}};
  }
  std::size_t lane[4], of[4];
};

/// Four that stand in a row.
struct FourInARow {
  PULVIS_INLINE FourInARow(const SomeParcels& some, std::size_t k) : first(some.first + k), first_load(k) {}
  PULVIS_INLINE std::size_t parcel(std::size_t j) const { return first + j; }
  PULVIS_INLINE std::size_t load(std::size_t j) const { return first_load + j; }
  PULVIS_INLINE FourLeeways leeways(const Leeway& all) const {
    return {three_lanes(&all.reference[first].x), four_at(&all.margin[first]),
            four_of_bytes(&all.crowd[first])};
  }
  std::size_t first, first_load;
};

template <class These>
PULVIS_INLINE void move_four(const These& these, const PlainStep& step, const Wrap& wrap, const Load* load,
                             Parcel* parcels, const Leeway& leeway, Noticed& noticed) {
  double* records[4];
  const double* loads[4];
  for (std::size_t j = 0; j < 4; ++j) {
    records[j] = &parcels[these.parcel(j)].position.x;
    loads[j] = &load[these.load(j)].force.x;
  }
  FourParcels p(records, loads);
  FourLeeways l = these.leeways(leeway);
  kick_and_drift(p, step, noticed);
  const FourTruths wrapped = inspect(p, l, step, wrap, noticed);
  p.put(records);
  if (!any(wrapped)) return;
  noticed.wrapped |= wrapped;
  for (std::size_t j = 0; j < 4; ++j)
    leeway.reference[these.parcel(j)] = {l.reference.x[j], l.reference.y[j], l.reference.z[j]};
}

/// What tells whether the parcels two blocks behind these left their margins: that is read once in a step, too little at a
/// time for the processor to foresee.
static void ask_for_leeway(const SomeParcels& some, const Leeway& leeway) {
  if (some.list) return;
  const std::size_t next = some.first + 2 * block_size;
  ask_for(*reinterpret_cast<const Vec3(*)[block_size]>(leeway.reference + next));
  ask_for(*reinterpret_cast<const double(*)[block_size]>(leeway.margin + next));
}

static void move_parcels(const PlainStep& given, const SomeParcels& wanted, const Load* load, Parcel* parcels,
                         const Leeway& where, StepNotice& notice) {
  const PlainStep step = given;  // nobody else writes to these
  const SomeParcels some = wanted;
  const Leeway leeway = where;
  const Wrap wrap(step);
  ask_for_leeway(some, leeway);
  Noticed noticed;
  std::size_t k = 0;
  if (!some.list)
    for (; k + 4 <= some.count; k += 4)
      move_four(FourInARow(some, k), step, wrap, load, parcels, leeway, noticed);
  for (; k < some.count; k += 4) move_four(AnyFour(some, k), step, wrap, load, parcels, leeway, noticed);
  notice.too_fast |= any(noticed.too_fast);
  notice.outside |= any(noticed.outside);
  notice.wrapped |= any(noticed.wrapped);
  if (any(noticed.left)) notice.note_left(some[0], some[some.count - 1] + 1);
}

ParcelKernel parcel_kernel() { return {sum_pairs, move_parcels}; }

}  // namespace PULVIS_ISA
}  // namespace pulvis::kernels
