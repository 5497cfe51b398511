// SPDX-License-Identifier: Apache-2.0
// Parcels that leave their margins between two rebuilds of the near lists, and are looked from alone.
#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <set>

#include "engine/base/failure.hpp"
#include "engine/contacts/late_search.hpp"
#include "tests/engine/sticky_scene.hpp"
#include "validation/draw.hpp"
#include "validation/scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using pulvis::validation::Draw;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Spheres in a periodic box, with lists, in two crowds that have drifted apart since these were made.
struct Listed {
  explicit Listed(std::uint64_t number) : draw(number, 31) {
    classes.set(0, 0, {});
    box.max = {draw.between(8, 30), draw.between(8, 30), draw.between(8, 30)};
    for (int axis = 0; axis < 3; ++axis) box.periodic[axis] = draw.chance(0.7);
    std::vector<std::uint32_t> id(count);
    std::iota(id.begin(), id.end(), 0u);
    for (std::size_t k = 0; k < count; ++k) {
      std::swap(id[k], id[k + static_cast<std::size_t>(draw.between(0.0, static_cast<double>(count - k)))]);
      const double radius = draw.between(0.5, 1.0);
      parcels.body.push_back(parcel(id[k], somewhere(), radius, 1.0));
      parcels.load.push_back({});
      reference.push_back(parcels.body[k].position);
      margin.push_back(draw.between(0.02, 0.5) * radius);
      crowd.push_back(draw.chance(0.5));
    }
    near.rebuild({parcels, classes, margin, reach, box, {}, crowd, between}, 2);
    drift = {Vec3{0.3, -0.2, 0.1}, Vec3{0.3, -0.2, 0.1} + 0.9 * between * Vec3{0.6, 0.0, -0.8}};
  }

  Vec3 somewhere() {
    return {draw.between(0, box.max.x), draw.between(0, box.max.y), draw.between(0, box.max.z)};
  }

  void put_somewhere_else(std::uint32_t i, LateSearch& search) {
    parcels.body[i].position = somewhere();
    crowd[i] = draw.chance(0.5);
    reference[i] = parcels.body[i].position - drift[crowd[i]];
    margin[i] = draw.between(0.02, 0.5) * parcels.body[i].radius;
    const Leeway leeway{reference.data(), margin.data(), crowd.data()};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    search.look_from(i, {parcels, leeway, drift, reach, between, between, 1.5, box}, found);
    near.add(found, parcels);
  }

  bool may_meet(std::size_t i, std::size_t j) const {
    const Vec3 d = NearestImage::of(box)(reference[j] + drift[crowd[j]] - reference[i] - drift[crowd[i]]);
    return norm(d) < parcels.body[i].radius + parcels.body[j].radius + margin[i] + margin[j] + reach +
                         (crowd[i] != crowd[j] ? between : 0.0) - 1e-9;
  }

  static constexpr std::size_t count = 400;
  static constexpr double reach = 0.1, between = 0.7;
  Draw draw;
  ContactClasses classes{1};
  Box box;
  Parcels parcels;
  std::vector<Vec3> reference;
  std::vector<double> margin;
  std::vector<std::uint8_t> crowd;
  Drift drift;
  NearPairs near;
};

TEST(PairsListedLate, AreThoseOfBruteForce) {
  for (std::uint64_t number = 0; number < 20; ++number) {
    Listed all(number);
    LateSearch search;
    std::set<std::uint32_t> moved;
    for (int k = 0; k < 60; ++k) {
      const auto i = static_cast<std::uint32_t>(all.draw.between(0.0, all.count));
      all.put_somewhere_else(i, search);
      moved.insert(i);
      if (k % 20 == 19) all.near.settle_late(all.parcels);
    }
    Pairs listed;
    for (std::size_t s = 0; s < all.near.slots(); ++s)
      if (all.near.is_pair(s)) {
        ASSERT_LT(all.parcels.body[all.near.first[s]].id, all.parcels.body[all.near.second[s]].id);
        ASSERT_TRUE(listed.insert(std::minmax(all.near.first[s], all.near.second[s])).second);
      }
    EXPECT_GT(all.near.slots(), all.near.first_late());
    for (const std::uint32_t i : moved)
      for (std::uint32_t j = 0; j < all.count; ++j)
        if (j != i && all.may_meet(i, j)) {
          ASSERT_TRUE(listed.count(std::minmax(i, j))) << i << " and " << j << " of " << number;
        }
  }
}

TEST(PairsListedLate, StandInTheListsOfTheirParcelsByThePartnersIds) {
  for (std::uint64_t number = 100; number < 110; ++number) {
    Listed all(number);
    LateSearch search;
    for (int k = 0; k < 50; ++k)
      all.put_somewhere_else(static_cast<std::uint32_t>(all.draw.between(0.0, all.count)), search);
    const std::size_t before = all.near.entry.size();
    all.near.settle_late(all.parcels);
    EXPECT_GT(all.near.entry.size(), before);
    std::vector<int> seen(2 * all.near.slots(), 0);
    for (std::size_t i = 0; i < all.count; ++i) {
      std::int64_t last = -1;
      for (std::uint32_t k = all.near.begin[i]; k < all.near.begin[i + 1]; ++k) {
        const std::uint32_t slot = all.near.entry[k] >> 1;
        const bool is_second = all.near.entry[k] & 1u;
        ASSERT_EQ(is_second ? all.near.second[slot] : all.near.first[slot], i);
        const std::int64_t partner =
            all.parcels.body[is_second ? all.near.first[slot] : all.near.second[slot]].id;
        ASSERT_GT(partner, last);
        last = partner;
        ++seen[all.near.entry[k]];
      }
    }
    for (std::size_t e = 0; e < seen.size(); ++e) ASSERT_EQ(seen[e], all.near.is_pair(e / 2) ? 1 : 0);
  }
}

