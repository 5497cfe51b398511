// SPDX-License-Identifier: Apache-2.0
// Cell lists and pairs against brute force over all pairs and all 27 images.
#include "engine/contacts/near_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "engine/contacts/cell_grid.hpp"
#include "validation/draw.hpp"
#include "validation/scene.hpp"

using namespace pulvis;
using pulvis::validation::Draw;

namespace {

struct Packing {
  Box box;
  Slide slide;
  Parcels parcels;
  std::vector<double> margin;
  double reach = 0.0;
  std::vector<std::uint8_t> crowd{};
  double between_crowds = 0.0;

  PairSearch wanted(const ContactClasses& classes) const {
    return {parcels, classes, margin, reach, box, slide, crowd, between_crowds};
  }
};

/// Random overlapping spheres of radii 1 : `ratio`, in a box of 3 to 12 of the largest distances at which a
/// pair counts; along periodic axes down to `smallest_period` of them. Ids are in no order.
Packing random_packing(std::uint64_t number, const bool (&periodic)[3], std::size_t count,
                       double smallest_period) {
  Draw draw(number, 21);
  Packing p;
  const double ratio = draw.between(1.0, 6.0);
  p.reach = draw.chance(0.5) ? 0.0 : draw.between(0.0, 0.3);
  const double cutoff = 2.0 * (1.6 * ratio) + p.reach;
  for (int axis = 0; axis < 3; ++axis) {
    p.box.periodic[axis] = periodic[axis];
    p.box.min[axis] = draw.between(-50.0, 50.0);
    p.box.max[axis] = p.box.min[axis] + cutoff * draw.between(periodic[axis] ? smallest_period : 0.5, 4.0);
  }
  std::vector<std::uint32_t> id(count);
  std::iota(id.begin(), id.end(), 0u);
  for (std::size_t k = 0; k < count; ++k) {
    std::swap(id[k], id[k + static_cast<std::size_t>(draw.between(0.0, static_cast<double>(count - k)))]);
    Parcel q;
    q.id = id[k];
    q.radius = draw.between(1.0, ratio);
    for (int axis = 0; axis < 3; ++axis) {
      q.position[axis] = draw.between(p.box.min[axis], p.box.max[axis]);
      // Some lie on the rim itself, which counts as inside.
      if (draw.chance(0.01)) q.position[axis] = draw.chance(0.5) ? p.box.min[axis] : p.box.max[axis];
    }
    p.parcels.body.push_back(q);
    p.parcels.load.push_back({});
    p.margin.push_back(q.radius * draw.between(0.02, 0.6));
  }
  return p;
}

/// Shortest distance between any two images.
double shortest(const Packing& p, std::size_t i, std::size_t j) {
  const Vec3 d = p.parcels.body[j].position - p.parcels.body[i].position, extent = p.box.extent();
  double best = 1e300;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if ((x && !p.box.periodic[0]) || (y && !p.box.periodic[1]) || (z && !p.box.periodic[2])) continue;
        const int cell[3] = {x, y, z};
        Vec3 image = d + Vec3{x * extent.x, y * extent.y, z * extent.z};
        image[p.slide.flow] += cell[p.slide.gradient] * p.slide.shift;
        best = std::min(best, norm(image));
      }
  return best;
}

const ContactClasses one_class = [] {
  ContactClasses classes(1);
  classes.set(0, 0, {});
  return classes;
}();

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

void expect_pairs_of_brute_force(const Packing& p, int threads) {
  NearPairs near;
  near.rebuild(p.wanted(one_class), threads);
  Pairs found;
  for (std::size_t s = 0; s < near.slots(); ++s) {
    if (!near.is_pair(s)) continue;
    const auto a = p.parcels.body[near.first[s]].id, b = p.parcels.body[near.second[s]].id;
    ASSERT_LT(a, b) << "the first of a pair has the lower id";
    ASSERT_TRUE(found.insert({a, b}).second) << "a pair has one slot";
  }
  const auto& body = p.parcels.body;
  for (std::size_t i = 0; i < body.size(); ++i)
    for (std::size_t j = i + 1; j < body.size(); ++j) {
      const double far = body[i].radius + body[j].radius + p.margin[i] + p.margin[j] + p.reach +
                         (p.between_crowds > 0.0 && p.crowd[i] != p.crowd[j] ? p.between_crowds : 0.0),
                   d = shortest(p, i, j);
      if (std::fabs(d - far) < 1e-9) continue;
      const std::pair key{std::min(body[i].id, body[j].id), std::max(body[i].id, body[j].id)};
      ASSERT_EQ(found.count(key) == 1, d < far)
          << "parcels " << i << " and " << j << " at " << d << " of " << far;
    }
  // Each parcel lists its slots by the partner's id.
  std::size_t entries = 0;
  for (std::size_t i = 0; i < body.size(); ++i) {
    std::int64_t last = -1;
    for (std::uint32_t k = near.begin[i]; k < near.begin[i + 1]; ++k, ++entries) {
      const std::uint32_t slot = near.entry[k] >> 1;
      const bool is_second = near.entry[k] & 1u;
      ASSERT_EQ(is_second ? near.second[slot] : near.first[slot], i);
      const std::int64_t partner = body[is_second ? near.first[slot] : near.second[slot]].id;
      ASSERT_GT(partner, last);
      last = partner;
    }
  }
  ASSERT_EQ(entries, 2 * found.size());
}

