// SPDX-License-Identifier: Apache-2.0
// Runs that are killed, stopped or left, and go on.
#include <gtest/gtest.h>

#include "tests/run/small_die.hpp"
#include "validation/draw.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

/// Checkpoints come so often that kills meet some of them being written.
const std::string die = with(small_die, "[output]", R"([measures]
energy_ledger = true

[measures.surfaces.mouth]
point = ["1.5 mm", "1.5 mm", "4 mm"]
normal = [0, 0, -1]
radius = "2 mm"

[output]
checkpoint_interval = "30 ms")");

/// All that a run leaves but how long it took: every file with its bytes, and what result.json says.
std::map<std::string, std::string> left_in(const std::string& out) {
  std::map<std::string, std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const std::string name = fs::relative(entry.path(), out).string();
    if (!entry.is_regular_file() || name.starts_with("checkpoints/")) continue;
    left[name] = text_of(entry.path());
  }
  Json result = json_of(out + "/result.json");
  for (const char* key : {"wall_time_s", "resumes", "threads", "threads_used", "list_rebuilds",
                          "stepping_time_s", "time_table_s", "particle_steps_per_s"})
    result.erase(key);
  // It names the case file, which lies elsewhere in each test.
  std::string& run = left["run.json"];
  const std::string place = fs::path(out).parent_path().string();
  for (std::size_t at = run.find(place); at != std::string::npos; at = run.find(place))
    run.erase(at, place.size());
  left["result.json"] = result.dump();
  return left;
}

void expect_same(const std::string& out, const std::string& straight) {
  EXPECT_EQ(json_of(out + "/result.json").at("state_hash"),
            json_of(straight + "/result.json").at("state_hash"));
  const auto one = left_in(straight), other = left_in(out);
  for (const auto& [name, text] : one) {
    EXPECT_TRUE(other.contains(name)) << name << " is missing";
    EXPECT_TRUE(other.contains(name) && other.at(name) == text) << name << " is another";
  }
  for (const auto& [name, text] : other) EXPECT_TRUE(one.contains(name)) << name << " is too much";
}

/// The run that nothing disturbed.
const RunOfCase& straight() {
  static const RunOfCase run(die);
  EXPECT_EQ(run.exit(), 0) << run.outcome().err;
  return run;
}

/// A place for runs of the same case.
struct Place {
  TemporaryFolder folder;
  std::string file = folder.file("case.toml", die), out = folder / "out";

  std::vector<std::string> command(const std::vector<std::string>& options) const {
    std::vector<std::string> words{"run", file, "--out", out};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
  Outcome run(const std::vector<std::string>& options) const { return call(command(options)); }
  std::vector<fs::path> checkpoints() const {
    std::vector<fs::path> list;
    if (!fs::exists(out + "/checkpoints")) return list;
    for (const auto& entry : fs::directory_iterator(out + "/checkpoints"))
      if (entry.path().extension() == ".pulvis") list.push_back(entry.path());
    const auto number = [](const fs::path& p) { return std::stoi(p.stem().string().substr(11)); };
    std::sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return number(a) < number(b); });
    return list;
  }
  int last_checkpoint() const {
    const auto list = checkpoints();
    return list.empty() ? 0 : std::stoi(list.back().stem().string().substr(11));
  }
  /// Waits until there are checkpoints of a number from `least` on.
  bool has_reached(int least) const {
    for (int look = 0; look < 6000; ++look) {
      if (last_checkpoint() >= least) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }
};

/// Waits for a checkpoint or two more and a moment, so that however fast the machine, the run gets on a little.
std::optional<Outcome> wait_a_little(Process& run, const Place& place, std::uint64_t round) {
  pulvis::validation::Draw draw(round, 99);
  const int least = place.last_checkpoint() + (draw.chance(0.5) ? 1 : 2);
  for (int look = 0; look < 20000 && place.last_checkpoint() < least; ++look)
    if (auto ended = run.wait(0.001)) return ended;
  return run.wait(draw.between(0.0, 0.03));
}

TEST(KilledRun, EndsInTheSameBytesHoweverOftenItIsKilled) {
  const Place place;
  int kills = 0;
  for (std::uint64_t round = 0; round < 200; ++round) {
    const bool fresh = place.checkpoints().empty();
    Process run(place.command({fresh ? "--force" : "--resume", "--threads", std::to_string(1 + round % 4)}));
    if (const auto ended = kills < 5 ? wait_a_little(run, place, round) : run.wait(100.0)) {
      ASSERT_EQ(ended->exit, 0) << ended->err;
      break;
    }
    run.signal(SIGKILL);
    ASSERT_EQ(run.wait(10.0)->exit, 128 + SIGKILL);
    ++kills;
  }
  EXPECT_GE(kills, 3) << "it was over too soon to be killed";
  expect_same(place.out, straight().out());
  EXPECT_TRUE(vtk_reads_all_of(place.out));
}

