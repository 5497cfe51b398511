// SPDX-License-Identifier: Apache-2.0
// Faults put into a running simulation: each is found within a bounded number of steps, with all a person needs.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "engine/base/failure.hpp"
#include "tests/engine/sticky_scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr int steps_until_found = 64;

/// The scene once its parcels touch each other and the walls.
Simulation& settled() {
  static Simulation s = [] {
    Simulation made = sticky_start(1);
    go(made, 1500);
    return made;
  }();
  return s;
}

/// What stops a copy of it after `fault`, and after how many steps.
std::pair<std::string, int> stopped_by(const std::function<void(Simulation&)>& fault,
                                       Model model = sticky_model()) {
  const State state = load_state(save_state(settled().snapshot()));
  Simulation s(std::move(model), state, 1);
  s.step();  // so that the lists know what touches
  fault(s);
  for (int k = 1; k <= 4 * steps_until_found; ++k) {
    try {
      s.step();
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::physics);
      return {failure.what(), k};
    }
  }
  return {"nothing", 1000};
}

void expect_found(const std::pair<std::string, int>& stop, const std::vector<std::string>& words) {
  EXPECT_LE(stop.second, steps_until_found) << stop.first;
  for (const std::string& word : words)
    EXPECT_NE(stop.first.find(word), std::string::npos) << word << "\n" << stop.first;
}

/// A parcel with a contact.
Parcel& touched(Simulation& s) {
  for (std::size_t slot = 0; slot < s.pairs().slots(); ++slot)
    if (s.pairs().touching[slot]) return s.state().parcels.body[s.pairs().first[slot]];
  throw std::logic_error("nothing touches");
}

TEST(Guards, FindANumberThatIsNoneInAnyFieldOfAParcel) {
  const double none = std::numeric_limits<double>::quiet_NaN(),
               endless = std::numeric_limits<double>::infinity();
  using Field = double& (*)(Simulation&, std::size_t);
  const std::vector<Field> fields = {
      [](Simulation& s, std::size_t) -> double& { return touched(s).position.x; },
      [](Simulation& s, std::size_t) -> double& { return touched(s).position.z; },
      [](Simulation& s, std::size_t) -> double& { return touched(s).velocity.y; },
      [](Simulation& s, std::size_t) -> double& { return touched(s).spin.x; },
      [](Simulation& s, std::size_t) -> double& { return touched(s).spin.z; },
      [](Simulation& s, std::size_t i) -> double& { return s.state().parcels.load[i].force.x; },
      [](Simulation& s, std::size_t i) -> double& { return s.state().parcels.load[i].torque.y; },
  };
  for (const double bad : {none, endless})
    for (const Field& field : fields)
      expect_found(stopped_by([&](Simulation& s) { field(s, 17) = bad; }),
                   {"not a finite number", "parcel ", "t = ", "position (", "law ", "time.fraction"});
}

TEST(Guards, FindAParcelThatRunsAwayAndWhatItTouched) {
  const auto stop = stopped_by([](Simulation& s) { touched(s).velocity.x = 1e3; });
  expect_found(stop, {"more than half its radius", "parcel ", "t = ", "velocity (", "it touches parcel ",
                      "law jkr", "time.fraction"});
  EXPECT_EQ(stop.second, 1);
}

TEST(Guards, FindParcelsThatOverlapTooDeeply) {
  Model careful = sticky_model();
  careful.largest_overlap = 1e-4;
  expect_found(stopped_by([](Simulation&) {}, careful),
               {"parcels overlap by", "% of a radius", "parcel ", "t = ", "it touches parcel ", "law jkr",
                "simulated_modulus"});
  const std::string usual = stopped_by([](Simulation&) {}).first;
  EXPECT_EQ(usual, "nothing") << "and do not find what is usual";
}

TEST(Guards, FindAWallThatLeapsAtOnce) {
  Model leaping = sticky_model();
  leaping.motions = {{motions::Sine{{0.1, 2000.0, 0.0}, {0, 0, 1}}}};
  State state = load_state(save_state(settled().snapshot()));
  state.motions[0].running = false;  // the floor rests where it is, until it leaps
  state.motions[0].left = settled().pose(1).now;
  Simulation s(leaping, std::move(state), 1);
  s.start_motion(0);
  try {
    s.step();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::physics);
    expect_found({failure.what(), 1},
                 {"the body floor moves", "t = ", "half the smallest radius", "time.fraction"});
  }
}

}  // namespace
