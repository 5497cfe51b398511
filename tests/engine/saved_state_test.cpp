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

TEST(SavedState, EveryFlippedBitIsNoticed) {
  auto bytes = save_state(small_state());
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      bytes[at] ^= std::byte{1} << bit;
      expect_refused(bytes, "bit " + std::to_string(bit) + " of byte " + std::to_string(at));
      bytes[at] ^= std::byte{1} << bit;
    }
  EXPECT_NO_THROW(load_state(bytes));
}

TEST(SavedState, AnythingElseIsRefused) {
  expect_refused({}, "an empty file");
  expect_refused(std::vector<std::byte>(1000), "zeros");
  auto bytes = save_state(small_state());
  bytes.push_back(std::byte{0});
  expect_refused(bytes, "a trailing byte");
}

}  // namespace