/// A bed of two layers on a floor that shakes, and rain that comes down on it, fast against what lies; some of it flies up
/// instead and leaves the domain.
Model rain_on_a_bed(const LawParts& parts, bool energy_ledger) {
  Stuff stuff;
  stuff.work_of_adhesion = parts.normal == "jkr" ? 0.05 : 0.0;
  Model m = yardstick_model(stuff, parts, 0.03, 0.03);
  m.walls.bodies[0].motions = {0};
  m.motions = {{motions::Sine{{2e-4, 50.0, -0.25}, {0, 0, 1}}}};
  m.parcels_per_thread = 1;
  m.energy_ledger = energy_ledger;
  return m;
}

State rain_over(const Model& m) {
  std::vector<Parcel> all;
  Draw draw(1, 33);
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 9; ++x) {
        const bool rains = z > 1;
        const Vec3 at{0.0033 * x + draw.between(0.0013, 0.0018), 0.0033 * y + draw.between(0.0013, 0.0018),
                      0.00126 + 0.0031 * z + (rains ? 0.004 : 0.0)};
        all.push_back(parcel(static_cast<std::uint32_t>(all.size()), at, 0.00125, 2500.0,
                             {0, 0,
                              !rains                 ? 0.0
                              : z == 4 && x % 4 == 0 ? 3.0
                                                     : draw.between(-2.1, -1.9)}));
      }
  for (Parcel& p : all) p.species = m.classes.all().size() > 1 ? p.id % 2 : 0;
  State s = state_of(m, all);
  s.motions[0] = {true, 0, {}};
  return s;
}

/// The oracle: lists are made anew in every step, since a state knows nothing of them.
void expect_end_of_lists_made_in_every_step(const Model& m) {
  constexpr int steps = 600;
  State anew = rain_over(m);
  std::optional<EnergyBalance> energy;
  std::string hash;
  for (int k = 0; k < steps; ++k) {
    Simulation s(m, std::move(anew), 1);
    s.step();
    anew = s.snapshot();
    if (k + 1 == steps) hash = s.hash(), energy = s.energy();
  }
  for (const int threads : {1, 2, 3}) {
    Simulation s(m, rain_over(m), threads);
    for (int k = 1; k <= steps; ++k)
      s.step(k % 16 && k < steps ? Simulation::Then::go_on : Simulation::Then::look);
    EXPECT_GT(s.relisted(), 100u) << "or it shows nothing";
    EXPECT_GT(s.state().escapes.size(), 10u);
    EXPECT_LT(s.rebuilds(), steps / 20);
    EXPECT_EQ(s.hash(), hash);
    if (m.energy_ledger) {
      EXPECT_EQ(s.energy()->of, energy->of);
    }
  }
}

TEST(Relisting, EndsAsListsMadeInEveryStep) {
  expect_end_of_lists_made_in_every_step(rain_on_a_bed({}, false));
}

TEST(Relisting, EndsAsListsMadeInEveryStepOfSpeciesThatRememberMoreThanSprings) {
  LawParts parts;
  parts.normal = "edinburgh";
  parts.sliding = "rescaled_spring";
  Model m = rain_on_a_bed({}, false);
  laws::MaterialPair pair = remembering_pair();
  m.classes = ContactClasses(2);
  for (const auto& [a, b] : {std::pair{0u, 0u}, {0u, 1u}, {1u, 1u}}) {
    pair.friction = 0.2 + 0.1 * (a + b);
    m.classes.set(a, b, contact_class(pair, parts));
  }
  expect_end_of_lists_made_in_every_step(m);
}

TEST(Relisting, EndsAsListsMadeInEveryStepAndSoDoEnergies) {
  LawParts parts;
  parts.normal = "jkr";
  expect_end_of_lists_made_in_every_step(rain_on_a_bed(parts, true));
}

TEST(PairsListedLate, AreNotForgottenByWhoeverPacksContacts) {
  Listed all(200);
  LateSearch search;
  for (std::uint32_t i = 0; i < 20; ++i) all.put_somewhere_else(i, search);
  EXPECT_THROW(all.near.pack(all.parcels, 1), Failure);
  all.near.settle_late(all.parcels);
  EXPECT_NO_THROW(all.near.pack(all.parcels, 1));
}

TEST(Relisting, MissesWhatTheListOfWallsDoesNotHave) {
  Model m = yardstick_model({}, {}, 0.03, 0.1);
  Parcels parcels;
  for (const double gap : {0.1, 3.0}) {  // radii from the floor
    parcels.body.push_back(parcel(
        static_cast<std::uint32_t>(parcels.size()),
        {0.01 * static_cast<double>(1 + parcels.size()), 0.01, (1.0 + gap) * 0.00125}, 0.00125, 2500.0));
    parcels.load.push_back({});
  }
  const std::vector<Pose> poses(1);
  std::vector<double> margin(2, 0.02 * 0.00125);
  const std::vector<double> body_margin(1, 0.02 * 0.00125);
  const std::vector<std::uint8_t> crowd(2, 0), body_crowd(1, 0);
  const WallSearch wanted{parcels, m.walls, poses, margin, crowd, body_margin, body_crowd, 0.0, 0.0};
  NearWalls near;
  near.rebuild(wanted, 1);
  ASSERT_EQ(near.slots(), 1u);
  for (const double radii : {0.5, 2.9, 3.1}) {
    margin.assign(2, radii * 0.00125);
    EXPECT_FALSE(near.would_miss(0, wanted));
    EXPECT_EQ(near.would_miss(1, wanted), radii > 2.96) << radii;
  }
}

}  // namespace
