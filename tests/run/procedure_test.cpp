// SPDX-License-Identifier: Apache-2.0
// Phases: how each ends, what it leaves to the next, and that a saved state goes on in the middle of one.
#include <gtest/gtest.h>

#include <cmath>

#include "case/reader.hpp"
#include "engine/base/failure.hpp"
#include "run/assemble.hpp"
#include "run/measuring.hpp"
#include "run/procedure.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

struct Ended {
  std::string phase, by;
  std::uint64_t steps = 0;  ///< that the phase took
  double kinetic_energy = 0.0, fill = 0.0, displacement = 0.0;
  std::size_t parcels = 0;
};

/// A case on its way, in this process.
class Journey {
 public:
  explicit Journey(const std::string& text, const std::vector<Override>& overrides = {})
      : c_(read_case_text(text, "case.toml", overrides)),
        simulation_(model(), Simulation::initial_state(model()), 1),
        procedure_(c_, simulation_) {}
  Journey(const std::string& text, const State& state)
      : c_(read_case_text(text, "case.toml")), simulation_(model(), state, 1), procedure_(c_, simulation_) {}

  /// One step; how the phase ended, if it did.
  std::optional<Ended> step() {
    simulation_.step();
    const auto by = procedure_.ended();
    if (!by) return {};
    Ended e{procedure_.phase().name, *by,
            simulation_.state().step - simulation_.state().progress.phase_start};
    for (const Measure& value : measures_of(simulation_, survey_die(c_, simulation_))) {
      if (value.name == "kinetic_energy_translational") e.kinetic_energy = *value.value;
      if (value.name == "fill_mass") e.fill = *value.value;
    }
    e.displacement = simulation_.pose(0).now.shift.z;
    e.parcels = simulation_.state().parcels.size();
    procedure_.next_phase();
    return e;
  }
  std::vector<Ended> to_the_end() {
    std::vector<Ended> list;
    while (!procedure_.finished())
      if (const auto ended = step()) list.push_back(*ended);
    return list;
  }
  double dt() const { return simulation_.model().dt; }
  std::uint64_t steps_for(double seconds) const {
    return static_cast<std::uint64_t>(std::llround(seconds / dt()));
  }
  std::string hash() const { return state_hash(simulation_.snapshot()); }
  const Case& the_case() const { return c_; }
  Simulation& simulation() { return simulation_; }
  Procedure& procedure() { return procedure_; }

 private:
  Model model() const { return assemble(c_).model; }
  Case c_;
  Simulation simulation_;
  Procedure procedure_;
};

/// A rain and the phases given, in the small die.
std::string rain_and(const std::string& phases, const std::string& target = "mass = \"24 mg\"") {
  return die_with(R"([sources.rain]
kind = "rain"
region = { min = ["0.1 mm", "0.1 mm", "4.2 mm"], max = ["2.9 mm", "2.9 mm", "6 mm"] }
velocity = ["0 m/s", "0 m/s", "-0.2 m/s"]
mass_rate = "600 mg/s"
)" + target + "\n\n" +
                  phases);
}

std::string phase(const std::string& name, const std::string& rest) {
  return "[[phases]]\nname = \"" + name + "\"\n" + rest + "\n\n";
}
const std::string fill = phase("fill", "sources = [\"rain\"]\nuntil = \"inserted\"\ntime_limit = \"0.2 s\"");

TEST(Phase, EndsByTimeToTheStep) {
  Journey j(rain_and(phase("wait", "sources = [\"rain\"]\nuntil = \"time\"\nduration = \"3 ms\"") +
                     phase("more", "until = \"time\"\nduration = \"2 ms\"")));
  const auto ended = j.to_the_end();
  ASSERT_EQ(ended.size(), 2u);
  EXPECT_EQ(ended[0].by, "time");
  EXPECT_EQ(ended[0].steps, j.steps_for(3e-3));
  EXPECT_EQ(ended[1].phase, "more");
  EXPECT_EQ(ended[1].steps, j.steps_for(2e-3));
  EXPECT_GT(ended[0].parcels, 5u);
  EXPECT_EQ(ended[1].parcels, ended[0].parcels) << "the rain is closed with its phase";
}

TEST(Phase, EndsWhenAllIsInserted) {
  Journey j(rain_and(fill, "count = 20"));
  const auto ended = j.to_the_end();
  EXPECT_EQ(ended.at(0).by, "inserted");
  EXPECT_EQ(ended.at(0).parcels, 20u) << "a count is met exactly";
  EXPECT_GT(static_cast<double>(ended.at(0).steps) * j.dt(), 20 * 0.9 * 1.37e-7 / 6e-4 * 0.8)
      << "at the rate given, not at once";
}

TEST(Phase, FillsThroughASieveOutOfACylinder) {
  std::string text = with(
      rain_and(fill, "count = 40"),
      R"({ min = ["0.1 mm", "0.1 mm", "4.2 mm"], max = ["2.9 mm", "2.9 mm", "6 mm"] })",
      R"({ shape = "cylinder", base = ["1.5 mm", "1.5 mm", "4.2 mm"], radius = "1.4 mm", height = "1.8 mm" })");
  text = with(text, "mass_rate", "sieve_pitch = \"0.8 mm\"\nsieve_opening = \"0.6 mm\"\nmass_rate");
  Journey j(text);
  ASSERT_TRUE(j.simulation().model().sources.at(0).sieve);
  EXPECT_EQ(j.to_the_end().at(0).parcels, 40u);
}

