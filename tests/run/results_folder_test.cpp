// SPDX-License-Identifier: Apache-2.0
// The folder for the results: used, unwritable, full.
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

const std::string brief = with(thrown(R"(["0 m/s", "0 m/s", "0 m/s"])"), "20 ms", "5 ms");

TEST(UsedFolder, IsRefusedWithoutForce) {
  const RunOfCase first(brief);
  ASSERT_EQ(first.exit(), 0) << first.outcome().err;
  const std::string before = text_of(first.out("result.json"));
  const Outcome again = call({"run", first.case_file(), "--out", first.out(), "--set", "seed=9"});
  EXPECT_EQ(again.exit, 2);
  EXPECT_TRUE(has(again.err, first.out())) << again.err;
  EXPECT_TRUE(has(again.err, "--force")) << again.err;
  EXPECT_EQ(text_of(first.out("result.json")), before) << "nothing was touched";
}

TEST(UsedFolder, IsRefusedForForeignFilesToo) {
  TemporaryFolder folder;
  fs::create_directory(folder / "out");
  folder.file("out/thesis.tex", "years of work");
  const Outcome outcome = call({"run", folder.file("case.toml", brief), "--out", folder / "out"});
  EXPECT_EQ(outcome.exit, 2) << outcome.err;
}

TEST(UsedFolder, IsReplacedWithForceAndForeignFilesStay) {
  const RunOfCase first(brief, {"--threads", "1", "--set", "output.interval=\"0.5 ms\""});
  ASSERT_EQ(first.exit(), 0) << first.outcome().err;
  write_text(first.out("notes.txt"), "mine");
  write_text(first.out("frames/notes.txt"), "mine too");
  write_text(first.out("frames/parcels-best.vtp.bak"), "a copy");
  ASSERT_TRUE(fs::exists(first.out("frames/parcels-000009.vtp")));
  const Outcome again = call({"run", first.case_file(), "--out", first.out(), "--force", "--set", "seed=9"});
  ASSERT_EQ(again.exit, 0) << again.err;
  EXPECT_EQ(text_of(first.out("notes.txt")), "mine");
  EXPECT_EQ(text_of(first.out("frames/notes.txt")), "mine too");
  EXPECT_EQ(text_of(first.out("frames/parcels-best.vtp.bak")), "a copy");
  EXPECT_FALSE(fs::exists(first.out("frames/parcels-000009.vtp"))) << "a frame of the earlier run";
  EXPECT_EQ(json_of(first.out("run.json")).at("keys").at("seed").at("value"), "9");
  EXPECT_EQ(open_series(first.out("parcels.pvd")).size(), 2u);
}

TEST(UsedFolder, IsRefusedEvenWithForceIfTheCaseLiesInIt) {
  TemporaryFolder folder;
  folder.file("result.json", "of an earlier run");
  const std::string file = folder.file("case.toml", brief);
  fs::create_directory_symlink(folder.path(), folder / "link");
  for (const std::string& out : {folder.path().string(), folder.path().string() + "/", folder / "link"}) {
    const Outcome outcome = call({"run", file, "--out", out, "--force"});
    EXPECT_EQ(outcome.exit, 2) << outcome.err;
    EXPECT_TRUE(has(outcome.err, file)) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "another --out")) << outcome.err;
  }
  EXPECT_EQ(text_of(file), brief);
  EXPECT_EQ(text_of(folder / "result.json"), "of an earlier run") << "nothing was removed";
  Surroundings inside;
  inside.folder = folder.path().string();
  EXPECT_EQ(call({"run", "case.toml", "--out", ".", "--force"}, inside).exit, 2);
  EXPECT_EQ(text_of(file), brief);
}

TEST(UsedFolder, IsRefusedEvenWithForceIfABedLiesInIt) {
  TemporaryFolder folder;
  fs::create_directory(folder / "out");
  const std::string bed =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n"
      "0 1\nITEM: ATOMS id x y z radius\n1 0.001 0.001 0.001 0.00025\n";
  folder.file("out/log.csv", bed);
  const std::string file =
      folder.file("case.toml",
                  die_with("[sources.bed]\nkind = \"file\"\npath = \"out/log.csv\"\n\n[[phases]]\n"
                           "name = \"fly\"\nsources = [\"bed\"]\nuntil = \"time\"\nduration = \"1 ms\"\n\n"));
  const Outcome outcome = call({"run", file, "--out", folder / "out", "--force"});
  EXPECT_EQ(outcome.exit, 2) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "bed " + folder / "out/log.csv")) << outcome.err;
  EXPECT_EQ(text_of(folder / "out/log.csv"), bed);
  EXPECT_EQ(call({"run", file, "--out", folder / "other"}).exit, 0);
}

