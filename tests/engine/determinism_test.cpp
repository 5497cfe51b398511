// SPDX-License-Identifier: Apache-2.0
// The state after many steps must depend on the model and the start only: not on threads, lists, instruction
// set, order in the store, or on having been saved and loaded.
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/base/failure.hpp"
#include "tests/engine/sticky_scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

std::string hash_after(Simulation s, std::uint64_t steps = sticky_steps) {
  go(s, steps);
  return state_hash(s.snapshot());
}

/// The result all others are held against: one thread, skin 1, the best instruction set.
const std::string& plain_hash() {
  static const std::string hash = hash_after(sticky_start(1));
  return hash;
}

TEST(StateHash, SceneIsWorthTheTrouble) {
  Simulation s = sticky_start(1);
  std::size_t stretched = 0;
  for (std::uint64_t k = 0; k < sticky_steps; ++k) {
    s.step();
    if (k % 100) continue;
    for (std::size_t slot = 0; slot < s.pairs().slots(); ++slot) {
      const Parcel &p = s.state().parcels.body[s.pairs().first[slot]],
                   &q = s.state().parcels.body[s.pairs().second[slot]];
      const Vec3 d = NearestImage::of(s.model().domain)(q.position - p.position);
      stretched += s.pairs().touching[slot] && norm(d) > p.radius + q.radius;
    }
  }
  EXPECT_EQ(s.state().ledger.inserted, 600u);
  EXPECT_EQ(s.state().parcels.size() + s.state().ledger.escaped, 600u);
  EXPECT_EQ(s.state().ledger.escaped, 0u);
  EXPECT_GT(touching(s.pairs()), 900u);
  EXPECT_GT(touching(s.walls()), 50u);
  EXPECT_GT(stretched, 100u);
  EXPECT_GT(s.rebuilds(), 64u) << "the store is sorted several times";
  EXPECT_EQ(state_hash(s.snapshot()), plain_hash());
}

TEST(StateHash, IsTheSameForTwoAndThreeThreads) {
  for (const int threads : {2, 3}) {
    Simulation s = sticky_start(threads);
    ASSERT_EQ(s.threads(), threads) << "the threads must be used for the test to mean anything";
    EXPECT_EQ(hash_after(std::move(s)), plain_hash());
  }
}

TEST(StateHash, IsTheSameWhereNobodyLooksBetweenSteps) {
  for (const int threads : {1, 2, 3}) {
    Simulation s = sticky_start(threads);
    for (std::uint64_t k = 1; k <= sticky_steps; ++k)
      s.step(k % 37 == 0 || k == sticky_steps ? Simulation::Then::look : Simulation::Then::go_on);
    EXPECT_EQ(s.hash(), plain_hash()) << threads << " threads";
  }
}

TEST(StateHash, IsNotToBeHadInTheMiddleOfAStep) {
  Simulation s = sticky_start(1);
  go(s, sticky_steps);  // the rain is over
  s.step(Simulation::Then::go_on);
  EXPECT_THROW(s.hash(), Failure);
  EXPECT_THROW(s.snapshot(), Failure);
  s.step();
  EXPECT_NO_THROW(s.hash());
}

TEST(NearLists, OfABedThatMovesAsOneAreRenewedAsRarelyAsOfOneAtRest) {
  // Far from walls, and without gravity: only what parcels do against each other should count.
  const auto rebuilds = [](const Vec3& together) {
    Model m = sticky_model();
    m.walls = {};
    m.motions.clear();
    m.sources.clear();
    m.domain = {{-1, -1, -1}, {1, 1, 1}};
    m.body_force.gravity = {};
    auto parcels = sticky_parcels();
    for (Parcel& p : parcels) p.velocity += together;
    Simulation s(m, state_of(m, parcels), 1);
    go(s, 2000);
    return s.rebuilds();
  };
  const auto at_rest = rebuilds({}), moving = rebuilds({3, -2, 1});
  EXPECT_GT(at_rest, 10u);
  EXPECT_NEAR(static_cast<double>(moving), static_cast<double>(at_rest), 0.1 * static_cast<double>(at_rest));
}