TEST(Phase, EndsByTheMassInTheDie) {
  Journey j(rain_and(
      phase("fill", "sources = [\"rain\"]\nuntil = \"mass\"\nmass = \"8 mg\"\ntime_limit = \"0.2 s\"") +
      phase("after", "until = \"time\"\nduration = \"5 ms\"")));
  const auto ended = j.to_the_end();
  EXPECT_EQ(ended.at(0).by, "mass");
  EXPECT_GE(ended.at(0).fill, 8e-6);
  // It is asked every 100 steps: no more than fell in since, and the rounding to parcels.
  EXPECT_LT(ended.at(0).fill, 8e-6 + 600e-6 * 100 * j.dt() + 4 * 2.2e-7);
  EXPECT_EQ(ended.at(1).parcels, ended.at(0).parcels);
}

TEST(Phase, EndsAfterItsCyclesAndTheWallStaysWhereItStopped) {
  // A quarter beyond two cycles, so that the wall is a full amplitude away from where it began.
  Journey j(rain_and(
      phase("shake", "sources = [\"rain\"]\nmotions = [\"shaking\"]\nuntil = \"cycles\"\ncycles = 2.25") +
      phase("rest", "until = \"time\"\nduration = \"1 ms\"") +
      phase("again", "motions = [\"shaking\"]\nuntil = \"cycles\"\ncycles = 0.5")));
  const double omega = 2.0 * M_PI * 100.0, amplitude = 15.0 / (omega * omega);
  std::vector<Ended> ended;
  double before = 0.0, fastest = 0.0;
  while (!j.procedure().finished()) {
    const bool resting = j.procedure().phase().name == "rest";
    if (const auto e = j.step()) ended.push_back(*e);
    const double now = j.simulation().pose(0).now.shift.z;
    fastest = std::max(fastest, std::abs(now - before));
    if (resting) {
      EXPECT_EQ(now, before) << "at rest it does not move a bit";
    }
    before = now;
  }
  ASSERT_EQ(ended.size(), 3u);
  EXPECT_EQ(ended[0].by, "cycles");
  EXPECT_EQ(ended[0].steps, j.steps_for(0.0225));
  EXPECT_NEAR(ended[0].displacement, amplitude, 1e-3 * amplitude);
  EXPECT_EQ(ended[1].displacement, ended[0].displacement);
  EXPECT_EQ(ended[2].steps, j.steps_for(0.005));
  EXPECT_NEAR(ended[2].displacement, amplitude + 2.0 * amplitude, 1e-3 * amplitude) << "goes on from there";
  EXPECT_LE(fastest, 1.0001 * amplitude * omega * j.dt()) << "no jump, ever";
  EXPECT_GT(fastest, 0.99 * amplitude * omega * j.dt());
}

TEST(Phase, EndsAtRestButNotBeforeItsTime) {
  const std::string text =
      rain_and(fill + phase("settle",
                            "until = \"rest\"\nkinetic_energy = \"1e-10 J\"\nat_least = \"5 ms\"\n"
                            "time_limit = \"0.5 s\""),
               "count = 10");
  Journey j(text);
  const auto ended = j.to_the_end();
  EXPECT_EQ(ended.at(1).by, "rest");
  EXPECT_LE(ended.at(1).kinetic_energy, 10 * 1e-10);
  EXPECT_GT(ended.at(0).kinetic_energy, 10 * 1e-10) << "they fell before";
  EXPECT_GE(ended.at(1).steps, j.steps_for(5e-3));
  // At rest from the start of a second settling: only at_least holds it up.
  Journey again(
      text + phase("still",
                   "until = \"rest\"\nkinetic_energy = \"1 J\"\nat_least = \"5 ms\"\ntime_limit = \"1 s\""));
  const auto late = again.to_the_end().at(2);
  EXPECT_EQ(late.by, "rest");
  EXPECT_GE(static_cast<double>(late.steps) * again.dt(), 5e-3);
  EXPECT_LE(late.steps, again.steps_for(5e-3) + 100);
}

TEST(Phase, EndsAtItsTimeLimit) {
  Journey j(
      rain_and(phase("fill", "sources = [\"rain\"]\nuntil = \"inserted\"\ntime_limit = \"4 ms\"") +
               phase("settle", "until = \"rest\"\nkinetic_energy = \"1e-30 J\"\ntime_limit = \"2 ms\"")));
  const auto ended = j.to_the_end();
  EXPECT_EQ(ended.at(0).by, "time_limit");
  EXPECT_EQ(ended.at(0).steps, j.steps_for(4e-3));
  EXPECT_EQ(ended.at(1).by, "time_limit");
  EXPECT_EQ(ended.at(1).steps, j.steps_for(2e-3));
}

