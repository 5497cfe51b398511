// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "engine/base/failure.hpp"
#include "tests/engine/sticky_scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

/// A state with something in each of its fields.
State full_state() {
  Simulation s = sticky_start(1);
  go(s, 1500);
  State state = s.snapshot();
  state.escapes.push_back({7, 0.25, {1, 2, 3}, {4, 5, 6}, "die.-x"});
  state.escapes.push_back({8, 0.5, {}, {}, ""});
  state.ledger.escaped = 2;
  state.progress = {3, 1234};
  return state;
}

/// The same with few parcels, so that every bit of it can be flipped.
State small_state() {
  State state = full_state();
  state.parcels.body.resize(6);
  state.parcels.load.resize(6);
  for (TouchingList* list : {&state.pairs, &state.walls}) {
    list->begin.resize(7);
    list->partner.resize(list->begin.back());
    list->history.resize(list->begin.back());
  }
  return state;
}

template <class T>
void expect_same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

TEST(SavedState, ComesBackWhole) {
  const State a = full_state();
  const State b = load_state(save_state(a));
  EXPECT_EQ(a.step, b.step);
  expect_same_bytes(a.parcels.body, b.parcels.body);
  expect_same_bytes(a.parcels.load, b.parcels.load);
  for (auto list : {&State::pairs, &State::walls}) {
    EXPECT_GT((a.*list).size(), 0u);
    expect_same_bytes((a.*list).begin, (b.*list).begin);
    expect_same_bytes((a.*list).partner, (b.*list).partner);
    expect_same_bytes((a.*list).history, (b.*list).history);
  }
  ASSERT_EQ(b.motions.size(), 1u);
  EXPECT_TRUE(b.motions[0].running);
  EXPECT_EQ(b.motions[0].start, a.motions[0].start);
  expect_same_bytes(a.body_absent, b.body_absent);
  ASSERT_EQ(b.sources.size(), 1u);
  EXPECT_EQ(b.sources[0].open, a.sources[0].open);
  EXPECT_EQ(b.sources[0].done, a.sources[0].done);
  EXPECT_EQ(b.sources[0].count, a.sources[0].count);
  EXPECT_EQ(b.sources[0].mass, a.sources[0].mass);
  EXPECT_EQ(b.next_id, a.next_id);
  EXPECT_EQ(std::memcmp(&a.ledger, &b.ledger, sizeof a.ledger), 0);
  ASSERT_EQ(b.escapes.size(), 2u);
  EXPECT_EQ(b.escapes[0].through, "die.-x");
  EXPECT_EQ(b.escapes[0].position, (Vec3{1, 2, 3}));
  EXPECT_EQ(b.escapes[1].id, 8u);
  EXPECT_EQ(b.progress.phase, 3u);
  EXPECT_EQ(b.progress.phase_start, 1234u);
  EXPECT_EQ(state_hash(a), state_hash(b));
  EXPECT_EQ(save_state(b), save_state(a));
}

/// The same value, with ones in the gaps between its fields.
template <class T, class Copy>
void fill_gaps(T& thing, const Copy& copy) {
  const T before = thing;
  std::memset(static_cast<void*>(&thing), 0xff, sizeof thing);
  copy(before, thing);
}

TEST(SavedState, HasTheSameBytesWhateverLiesInTheGapsOfMemory) {
  const State a = full_state();
  State b = a;
  fill_gaps(b.motions[0], [](const MotionState& from, MotionState& to) {
    to.running = from.running, to.start = from.start, to.left = from.left;
  });
  fill_gaps(b.sources[0], [](const SourceState& from, SourceState& to) {
    to.open = from.open, to.done = from.done, to.opened = from.opened;
    to.mass_at_opening = from.mass_at_opening, to.count = from.count, to.mass = from.mass;
  });
  ASSERT_NE(std::memcmp(&a.sources[0], &b.sources[0], sizeof(SourceState)), 0) << "there are gaps";
  EXPECT_EQ(save_state(a), save_state(b));
}

void expect_refused(const std::vector<std::byte>& bytes, const std::string& how) {
  try {
    load_state(bytes);
    ADD_FAILURE() << how << " was not noticed";
  } catch (const Failure& failure) {
    ASSERT_EQ(failure.code(), Exit::bad_input) << how;
  }
}

