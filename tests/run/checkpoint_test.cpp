// SPDX-License-Identifier: Apache-2.0
// Checkpoint files: two kept, damage noticed, the one before used.
#include "run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "case/reader.hpp"
#include "output/checksum.hpp"
#include "output/chunk_file.hpp"
#include "run/assemble.hpp"
#include "tests/run/small_die.hpp"
#include "validation/draw.hpp"

using namespace pulvis;
using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

/// Something in each field, told apart by a number.
Checkpoint numbered(std::uint64_t number) {
  Checkpoint c;
  c.time_step = 1e-6;
  c.keys = {{"seed", "1", "1"}, {"title", "\"t\"", "t"}};
  c.state.step = number;
  c.loads.current.tiles.resize(3);
  c.loads.current.facets = {{}, {{1.5, {1, 2, 3}}}};
  c.summary.phases = {{"fill", 0.0, 0.5, "time", {{"mass", 1.5, "kg", "now"}, {"none", {}, "1", "now"}}, {}}};
  c.summary.warnings = {"one", ""};
  c.results.frames.parcels = {{0.25, "frames/a.vtp"}};
  c.results.frames.count = number;
  return c;
}

class CheckpointFolder : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  RunFolder run_{folder_ / "out", UsedFolder::refuse, {}};

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(run_.file("checkpoints")))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
  void damage(int number) const {
    const std::string path = run_.file(fmt::format("checkpoints/checkpoint-{}.pulvis", number));
    std::string text = text_of(path);
    text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 4);
    write_text(path, text);
  }
  /// What a new process finds.
  Checkpoint newest() const { return Checkpoints(run_).newest(); }
  Exit fault() const {
    try {
      newest();
    } catch (const Failure& failure) {
      return failure.code();
    }
    return Exit::ok;
  }
};

TEST_F(CheckpointFolder, KeepsTheLastTwo) {
  Checkpoints checkpoints(run_);
  for (std::uint64_t k = 1; k <= 12; ++k) checkpoints.write(numbered(k));
  EXPECT_EQ(files(), (std::vector<std::string>{"checkpoint-11.pulvis", "checkpoint-12.pulvis"}));
  EXPECT_EQ(newest().state.step, 12u);
}

TEST_F(CheckpointFolder, GivesBackWhatWasWritten) {
  Checkpoints(run_).write(numbered(5));
  const Checkpoint c = newest();
  EXPECT_EQ(c.program, PULVIS_VERSION);
  EXPECT_EQ(c.time_step, 1e-6);
  ASSERT_EQ(c.keys.size(), 2u);
  EXPECT_EQ(c.keys[1].meaning, "t");
  EXPECT_EQ(c.loads.current.facets[1][0].shear, (Vec3{1, 2, 3}));
  EXPECT_EQ(c.summary.phases[0].measures[0].value, 1.5);
  EXPECT_FALSE(c.summary.phases[0].measures[1].value);
  EXPECT_EQ(c.results.frames.parcels[0].file, "frames/a.vtp");
  EXPECT_EQ(c.results.frames.count, 5u);
}

TEST_F(CheckpointFolder, UsesTheOneBeforeADamagedOneAndTakesItsPlace) {
  Checkpoints first(run_);
  for (std::uint64_t k = 1; k <= 3; ++k) first.write(numbered(k));
  damage(3);
  ::testing::internal::CaptureStderr();
  Checkpoints second(run_);
  EXPECT_EQ(second.newest().state.step, 2u);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_TRUE(has(said, "checkpoint-3.pulvis")) << said;
  EXPECT_TRUE(has(said, "damaged")) << said;
  EXPECT_TRUE(has(second.file(), "checkpoint-2.pulvis"));
  second.write(numbered(30));
  EXPECT_EQ(files(), (std::vector<std::string>{"checkpoint-2.pulvis", "checkpoint-3.pulvis"}));
  EXPECT_EQ(newest().state.step, 30u);
}

TEST_F(CheckpointFolder, IsExitFourIfAllAreDamagedAndTwoIfThereIsNone) {
  EXPECT_EQ(fault(), Exit::usage);
  Checkpoints checkpoints(run_);
  for (std::uint64_t k = 1; k <= 2; ++k) checkpoints.write(numbered(k));
  damage(1), damage(2);
  EXPECT_EQ(fault(), Exit::bad_input);
}

TEST_F(CheckpointFolder, LooksAtNoOtherFiles) {
  Checkpoints(run_).write(numbered(1));
  for (const char* name : {"checkpoint-9.pulvis.part", "checkpoint-09.pulvis", "checkpoint-x.pulvis",
                           "checkpoint-.pulvis", "checkpoint-7.pulvis.bak", "notes"})
    write_text(run_.file(std::string("checkpoints/") + name), "anything");
  EXPECT_EQ(newest().state.step, 1u);
}

/// A checkpoint of the small die, a fifth of the way, as the program wrote it.
std::string real_checkpoint() {
  const RunOfCase run(small_die,
                      {"--threads", "1", "--set", "phases.fill.time_limit=\"10 ms\"", "--set",
                       "phases.fill.at_limit=\"end\"", "--set", "phases.settle.time_limit=\"1 ms\"", "--set",
                       "phases.settle.at_least=\"0.5 ms\"", "--max-wall", "0 s"});
  EXPECT_EQ(run.exit(), 75) << run.outcome().err;
  const Outcome rest =
      call({"run", run.case_file(), "--out", run.out(), "--resume", "--threads", "1", "--set",
            "phases.fill.time_limit=\"10 ms\"", "--set", "phases.fill.at_limit=\"end\"", "--set",
            "phases.settle.time_limit=\"1 ms\"", "--set", "phases.settle.at_least=\"0.5 ms\""});
  EXPECT_EQ(rest.exit, 0) << rest.err;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(run.out("checkpoints"))) names.push_back(entry.path());
  return text_of(*std::max_element(names.begin(), names.end()));
}

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

/// 2,000 of them; tools/reliability asks for more by PULVIS_ROUNDS.
TEST(CheckpointFile, NoticesFlippedBitsAndCutsAnywhere) {
  const std::string whole = real_checkpoint();
  ASSERT_GT(whole.size(), 10000u);
  ASSERT_NO_THROW(ChunkFile(bytes_of(whole), "it", Checkpoint::version));
  const char* asked = std::getenv("PULVIS_ROUNDS");
  const std::uint64_t rounds = asked ? std::strtoull(asked, nullptr, 10) : 2000;
  ASSERT_GT(rounds, 0u);
  std::uint64_t noticed = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    pulvis::validation::Draw draw(round, 4711);
    std::string changed = whole;
    const auto at = static_cast<std::size_t>(draw.between(0.0, static_cast<double>(whole.size())));
    // The first bytes, which say where all others are, as often as all the rest.
    const std::size_t place = draw.chance(0.5) ? at : at % 200;
    if (draw.chance(0.2))
      changed.resize(place);
    else
      changed[place] = static_cast<char>(changed[place] ^ (1 << static_cast<int>(draw.between(0.0, 8.0))));
    try {
      ChunkFile(bytes_of(changed), "it", Checkpoint::version);
      ADD_FAILURE() << "round " << round << ", place " << place;
    } catch (const Failure& failure) {
      noticed += failure.code() == Exit::bad_input;
    }
  }
  EXPECT_EQ(noticed, rounds);
}

}  // namespace