TEST(Phase, LimitThatIsAnErrorNamesThePhase) {
  Journey j(rain_and(phase(
      "fill", "sources = [\"rain\"]\nuntil = \"inserted\"\ntime_limit = \"4 ms\"\nat_limit = \"error\"")));
  try {
    j.to_the_end();
    ADD_FAILURE() << "no error";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::physics);
    EXPECT_TRUE(has(failure.what(), "phase fill")) << failure.what();
    EXPECT_EQ(j.simulation().state().step, j.steps_for(4e-3));
  }
}

TEST(Phase, ShareOfTheWayGrowsToOne) {
  Journey j(rain_and(fill + phase("wait", "until = \"time\"\nduration = \"3 ms\""), "count = 20"));
  double share = 0.0;
  while (!j.procedure().finished()) {
    const double now = j.procedure().share();
    EXPECT_GE(now, share - 1e-12);
    EXPECT_LE(now, 1.0);
    share = now;
    j.step();
  }
  EXPECT_GT(share, 0.99);
}

TEST(MassTarget, IsMetToWithinHalfTheSmallestParcel) {
  const std::vector<std::string> sizes = {
      R"({ kind = "single", diameter = "50 um" })",
      R"({ kind = "uniform", smallest = "30 um", largest = "60 um" })",
      R"({ kind = "lognormal", diameter = "40 um", geometric_deviation = 1.4, smallest = "20 um", largest = "60 um" })",
      R"({ kind = "table", diameters = ["20 um", "60 um"], shares = [1, 3] })"};
  const std::vector<double> smallest = {50e-6, 30e-6, 20e-6, 20e-6};
  for (const char* kind : {"rain", "pack"})
    for (std::size_t k = 0; k < sizes.size(); ++k)
      for (const char* seed : {"1", "2", "3"}) {
        std::string text =
            rain_and(phase("fill", "sources = [\"rain\"]\nuntil = \"inserted\"\ntime_limit = \"0.2 s\""),
                     "mass = \"2.345 mg\"");
        text = with(text, R"({ kind = "uniform", smallest = "45 um", largest = "55 um" })", sizes[k]);
        text = with(text, "600 mg/s", "20 g/s");
        if (std::string(kind) == "pack")
          text = with(with(text, "mass_rate = \"20 g/s\"\n", ""), "\"rain\"", "\"pack\"");
        Journey j(text, {{"seed", seed}, {"powders.beads.simulated_modulus", "\"1 MPa\""}});
        const auto ended = j.to_the_end();
        ASSERT_EQ(ended.at(0).by, "inserted") << kind << " of " << sizes[k];
        const State& state = j.simulation().state();
        const double half = 0.5 * 2500.0 * M_PI / 6.0 * std::pow(10 * smallest[k], 3);
        EXPECT_NEAR(state.sources[0].mass, 2.345e-6, half * (1 + 1e-9))
            << kind << " of " << sizes[k] << ", seed " << seed;
        double sum = 0.0;
        for (const Parcel& p : state.parcels.body) sum += p.mass;
        EXPECT_NEAR(sum, state.sources[0].mass, 1e-12 * sum);
        EXPECT_NEAR(sum, state.ledger.inserted_mass, 1e-12 * sum);
      }
}

TEST(SavedState, GoesOnInTheMiddleOfAnyPhaseToTheSameEnd) {
  const std::string text = rain_and(
      fill + phase("settle", "until = \"rest\"\nkinetic_energy = \"2e-11 J\"\ntime_limit = \"0.05 s\"") +
          phase("shake", "motions = [\"shaking\"]\nuntil = \"cycles\"\ncycles = 1.3") +
          phase("still", "until = \"time\"\nduration = \"2 ms\""),
      "count = 40");
  Journey whole(text);
  const auto ended = whole.to_the_end();
  ASSERT_EQ(ended.size(), 4u);
  std::uint64_t start = 0;
  for (std::size_t k = 0; k < ended.size(); ++k) {
    // Neither at an end of the phase nor where criteria are asked.
    const std::uint64_t moment = start + ended[k].steps / 2 + 37;
    start += ended[k].steps;
    SCOPED_TRACE("saved in phase " + ended[k].phase);
    Journey first(text);
    std::size_t before = 0;
    while (first.simulation().state().step < moment) before += first.step().has_value();
    ASSERT_EQ(before, k);
    const auto bytes = save_state(first.simulation().snapshot());
    Journey second(text, load_state(bytes));
    EXPECT_EQ(second.procedure().phase().name, ended[k].phase);
    EXPECT_EQ(second.procedure().phase_start(), first.procedure().phase_start());
    const auto rest = second.to_the_end();
    ASSERT_EQ(rest.size(), ended.size() - k);
    for (std::size_t n = 0; n < rest.size(); ++n) {
      EXPECT_EQ(rest[n].phase, ended[k + n].phase);
      EXPECT_EQ(rest[n].by, ended[k + n].by);
      EXPECT_EQ(rest[n].steps, ended[k + n].steps);
      EXPECT_EQ(rest[n].displacement, ended[k + n].displacement);
    }
    EXPECT_EQ(second.hash(), whole.hash());
  }
}

}  // namespace
