// SPDX-License-Identifier: Apache-2.0
// Contacts of pairs apart against a plain map.
#include "engine/contacts/met_pairs.hpp"

#include <gtest/gtest.h>

#include <map>

#include "validation/draw.hpp"

using namespace pulvis;
using pulvis::validation::Draw;

namespace {

TEST(MetPairs, AreThoseThatWerePutAndNotForgotten) {
  constexpr std::size_t pairs = 200;
  constexpr int parts = 3;
  MetPairs met;
  met.reset(pairs, parts);
  std::map<std::size_t, double> expected;
  Draw draw(1, 26);
  for (int k = 0; k < 20000; ++k) {
    const auto pair = static_cast<std::size_t>(draw.between(0.0, pairs));
    const int part = static_cast<int>(pair * parts / pairs);
    if (draw.chance(0.5)) {
      met.forget(pair, part);
      expected.erase(pair);
    } else {
      MetPairs::Contact contact;
      contact.past.grip = k;
      met.put(pair, contact, part);
      expected[pair] = k;
    }
    const auto looked_at = static_cast<std::size_t>(draw.between(0.0, pairs));
    const MetPairs::Contact* found = met.find(looked_at);
    ASSERT_EQ(found != nullptr, expected.contains(looked_at));
    if (found) ASSERT_EQ(found->past.grip, expected[looked_at]);
  }
  EXPECT_LT(met.bytes(), 2 * pairs * (sizeof(MetPairs::Contact) + 8)) << "room is used again";
  met.reset(pairs, parts);
  for (std::size_t pair = 0; pair < pairs; ++pair) ASSERT_EQ(met.find(pair), nullptr);
}

}  // namespace