TEST(KilledRun, LeavesAResultWithThePhasesThatHaveEnded) {
  const Place place;
  Process run(place.command({"--threads", "1"}));
  const auto phases = [&] {
    const Json result = Json::parse(text_of(place.out + "/result.json"), nullptr, false);
    return result.is_object() ? result.at("phases").size() : 0u;
  };
  ASSERT_TRUE(place.has_reached(1));
  for (int look = 0; look < 20000 && phases() == 0; ++look)
    if (run.wait(0.001)) break;
  run.signal(SIGKILL);
  run.wait(10.0);
  const Json result = json_of(place.out + "/result.json");
  EXPECT_GE(result.at("phases").size(), 1u);
  EXPECT_EQ(result.at("phases")[0].at("name"), "fill");
  EXPECT_TRUE(result.at("phases")[0].at("measures").contains("porosity_mean"));
}

TEST(KilledRun, LosesWhatItWroteAfterTheCheckpointAndMakesItAgain) {
  const Place place;
  ASSERT_EQ(place.run({"--threads", "1", "--max-wall", "0 s"}).exit, 75);
  // What a killed process may leave: a torn line, frames and tables that nothing lists, half a file.
  write_text(place.out + "/log.csv", text_of(place.out + "/log.csv") + "17,0.0");
  write_text(place.out + "/frames/parcels-000077.vtp", "torn");
  write_text(place.out + "/frames/parcels-000001.vtp.part", "torn");
  fs::create_directory(place.out + "/wall-pressure");
  write_text(place.out + "/wall-pressure/after-fill.csv", "wall,su");
  write_text(place.out + "/wall-forces.csv", "time_s,win");
  write_text(place.out + "/notes.txt", "mine");
  const Outcome rest = place.run({"--resume", "--threads", "1"});
  ASSERT_EQ(rest.exit, 0) << rest.err;
  EXPECT_EQ(text_of(place.out + "/notes.txt"), "mine");
  fs::remove(place.out + "/notes.txt");
  expect_same(place.out, straight().out());
}

TEST(LeftRun, StopsBySignalWithACheckpointAndExitSeventyFive) {
  for (const int signal : {SIGTERM, SIGUSR1}) {
    const Place place;
    Process run(place.command({"--threads", "1"}));
    ASSERT_TRUE(place.has_reached(3));
    run.signal(signal);
    const auto outcome = run.wait(10.0);
    ASSERT_TRUE(outcome) << "still running";
    EXPECT_EQ(outcome->exit, 75) << outcome->err;
    EXPECT_TRUE(has(outcome->err, signal == SIGTERM ? "SIGTERM" : "SIGUSR1")) << outcome->err;
    EXPECT_TRUE(has(outcome->err, "--resume")) << outcome->err;
    EXPECT_EQ(json_of(place.out + "/result.json").at("exit"), 75);
    const Outcome rest = place.run({"--resume", "--threads", "2"});
    ASSERT_EQ(rest.exit, 0) << rest.err;
    EXPECT_TRUE(has(rest.err, "going on from " + place.out + "/checkpoints/checkpoint-")) << rest.err;
    EXPECT_EQ(json_of(place.out + "/result.json").at("resumes"), 1);
    expect_same(place.out, straight().out());
  }
}

TEST(LeftRun, GoesOnAfterCtrlCAsIfThatHadNotBeen) {
  const Place place;
  Process run(place.command({"--threads", "1"}));
  ASSERT_TRUE(place.has_reached(3));
  run.signal(SIGINT);
  const auto outcome = run.wait(10.0);
  ASSERT_TRUE(outcome) << "still running";
  ASSERT_EQ(outcome->exit, 130) << outcome->err;
  EXPECT_EQ(json_of(place.out + "/result.json").at("phases").back().at("ended_by"), "stopped on request");
  ASSERT_EQ(place.run({"--resume", "--threads", "1"}).exit, 0);
  expect_same(place.out, straight().out());
}