constexpr bool open_box[3] = {false, false, false}, column[3] = {false, true, false},
               all_around[3] = {true, true, true};

TEST(NearPairs, AreThoseOfBruteForceInAnOpenBox) {
  for (std::uint64_t k = 0; k < 20; ++k)
    expect_pairs_of_brute_force(random_packing(k, open_box, 400, 2.0), 1);
}
TEST(NearPairs, AreThoseOfBruteForceWithOnePeriodicAxis) {
  for (std::uint64_t k = 0; k < 20; ++k)
    expect_pairs_of_brute_force(random_packing(100 + k, column, 400, 2.0), 1);
}
TEST(NearPairs, AreThoseOfBruteForceWithThreePeriodicAxes) {
  for (std::uint64_t k = 0; k < 20; ++k)
    expect_pairs_of_brute_force(random_packing(200 + k, all_around, 400, 2.0), 1);
}
TEST(NearPairs, AreThoseOfBruteForceInPeriodicBoxesOfOneAndTwoCells) {
  for (std::uint64_t k = 0; k < 60; ++k)
    expect_pairs_of_brute_force(random_packing(300 + k, all_around, 60, 0.3), 1);
}
/// Most are small and have narrow margins, so that cells are; a few reach much farther.
Packing random_uneven_packing(std::uint64_t number, const bool (&periodic)[3], std::size_t count) {
  Packing p = random_packing(number, periodic, count, 0.3);
  Draw draw(number, 27);
  for (std::size_t k = 0; k < count; ++k) {
    if (draw.chance(0.04)) continue;
    p.parcels.body[k].radius = draw.between(1.0, 1.2);
    p.margin[k] = draw.between(0.02, 0.05);
  }
  return p;
}

TEST(NearPairs, AreThoseOfBruteForceWhereFewReachFar) {
  for (std::uint64_t k = 0; k < 30; ++k)
    expect_pairs_of_brute_force(random_uneven_packing(900 + k, k % 2 ? open_box : all_around, 600),
                                1 + static_cast<int>(k % 3));
}
TEST(NearPairs, AreThoseOfBruteForceInTwoCrowds) {
  for (std::uint64_t k = 0; k < 40; ++k) {
    Packing p = random_uneven_packing(950 + k, k % 2 ? column : all_around, 500);
    Draw draw(k, 29);
    p.between_crowds = draw.between(0.1, 6.0);
    for (std::size_t i = 0; i < p.parcels.size(); ++i) p.crowd.push_back(draw.chance(0.5));
    expect_pairs_of_brute_force(p, 1 + static_cast<int>(k % 3));
  }
}
TEST(NearPairs, AreTheSameForAnyNumberOfThreads) {
  for (std::uint64_t k = 0; k < 5; ++k) {
    const Packing p = random_packing(400 + k, column, 1000, 1.0);
    const PairSearch wanted{p.parcels, one_class, p.margin, p.reach, p.box, p.slide};
    NearPairs one, two, three;
    one.rebuild(wanted, 1);
    two.rebuild(wanted, 2);
    three.rebuild(wanted, 3);
    expect_pairs_of_brute_force(p, 3);
    for (const NearPairs* other : {&two, &three}) {
      EXPECT_EQ(one.first, other->first);
      EXPECT_EQ(one.second, other->second);
      EXPECT_EQ(one.begin, other->begin);
      EXPECT_EQ(one.entry, other->entry);
    }
  }
}
TEST(NearPairs, LieInTheGroupOfTheirClassAndOfTheirDistance) {
  ContactClasses classes(2);
  classes.set(0, 0, {});
  classes.set(0, 1, {});
  classes.set(1, 1, {});
  Packing p = random_packing(510, column, 500, 2.0);
  for (Parcel& q : p.parcels.body) q.species = q.id % 2;
  NearPairs near;
  near.rebuild({p.parcels, classes, p.margin, p.reach, p.box, p.slide}, 2);
  ASSERT_EQ(near.groups(), 6u);
  for (std::size_t group = 0; group < near.groups(); ++group) {
    EXPECT_LT(near.group_begin[group], near.group_end[group]);
    for (std::size_t slot = near.group_begin[group]; slot < near.group_end[group]; ++slot) {
      const Parcel &a = p.parcels.body[near.first[slot]], &b = p.parcels.body[near.second[slot]];
      ASSERT_EQ(near.class_of(group), classes.index(a.species, b.species));
      const double gap = shortest(p, near.first[slot], near.second[slot]) - a.radius - b.radius - p.reach;
      const double margins = p.margin[near.first[slot]] + p.margin[near.second[slot]];
      ASSERT_EQ(near.are_apart(group), gap > 0.1 * margins) << gap / margins;
    }
  }
}
TEST(NearPairs, AreNoneAmongNoneAndOneParcel) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}}) {
    const Packing p = random_packing(500, all_around, count, 2.0);
    NearPairs near;
    near.rebuild({p.parcels, one_class, p.margin, p.reach, p.box, p.slide}, 2);
    EXPECT_EQ(near.slots(), 0u);
    EXPECT_EQ(near.begin.size(), count + 1);
  }
}