TEST(SavedState, EveryTruncationIsNoticed) {
  const auto bytes = save_state(small_state());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    expect_refused({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)},
                   "cut to " + std::to_string(size));
}

TEST(SavedState, AnythingElseIsRefused) {
  expect_refused({}, "an empty file");
  expect_refused(std::vector<std::byte>(1000), "zeros");
  auto bytes = save_state(small_state());
  bytes.push_back(std::byte{0});
  expect_refused(bytes, "a trailing byte");
}

/// As it comes out of bytes that were tampered with behind the back of any checksum: refused, or good for steps.
void expect_harmless(const std::vector<std::byte>& bytes, const Model& model, std::size_t& refused) {
  try {
    State state = load_state(bytes);
    require_fit(state, model);
    Simulation s(model, std::move(state), 1);
    go(s, 2);
  } catch (const Failure&) {
    ++refused;
  }
}

TEST(SavedState, TamperedWithIsRefusedOrGoesOnButNeverCrashes) {
  Simulation start = sticky_start(1);
  go(start, 1500);
  const Model model = start.model();
  const auto bytes = save_state(start.snapshot());
  ASSERT_NO_THROW(require_fit(load_state(bytes), model));
  std::size_t refused = 0;
  constexpr std::uint64_t rounds = 400;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    pulvis::validation::Draw draw(round, 77);
    auto changed = bytes;
    const auto at = static_cast<std::size_t>(draw.between(0.0, static_cast<double>(bytes.size() - 8)));
    // A flipped bit, a byte of ones, or a whole number that is far too large.
    const double kind = draw.between(0.0, 3.0);
    if (kind < 1.0)
      changed[at] ^= std::byte{1} << static_cast<int>(draw.between(0.0, 8.0));
    else
      std::memset(&changed[at], 0xff, kind < 2.0 ? 1 : 8);
    expect_harmless(changed, model, refused);
  }
  EXPECT_GT(refused, rounds / 10);
  EXPECT_LT(refused, rounds) << "most numbers may have other values";
}

TEST(SavedState, OfAnotherModelIsRefused) {
  const State state = full_state();
  const auto refuses = [](const State& s, const Model& model) {
    try {
      require_fit(s, model);
    } catch (const Failure& failure) {
      return failure.code() == Exit::bad_input;
    }
    return false;
  };
  State sound = state;
  sound.escapes.clear();
  sound.ledger.escaped = 0;
  Model model = sticky_model();
  ASSERT_FALSE(refuses(sound, model));
  EXPECT_TRUE(refuses(state, model)) << "two escaped that were never inserted";
  Model fewer = model;
  fewer.walls.surfaces.pop_back();
  EXPECT_TRUE(refuses(sound, fewer)) << "a contact with a wall that is not there";
  Model smaller = model;
  smaller.domain.max.x = 0.5 * smaller.domain.max.x;
  EXPECT_TRUE(refuses(sound, smaller)) << "parcels outside";
  Model still = model;
  still.motions.clear();
  EXPECT_TRUE(refuses(sound, still));
  const auto refuses_if = [&](const char* what, const auto& change) {
    State changed = sound;
    change(changed);
    EXPECT_TRUE(refuses(changed, model)) << what;
  };
  refuses_if("a list that goes back", [](State& s) { std::swap(s.pairs.begin[20], s.pairs.begin[220]); });
  refuses_if("a list too short", [](State& s) { s.pairs.begin.pop_back(); });
  refuses_if("fewer histories", [](State& s) { s.walls.history.pop_back(); });
  refuses_if("an endless spring", [](State& s) { s.pairs.history[3].slide.x = 1.0 / 0.0; });
  refuses_if("a partner out of range", [](State& s) { s.pairs.partner.back() = 1u << 30; });
  refuses_if("a species out of range", [](State& s) { s.parcels.body[5].species = 1; });
  refuses_if("no number", [](State& s) { s.parcels.body[5].velocity.y = 0.0 / 0.0; });
  refuses_if("an id twice", [](State& s) { s.parcels.body[5].id = s.parcels.body[6].id; });
  refuses_if("loads of others", [](State& s) { s.parcels.load.pop_back(); });
  refuses_if("a motion from the future", [](State& s) { s.motions[0].start = s.step + 1; });
}

}  // namespace