TEST(LeftRun, StopsAfterItsTimeOnTheClockAgainAndAgain) {
  const Place place;
  // Once after its first step, then after a share of what the straight run took, which may have been slow.
  Outcome outcome = place.run({"--threads", "1", "--max-wall", "0 s"});
  int parts = 1;
  double stepped = 0.0;
  for (double seconds = straight().result().at("wall_time_s").get<double>() / 8;
       outcome.exit == 75 && parts < 20; ++parts, seconds *= 1.5) {
    EXPECT_TRUE(has(outcome.err, "--max-wall")) << outcome.err;
    const double so_far = json_of(place.out + "/result.json").at("stepping_time_s");
    EXPECT_GT(so_far, stepped) << "what the parts before needed counts too";
    stepped = so_far;
    outcome = place.run({"--resume", "--threads", "1", "--max-wall", fmt::format("{} s", seconds)});
  }
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_GE(parts, 2);
  EXPECT_EQ(json_of(place.out + "/result.json").at("resumes"), parts - 1);
  expect_same(place.out, straight().out());
}

TEST(LeftRun, NeedsATimeForTheClock) {
  const Place place;
  for (const char* time : {"5", "5 mm", "-1 s", "soon", ""}) {
    if (*time == '\0') continue;  // none given
    const Outcome outcome = place.run({std::string("--max-wall=") + time});
    EXPECT_EQ(outcome.exit, 2) << time;
    EXPECT_TRUE(has(outcome.err, "12 h")) << outcome.err;
  }
  EXPECT_FALSE(fs::exists(place.out));
}

TEST(DamagedCheckpoint, GivesWayToTheOneBefore) {
  const Place place;
  Process run(place.command({"--threads", "1"}));
  ASSERT_TRUE(place.has_reached(4));
  run.signal(SIGTERM);
  ASSERT_EQ(run.wait(10.0)->exit, 75);
  const auto files = place.checkpoints();
  ASSERT_EQ(files.size(), 2u);
  write_text(files[1], text_of(files[1]).substr(0, fs::file_size(files[1]) / 2));
  const Outcome rest = place.run({"--resume", "--threads", "1"});
  ASSERT_EQ(rest.exit, 0) << rest.err;
  EXPECT_TRUE(has(rest.err, files[1].filename().string())) << rest.err;
  EXPECT_TRUE(has(rest.err, "going on from " + files[0].string())) << rest.err;
  expect_same(place.out, straight().out());
}

TEST(DamagedCheckpoint, IsExitFourIfThereIsNoOther) {
  const Place place;
  ASSERT_EQ(place.run({"--threads", "1", "--max-wall", "200 ms"}).exit, 75);
  for (const fs::path& file : place.checkpoints()) {
    std::string text = text_of(file);
    text[text.size() - 1] = static_cast<char>(text.back() ^ 1);
    write_text(file, text);
  }
  const std::string before = text_of(place.out + "/log.csv");
  const Outcome rest = place.run({"--resume"});
  EXPECT_EQ(rest.exit, 4) << rest.err;
  for (const fs::path& file : place.checkpoints()) EXPECT_TRUE(has(rest.err, file.string())) << rest.err;
  EXPECT_TRUE(has(rest.err, "--force")) << rest.err;
  EXPECT_EQ(text_of(place.out + "/log.csv"), before) << "nothing was touched";
}

TEST(ChangedCase, IsRefusedWithTheKeysNamed) {
  const Place place;
  ASSERT_EQ(place.run({"--threads", "1", "--max-wall", "0 s"}).exit, 75);
  const std::string before = text_of(place.out + "/log.csv");
  const Outcome rest = place.run({"--resume", "--set", "seed=4", "--set", "motions.shaking.frequency=120 Hz",
                                  "--set", "materials.glass.friction=0.40"});
  EXPECT_EQ(rest.exit, 2) << rest.err;
  EXPECT_TRUE(has(rest.err, "seed was 3, is 4")) << rest.err;
  EXPECT_TRUE(has(rest.err, "motions.shaking.frequency was \"100 Hz\", is \"120 Hz\"")) << rest.err;
  EXPECT_FALSE(has(rest.err, "friction")) << "0.40 is 0.4: " << rest.err;
  EXPECT_EQ(text_of(place.out + "/log.csv"), before) << "nothing was touched";
}

TEST(ChangedCase, IsNoMatterIfItSaysTheSameInOtherWords) {
  const Place place;
  ASSERT_EQ(place.run({"--threads", "1", "--max-wall", "0 s"}).exit, 75);
  const Outcome rest = place.run({"--resume", "--threads", "1", "--set", "title=Another", "--set",
                                  "materials.glass.density=2500 kg/m^3", "--set", "output.interval=5 ms"});
  ASSERT_EQ(rest.exit, 0) << rest.err;
  const Json result = json_of(place.out + "/result.json");
  EXPECT_EQ(result.at("state_hash"), straight().result().at("state_hash"));
  EXPECT_EQ(result.at("title"), "Another");
  EXPECT_GT(open_series(place.out + "/parcels.pvd").size(), 18u) << "more frames from there on";
}