/// Goes through a step as threads do, one after the other: the loads of a slot must still lie in their places when its parcels
/// are summed up, and in nobody else's way.
void expect_loads_stay_while_they_are_needed(const NearPairs& near) {
  constexpr std::size_t nobody = ~std::size_t{0};
  constexpr std::uint32_t numbers = kernels::Places::numbers;
  std::vector<std::size_t> holder(near.load.size(), nobody);
  std::vector<bool> done(near.begin.size() - 1, false);
  std::size_t evaluated = 0, summed = 0;
  const auto sum_up = [&](std::size_t i) {
    done[i] = true;
    std::uint32_t at = near.runs[i].begin;
    for (std::uint32_t k = near.begin[i]; k < near.begin[i + 1]; ++k) {
      const std::size_t slot = near.entry[k] >> 1;
      if (slot >= near.first_apart()) continue;
      ASSERT_EQ(near.entry[k] & 1u ? near.places[slot].second : near.places[slot].first, at * numbers);
      ASSERT_EQ(holder[at], near.entry[k]);
      holder[at++] = nobody, ++summed;
    }
    ASSERT_EQ(at, near.runs[i].begin + near.runs[i].count);
  };
  for (int part = 0; part < near.shares(); ++part) {
    std::vector<std::size_t> cursors(near.groups());
    near.go_through(
        part, cursors,
        [&](std::size_t group, std::size_t slots_from, std::size_t slots_to) {
          for (std::size_t slot = slots_from; slot < slots_to; ++slot) ASSERT_EQ(near.part_of(slot), part);
          if (near.are_apart(group)) return;
          for (std::size_t slot = slots_from; slot < slots_to; ++slot) {
            const std::uint32_t of_first = near.places[slot].first / numbers,
                                of_second = near.places[slot].second / numbers;
            ASSERT_EQ(holder[of_first], nobody) << "slot " << slot << " of " << near.slots();
            ASSERT_EQ(holder[of_second], nobody) << "slot " << slot << " of " << near.slots();
            holder[of_first] = 2 * slot, holder[of_second] = 2 * slot + 1;
            ++evaluated;
          }
        },
        [&](std::size_t from, std::size_t to) {
          for (std::size_t i = from; i < to; ++i)
            if (!near.divided(i)) sum_up(i);
        });
  }
  std::size_t divided = 0;
  for (int part = 0; part < near.shares(); ++part)
    for (const std::uint32_t i : near.divided_ones(part)) {
      ASSERT_TRUE(near.divided(i));
      sum_up(i);
      ++divided;
    }
  EXPECT_EQ(divided > 0, near.shares() > 1);
  EXPECT_EQ(std::count(done.begin(), done.end(), true), static_cast<std::ptrdiff_t>(done.size()));
  std::size_t pairs = 0;
  for (std::size_t slot = 0; slot < near.first_apart(); ++slot) pairs += near.is_pair(slot);
  EXPECT_EQ(evaluated, pairs);
  EXPECT_EQ(summed, 2 * pairs);
}