TEST(StateHash, IsTheSameForHalfAndTwiceTheSkin) {
  EXPECT_EQ(hash_after(sticky_start(1, 0.5)), plain_hash());
  EXPECT_EQ(hash_after(sticky_start(1, 2.0)), plain_hash());
}

TEST(StateHash, IsTheSameForEveryInstructionSet) {
  const std::string expected = plain_hash();
  for (const char* set : {"baseline", "avx2", "avx512"}) {
    setenv("PULVIS_INSTRUCTION_SET", set, 1);
    EXPECT_EQ(hash_after(sticky_start(1)), expected) << set;
  }
  unsetenv("PULVIS_INSTRUCTION_SET");
}

TEST(StateHash, IsTheSameAfterSavingAndLoadingOnTheWay) {
  for (const std::uint64_t moment :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1777}, sticky_steps - 1}) {
    Simulation first = sticky_start(1);
    go(first, moment);
    const auto bytes = save_state(first.snapshot());
    Simulation second(sticky_model(0.7), load_state(bytes), 2);
    EXPECT_EQ(state_hash(second.snapshot()), state_hash(first.snapshot()));
    EXPECT_EQ(hash_after(std::move(second), sticky_steps - moment), plain_hash())
        << "saved at step " << moment;
  }
}

TEST(StateHash, IsTheSameForAnyOrderOfTheStore) {
  auto parcels = sticky_parcels();
  for (std::size_t k = 0; k < parcels.size(); ++k)
    std::swap(parcels[k], parcels[(k * 7919) % parcels.size()]);
  EXPECT_EQ(hash_after(sticky_start(1, 1.0, parcels)), plain_hash());
  std::sort(parcels.begin(), parcels.end(), [](const Parcel& a, const Parcel& b) { return a.id > b.id; });
  EXPECT_EQ(hash_after(sticky_start(2, 1.0, parcels)), plain_hash());
}

/// The scene with a law whose contacts remember more than springs, and bridges that reach across gaps beside it.
Simulation remembering_start(int threads, double skin, const char* normal, const char* cohesion) {
  Model m = sticky_model(skin);
  laws::MaterialPair pair = remembering_pair();
  LawParts parts;
  parts.normal = normal;
  parts.sliding = "rescaled_spring";
  parts.cohesion = cohesion;
  m.classes = ContactClasses(1);
  m.classes.set(0, 0, contact_class(pair, parts));
  Simulation s(m, state_of(m, sticky_parcels()), threads);
  s.open_source(0);
  s.start_motion(0);
  return s;
}

TEST(StateHash, IsTheSameForLawsThatRememberMoreAndReachFurther) {
  for (const auto& [normal, cohesion] : {std::pair{"edinburgh", "none"}, {"hertz", "capillary_willett"}}) {
    const std::string plain = hash_after(remembering_start(1, 1.0, normal, cohesion), 2000);
    EXPECT_EQ(hash_after(remembering_start(3, 0.5, normal, cohesion), 2000), plain) << normal;
    Simulation first = remembering_start(1, 2.0, normal, cohesion);
    go(first, 1234);
    const State saved = load_state(save_state(first.snapshot()));
    ASSERT_GT(saved.pairs.size(), 100u);
    EXPECT_EQ(saved.pairs.memory.list.size(), saved.pairs.size());
    const Simulation scene = remembering_start(1, 1.0, normal, cohesion);
    EXPECT_EQ(hash_after(Simulation(scene.model(), saved, 2), 2000 - 1234), plain) << normal;
  }
}

TEST(StateHash, DiffersIfOneBitOfOneParcelDiffers) {
  auto parcels = sticky_parcels();
  parcels[123].spin.y = std::nextafter(parcels[123].spin.y, 1e9);
  EXPECT_NE(hash_after(sticky_start(1, 1.0, parcels), 1), hash_after(sticky_start(1), 1));
}

TEST(StateHash, SeesContactHistoryToo) {
  Simulation s = sticky_start(1);
  go(s, 1000);
  State a = s.snapshot(), b = a;
  ASSERT_GT(a.pairs.size(), 0u);
  b.pairs.history[0].roll.x += 1e-20;
  EXPECT_NE(state_hash(a), state_hash(b));
}

}  // namespace
