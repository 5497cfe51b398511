// SPDX-License-Identifier: Apache-2.0
// Pairs that were apart when the lists were made, and meet before they are made anew.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/engine/sticky_scene.hpp"
#include "validation/scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr double radius = 1e-3, dt = 1e-5;

Model box() {
  Stuff stuff;
  stuff.young_modulus = 1e6;
  Model m = one_material(stuff, {}, {0, 0, 0}, {0.1, 0.1, 0.1}, dt, radius, radius);
  m.body_force.gravity = {};
  return m;
}

/// Two that come nearer by a hundredth of a radius a step, `gap` between them, and one at rest far away: what most do
/// together is nothing, so that both have wide margins.
std::vector<Parcel> two_towards_each_other(double gap) {
  const double half = radius + 0.5 * gap;
  return {parcel(0, {0.05 - half, 0.05, 0.05}, radius, 2500.0, {0.5, 0.1, 0}),
          parcel(1, {0.05 + half, 0.05, 0.05}, radius, 2500.0, {-0.5, 0, 0}),
          parcel(2, {0.01, 0.01, 0.01}, radius, 2500.0)};
}

Vec3 force_on(const Simulation& s, std::uint32_t id) {
  const Parcels& parcels = s.state().parcels;
  for (std::size_t k = 0; k < parcels.size(); ++k)
    if (parcels.body[k].id == id) return parcels.load[k].force;
  ADD_FAILURE() << "there is no parcel " << id;
  return {};
}

TEST(PairsApart, ThatMeetTellTheirForceThoughNoPairIsClose) {
  const Model m = box();
  Simulation s(m, state_of(m, two_towards_each_other(0.2 * radius)), 1);
  ASSERT_EQ(s.pairs().first_apart(), 0u);
  ASSERT_EQ(s.pairs().slots(), 1u);
  const std::uint64_t rebuilds = s.rebuilds();
  for (int k = 0; k < 30; ++k) s.step();
  ASSERT_EQ(s.rebuilds(), rebuilds);
  ASSERT_TRUE(s.pairs().touching[0]);
  const Vec3 force = s.pairs().force_on_first(0);
  EXPECT_LT(force.x, 0.0);
  EXPECT_NE(force.y, 0.0);
  EXPECT_EQ(force, force_on(s, 0));
  EXPECT_EQ(-force, force_on(s, 1));
  EXPECT_NE(norm(s.pairs().pasts.of(0).slide), 0.0);
}

TEST(PairsApart, ThatPartAgainForgetBeforeTheListsAreMadeAnew) {
  const Model m = box();
  Simulation s(m, state_of(m, two_towards_each_other(0.2 * radius)), 1);
  const std::uint64_t rebuilds = s.rebuilds();
  bool met = false;
  for (int k = 0; k < 90; ++k) {
    s.step();
    const bool touching = s.pairs().touching[0] != 0;
    ASSERT_EQ(s.pairs().pasts.met_at(0) != nullptr, touching) << "step " << k;
    met |= touching;
  }
  ASSERT_EQ(s.rebuilds(), rebuilds);
  EXPECT_TRUE(met);
  EXPECT_FALSE(s.pairs().touching[0]);
  EXPECT_EQ(s.pairs().force_on_first(0), Vec3{});
  EXPECT_EQ(force_on(s, 0), Vec3{});
}

/// That a pair is close or apart changes no bit, of the energies neither.
void expect_same_end_close_and_apart(const LawParts& parts) {
  std::string hash;
  EnergyBalance energies;
  for (const double skin : {1.0, 100.0}) {  // of wide margins a tenth reaches across the gap
    Model m = box();
    m.classes.set(0, 0, contact_class(remembering_pair(), parts));
    m.skin = skin;
    m.energy_ledger = true;
    Simulation s(m, state_of(m, two_towards_each_other(0.2 * radius)), 1);
    EXPECT_EQ(s.pairs().first_apart() == 0, skin == 1.0);
    const std::uint64_t rebuilds = s.rebuilds();
    for (int k = 0; k < 90; ++k) s.step();
    ASSERT_EQ(s.rebuilds(), rebuilds) << "each pair stays what it was";
    for (int k = 0; k < 110; ++k) s.step();
    if (hash.empty()) {
      hash = s.hash();
      energies = *s.energy();
      EXPECT_NE(energies.lost(), 0.0);
    } else {
      EXPECT_EQ(s.hash(), hash);
      EXPECT_EQ(s.energy()->of, energies.of);
      EXPECT_EQ(s.energy()->kinetic(), energies.kinetic());
    }
  }
}

TEST(PairsApart, EndAsIfTheyHadBeenClose) { expect_same_end_close_and_apart({}); }

TEST(PairsApart, EndAsIfTheyHadBeenCloseWhereContactsRememberMoreThanSprings) {
  LawParts parts;
  parts.normal = "edinburgh";
  parts.sliding = "rescaled_spring";
  expect_same_end_close_and_apart(parts);
}

TEST(PairsApart, KeepWhatTheyRememberAndTheirForceWhenListsAreMadeAnew) {
  const Model m = box();
  const std::vector<double> margin(3, 0.5 * radius);
  Parcels parcels;
  parcels.body = two_towards_each_other(0.3 * radius);
  const PairSearch wanted{parcels, m.classes, margin, 0.0, m.domain, {}};
  NearPairs before, after;
  before.rebuild(wanted, 1);
  ASSERT_EQ(before.first_apart(), 0u);
  before.keep_forces(true);
  before.touching[0] = 1;
  const laws::Past past{{1, 2, 3}, {4, 5, 6}};
  before.pasts.met.put(0, {past, {{7, 8, 9}, {}, {}}}, 0);
  after.rebuild(wanted, 1);
  const std::vector<std::uint32_t> same{0, 1, 2};
  EXPECT_EQ(after.restore(before.pack(parcels, 1), same, parcels, 1), 1u);
  EXPECT_EQ(after.force_on_first(0), Vec3{});
  after.take_over_forces(before, same);
  EXPECT_EQ(after.force_on_first(0), (Vec3{7, 8, 9}));
  EXPECT_EQ(after.pasts.of(0).slide, past.slide);
  EXPECT_EQ(after.pasts.of(0).roll, past.roll);
}

}  // namespace