TEST(NearPairs, LoadsStayInTheirPlacesWhileTheyAreNeeded) {
  std::size_t loads = 0, pairs = 0;
  for (std::uint64_t number = 0; number < 4; ++number) {
    Packing p = random_packing(600 + number, column, 4000, 2.0);
    std::sort(p.parcels.body.begin(), p.parcels.body.end(),  // the store is sorted along space
              [](const Parcel& a, const Parcel& b) { return a.position.x < b.position.x; });
    for (const int threads : {1, 2, 3}) {
      NearPairs near;
      near.rebuild({p.parcels, one_class, p.margin, p.reach, p.box, p.slide}, threads);
      expect_loads_stay_while_they_are_needed(near);
      if (HasFatalFailure()) return;
      if (threads == 1) loads += near.load.size(), pairs += near.first_apart();
    }
  }
  EXPECT_LT(static_cast<double>(loads), 0.9 * 2.0 * static_cast<double>(pairs)) << "places are used again";
}

/// The same sheared: flow and gradient along any two axes, images shifted by up to half of the box.
Packing random_sheared_packing(std::uint64_t number, std::size_t count, double smallest_period) {
  Packing p = random_packing(number, all_around, count, smallest_period);
  Draw draw(number, 23);
  p.box.shear.flow = static_cast<int>(number % 3);
  p.box.shear.gradient = static_cast<int>((number + 1 + number / 3 % 2) % 3);
  p.box.shear.shift_at_start = p.box.extent()[p.box.shear.flow] * draw.between(-3.0, 3.0);
  p.slide = Slide::of(p.box, 0.0);
  return p;
}

TEST(NearPairs, AreThoseOfBruteForceInASlidingBox) {
  for (std::uint64_t k = 0; k < 60; ++k)
    expect_pairs_of_brute_force(random_sheared_packing(800 + k, 400, 2.0), 1 + static_cast<int>(k % 3));
}

/// Of blocks of pairs, full ones and the last, by every instruction set this processor has.
void expect_glance_of_brute_force(const Packing& p, std::uint64_t number) {
  Draw draw(number, 25);
  NearPairs near;
  near.rebuild({p.parcels, one_class, p.margin, p.reach, p.box, p.slide}, 1);
  for (std::uint8_t& touching : near.touching) touching = draw.chance(0.05);
  const double approach = draw.chance(0.5) ? 0.0 : draw.between(0.0, 0.5);
  const Images images{NearestImage::of(p.box), p.slide};
  for (int set = 0; set <= static_cast<int>(kernels::instruction_set()); ++set) {
    const kernels::ContactKernel kernel =
        kernels::contact_kernel(scenes::law_of({}), static_cast<kernels::InstructionSet>(set));
    for (std::size_t begin = near.first_apart(); begin < near.slots(); begin += kernels::block_size) {
      const auto count = static_cast<int>(std::min<std::size_t>(kernels::block_size, near.slots() - begin));
      std::uint8_t met[kernels::block_size];
      const int found = kernel.glance(near.some(begin, count), p.parcels.body.data(), images, approach, met);
      std::vector<std::uint8_t> expected;
      for (int k = 0; k < count; ++k) {
        const std::size_t slot = begin + static_cast<std::size_t>(k);
        const Parcel &a = p.parcels.body[near.first[slot]], &b = p.parcels.body[near.second[slot]];
        if (near.touching[slot] || norm(images(b.position - a.position)) < a.radius + b.radius + approach)
          expected.push_back(static_cast<std::uint8_t>(k));
      }
      ASSERT_EQ(std::vector<std::uint8_t>(met, met + found), expected);
    }
  }
}

TEST(NearPairs, GlanceFindsThoseApartThatMeetOrAreInReach) {
  for (std::uint64_t k = 0; k < 20; ++k) {
    expect_glance_of_brute_force(random_packing(1000 + k, column, 700, 2.0), k);
    expect_glance_of_brute_force(random_sheared_packing(1100 + k, 700, 2.0), k);
  }
}