TEST(UsedFolder, KeepsPicturesOfTheUser) {
  const std::string text = with(with(brief, "\"5 ms\"", "\"1 ms\""), "picture = false", "picture = true");
  const RunOfCase first(text);
  ASSERT_EQ(first.exit(), 0) << first.outcome().err;
  write_text(first.out("picture-of-the-press.png"), "mine");
  fs::create_directory(first.out("pictures"));
  write_text(first.out("pictures/press.png"), "mine");
  write_text(first.out("pictures/after-old.png"), "of an earlier run");
  const Outcome again = call({"run", first.case_file(), "--out", first.out(), "--force"});
  ASSERT_EQ(again.exit, 0) << again.err;
  EXPECT_EQ(text_of(first.out("picture-of-the-press.png")), "mine");
  EXPECT_EQ(text_of(first.out("pictures/press.png")), "mine");
  EXPECT_FALSE(fs::exists(first.out("pictures/after-old.png")));
}

TEST(UsedFolder, IsLeftAloneIfTheCaseIsWrong) {
  const RunOfCase first(brief);
  ASSERT_EQ(first.exit(), 0) << first.outcome().err;
  const Outcome again = call({"run", first.case_file(), "--out", first.out(), "--force", "--set", "seed=-1"});
  EXPECT_EQ(again.exit, 3);
  EXPECT_EQ(first.result().at("exit"), 0) << "the results of the first run are still there";
}

TEST(UnwritableFolder, IsExitSixAndNamed) {
  TemporaryFolder folder;
  const std::string file = folder.file("case.toml", brief);
  // Even the administrator can write nothing below a file, nor make a folder in /proc.
  for (const std::string& out : {file + "/out", std::string("/proc/pulvis-results")}) {
    const Outcome outcome = call({"run", file, "--out", out});
    EXPECT_EQ(outcome.exit, 6) << outcome.err;
    EXPECT_TRUE(has(outcome.err, out)) << outcome.err;
  }
  EXPECT_EQ(call({"new", "die-filling", file + "/new"}).exit, 6);
}

/// A disk of a few kilobytes that only this test and its children see; gone when they end.
bool mount_small_disk(const std::string& place, int kilobytes) {
  if (::unshare(CLONE_NEWNS) != 0) return false;
  if (::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  return ::mount("tmpfs", place.c_str(), "tmpfs", 0, fmt::format("size={}k", kilobytes).c_str()) == 0;
}

TEST(FullDisk, IsExitSixAndLeavesNoHalfFile) {
  TemporaryFolder folder;
  fs::create_directory(folder / "disk");
  const std::string file = folder.file("case.toml", small_die), out = folder / "disk/out";
  if (!mount_small_disk(folder / "disk", 200)) GTEST_SKIP() << "no right to mount a small disk here";
  const Outcome outcome =
      call({"run", file, "--out", out, "--threads", "1", "--set", "output.interval=\"0.2 ms\""});
  const auto remove_disk = [&] { ::umount((folder / "disk").c_str()); };
  EXPECT_EQ(outcome.exit, 6) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "cannot write " + out)) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "space")) << outcome.err;
  std::size_t frames = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const std::string name = entry.path().string();
    if (!entry.is_regular_file()) continue;
    EXPECT_NE(entry.path().extension(), ".part") << name;
    const std::string text = text_of(name);
    if (entry.path().extension() == ".vtp" || entry.path().extension() == ".vti") {
      EXPECT_TRUE(text.ends_with("</VTKFile>\n") || text.ends_with("</VTKFile>")) << name << " is cut off";
      ++frames;
    } else if (entry.path().extension() == ".json") {
      EXPECT_TRUE(Json::accept(text)) << name << " is cut off";
    } else if (entry.path().extension() == ".csv") {
      EXPECT_TRUE(text.ends_with("\n")) << name << " is cut off";
    }
  }
  EXPECT_GT(frames, 3u) << "the disk was full too early to tell";
  EXPECT_TRUE(vtk_reads_all_of(out));
  if (fs::exists(out + "/result.json")) {
    EXPECT_EQ(json_of(out + "/result.json").at("exit"), 6);
  }
  remove_disk();
}

TEST(FullDisk, BehindTheStandardOutputIsExitSixToo) {
  TemporaryFolder folder;
  Surroundings shell;
  shell.executable = "/bin/sh";
  const Outcome outcome =
      call({"-c", program_path() + " check " + folder.file("case.toml", small_die) + " > /dev/full"}, shell);
  EXPECT_EQ(outcome.exit, 6);
  EXPECT_TRUE(has(outcome.err, "standard output")) << outcome.err;
}

TEST(FullDisk, IsExitSixFromTheFirstFileOn) {
  TemporaryFolder folder;
  fs::create_directory(folder / "disk");
  const std::string file = folder.file("case.toml", small_die), out = folder / "disk/out";
  if (!mount_small_disk(folder / "disk", 4)) GTEST_SKIP() << "no right to mount a small disk here";
  const Outcome outcome = call({"run", file, "--out", out, "--threads", "1"});
  EXPECT_EQ(outcome.exit, 6) << outcome.err;
  EXPECT_TRUE(has(outcome.err, out)) << outcome.err;
  ::umount((folder / "disk").c_str());
}

}  // namespace