TEST(ChangedCase, IsRefusedIfABedItNamesHoldsOtherThings) {
  const std::string head =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id "
      "x y "
      "z radius\n";
  Place place;
  place.folder.file("bed.dump", head + "1 0.001 0.001 0.001 0.00025\n");
  place.folder.file("case.toml",
                    die_with("[sources.bed]\nkind = \"file\"\npath = \"bed.dump\"\n\n[[phases]]\nname = "
                             "\"fly\"\nsources = [\"bed\"]\nuntil = \"time\"\nduration = \"1 ms\"\n\n"));
  const Outcome first = place.run({"--threads", "1", "--max-wall", "0 s"});
  ASSERT_EQ(first.exit, 75) << first.err;
  place.folder.file("bed.dump", head + "1 0.001 0.001 0.002 0.00025\n");
  const Outcome refused = place.run({"--resume"});
  EXPECT_EQ(refused.exit, 2) << refused.err;
  EXPECT_TRUE(has(refused.err, "sources.bed.path")) << refused.err;
  // Elsewhere, but the same.
  place.folder.file("moved.dump", head + "1 0.001 0.001 0.001 0.00025\n");
  const Outcome rest = place.run({"--resume", "--threads", "1", "--set", "sources.bed.path=moved.dump"});
  EXPECT_EQ(rest.exit, 0) << rest.err;
}

TEST(Resume, DoesNotGoWithForce) {
  const Place place;
  EXPECT_EQ(place.run({"--resume", "--force"}).exit, 2);
  EXPECT_FALSE(fs::exists(place.out));
}

TEST(Resume, NeedsAFolderAndACheckpointInIt) {
  const Place place;
  Outcome outcome = place.run({"--resume"});
  EXPECT_EQ(outcome.exit, 2) << outcome.err;
  EXPECT_TRUE(has(outcome.err, place.out)) << outcome.err;
  EXPECT_FALSE(fs::exists(place.out));
  fs::create_directory(place.out);
  write_text(place.out + "/log.csv", "of something else");
  outcome = place.run({"--resume"});
  EXPECT_EQ(outcome.exit, 2) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "no checkpoint in " + place.out)) << outcome.err;
  EXPECT_EQ(text_of(place.out + "/log.csv"), "of something else");
}

TEST(Resume, OfACompleteRunSaysSoAndTouchesNothing) {
  const RunOfCase& done = straight();
  const auto before = left_in(done.out());
  const auto written = fs::last_write_time(done.out("result.json"));
  const Outcome outcome = call({"run", done.case_file(), "--out", done.out(), "--resume"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "complete")) << outcome.out;
  EXPECT_EQ(left_in(done.out()), before);
  EXPECT_EQ(fs::last_write_time(done.out("result.json")), written);
}

TEST(Resume, OfARunKilledAfterItsLastCheckpointOnlyWritesItsResult) {
  const Place place;
  ASSERT_EQ(place.run({"--threads", "1"}).exit, 0);
  Json result = json_of(place.out + "/result.json");
  result["exit"] = 1;
  write_text(place.out + "/result.json", result.dump());
  ASSERT_EQ(place.run({"--resume", "--threads", "1"}).exit, 0);
  expect_same(place.out, straight().out());
}

TEST(Resume, NoticesThatTheLogIsNotTheOneItWrote) {
  const Place place;
  ASSERT_EQ(place.run({"--threads", "1", "--max-wall", "200 ms"}).exit, 75);
  write_text(place.out + "/log.csv", "step\n");
  const Outcome rest = place.run({"--resume"});
  EXPECT_EQ(rest.exit, 4) << rest.err;
  EXPECT_TRUE(has(rest.err, "log.csv")) << rest.err;
}

TEST(TwoRuns, NeverResumeTheSameFolderAtOnceButAKilledOneIsNoHindrance) {
  const Place place;
  const std::vector<std::string> endless{"--threads", "1", "--set", "phases.measure.duration=1000 s"};
  Process first(place.command(endless));
  ASSERT_TRUE(place.has_reached(2));
  auto again = endless;
  again.push_back("--resume");
  const Outcome second = place.run(again);
  EXPECT_EQ(second.exit, 2) << second.err;
  EXPECT_TRUE(has(second.err, "another run is writing")) << second.err;
  first.signal(SIGKILL);
  ASSERT_EQ(first.wait(10.0)->exit, 128 + SIGKILL);
  EXPECT_TRUE(fs::exists(place.out + "/.pulvis.lock")) << "it could not clean up";
  again.insert(again.end(), {"--max-wall", "0 s"});
  EXPECT_EQ(place.run(again).exit, 75);
}

}  // namespace