TEST(CellGrid, RangesAroundACellOfASlidingBoxHoldEveryPointWithinTheEdgeExactlyOnce) {
  for (std::uint64_t number = 0; number < 60; ++number) {
    Draw draw(number, 24);
    const Packing p = random_sheared_packing(900 + number, 300, 0.3);
    const double edge = draw.between(0.5, 5.0);
    CellGrid grid;
    grid.build(p.box, edge, p.parcels.size(), [&](std::size_t k) { return p.parcels.body[k].position; });
    for (std::size_t i = 0; i < p.parcels.size(); ++i) {
      std::map<std::uint32_t, int> seen;
      grid.for_ranges_around(grid.cell_of(i), p.slide, [&](std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t k = from; k < to; ++k) ++seen[grid.order()[k]];
      });
      for (const auto& [point, times] : seen) ASSERT_EQ(times, 1);
      for (std::size_t j = 0; j < p.parcels.size(); ++j)
        if (shortest(p, i, j) < edge * (1.0 - 1e-12)) {
          ASSERT_EQ(seen.count(static_cast<std::uint32_t>(j)), 1u);
        }
    }
  }
}

TEST(CellGrid, RangesAroundACellHoldEveryPointWithinTheEdgeExactlyOnce) {
  for (std::uint64_t number = 0; number < 40; ++number) {
    Draw draw(number, 22);
    const bool periodic[3] = {draw.chance(0.5), draw.chance(0.5), draw.chance(0.5)};
    const Packing p = random_packing(600 + number, periodic, 300, 0.3);
    const double edge = draw.between(0.5, 5.0);
    CellGrid grid;
    grid.build(p.box, edge, p.parcels.size(), [&](std::size_t k) { return p.parcels.body[k].position; });
    for (std::size_t i = 0; i < p.parcels.size(); ++i) {
      std::map<std::uint32_t, int> seen;
      grid.for_ranges_around(grid.cell_of(i), [&](std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t k = from; k < to; ++k) ++seen[grid.order()[k]];
      });
      for (const auto& [point, times] : seen) ASSERT_EQ(times, 1);
      for (std::size_t j = 0; j < p.parcels.size(); ++j)
        if (shortest(p, i, j) < edge * (1.0 - 1e-12)) {
          ASSERT_EQ(seen.count(static_cast<std::uint32_t>(j)), 1u);
        }
    }
  }
}

TEST(ContactHistory, SurvivesARebuildInAnotherOrder) {
  Packing p = random_packing(700, column, 600, 1.0);
  NearPairs near;
  near.rebuild({p.parcels, one_class, p.margin, p.reach, p.box, p.slide}, 1);
  // Every third pair touches and remembers numbers of its own.
  const auto memory = [](std::uint32_t a, std::uint32_t b) {
    return laws::Past{{a * 1.0, b * 1.0, a * 1e3 + b}, {b * 2.0, a * 3.0, 1.0}};
  };
  std::size_t count = 0;
  for (std::size_t s = 0; s < near.slots(); s += 3) {
    if (!near.is_pair(s)) continue;
    ++count;
    near.touching[s] = 1;
    near.set_past(s, memory(p.parcels.body[near.first[s]].id, p.parcels.body[near.second[s]].id));
  }
  const TouchingList list = near.pack(p.parcels, 2);
  ASSERT_EQ(list.size(), count);

  // Sorted by id, and with two new parcels between them.
  std::vector<std::uint32_t> old_index(p.parcels.size());
  std::iota(old_index.begin(), old_index.end(), 0u);
  std::sort(old_index.begin(), old_index.end(),
            [&](std::uint32_t a, std::uint32_t b) { return p.parcels.body[a].id < p.parcels.body[b].id; });
  old_index.insert(old_index.begin() + 100, NearPairs::no_parcel);
  old_index.push_back(NearPairs::no_parcel);
  Parcels moved;
  std::vector<double> margin;
  std::uint32_t fresh = 5000;
  for (const std::uint32_t k : old_index) {
    const std::uint32_t source = k == NearPairs::no_parcel ? 0u : k;
    moved.body.push_back(p.parcels.body[source]);
    if (k == NearPairs::no_parcel) moved.body.back().id = fresh++;
    margin.push_back(1.1 * p.margin[source]);  // and with other lists
  }
  moved.load.resize(moved.body.size());
  for (const int threads : {1, 2, 3}) {
    NearPairs after;
    after.rebuild({moved, one_class, margin, p.reach, p.box, p.slide}, threads);
    EXPECT_EQ(after.restore(list, old_index, moved, threads), count);
    std::size_t touching = 0;
    for (std::size_t s = 0; s < after.slots(); ++s) {
      if (!after.touching[s]) continue;
      ++touching;
      const auto expected = memory(moved.body[after.first[s]].id, moved.body[after.second[s]].id);
      ASSERT_EQ(after.pasts.of(s).slide, expected.slide);
      ASSERT_EQ(after.pasts.of(s).roll, expected.roll);
    }
    EXPECT_EQ(touching, count);
  }
}

}  // namespace
