// SPDX-License-Identifier: Apache-2.0
#include "output/run_folder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <vector>

#include "failures.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;
const std::vector<std::string> results{"log.csv", "*.pvd", "frames/*.vtp"};

TEST(RunFolder, IsCreatedWithTheFoldersAboveItAndLeftClean) {
  ScratchFolder folder;
  {
    RunFolder run(folder.file("a/b/"), UsedFolder::refuse, results);
    EXPECT_EQ(run.path(), folder.file("a/b"));
    EXPECT_EQ(run.file("log.csv"), folder.file("a/b/log.csv"));
    EXPECT_TRUE(std::filesystem::is_directory(run.folder("frames")));
  }
  EXPECT_TRUE(folder.has("a/b/frames"));
  EXPECT_FALSE(folder.has("a/b/.pulvis.lock"));
}

TEST(RunFolder, RefusesAUsedFolderAndNamesForce) {
  ScratchFolder folder;
  put(folder.file("thesis.txt"), "mine");
  const auto message =
      failure_of(Exit::usage, [&] { RunFolder(folder.path(), UsedFolder::refuse, results); });
  EXPECT_NE(message.find("--force"), std::string::npos) << message;
  EXPECT_NE(message.find(folder.path()), std::string::npos) << message;
  EXPECT_EQ(content_of(folder.file("thesis.txt")), "mine");
  EXPECT_FALSE(folder.has(".pulvis.lock"));
}

TEST(RunFolder, ForceRemovesResultsAndNothingElse) {
  ScratchFolder folder;
  for (const char* name : {"log.csv", "log.csv.part", "parcels.pvd", "frames/p_1.vtp", "frames/p_2.vtp.part"})
    put(folder.file(name), "result");
  for (const char* name :
       {"notes.txt", "frames/notes.txt", "frames/deeper/p_3.vtp", "other/p_1.vtp", "mylog.csv"})
    put(folder.file(name), "mine");
  std::filesystem::create_directory(folder.file("folder.pvd"));
  RunFolder run(folder.path(), UsedFolder::replace_results, results);
  for (const char* name : {"log.csv", "log.csv.part", "parcels.pvd", "frames/p_1.vtp", "frames/p_2.vtp.part"})
    EXPECT_FALSE(folder.has(name)) << name;
  for (const char* name :
       {"notes.txt", "frames/notes.txt", "frames/deeper/p_3.vtp", "other/p_1.vtp", "mylog.csv", "folder.pvd"})
    EXPECT_TRUE(folder.has(name)) << name;
}

TEST(RunFolder, ForceRemovesASubFolderThatItEmptied) {
  ScratchFolder folder;
  put(folder.file("frames/p_1.vtp"), "result");
  RunFolder run(folder.path(), UsedFolder::replace_results, results);
  EXPECT_FALSE(folder.has("frames"));
}

TEST(RunFolder, ForceFollowsNoLinks) {
  ScratchFolder folder;
  put(folder.file("archive/p_1.vtp"), "mine");
  put(folder.file("archive/log.csv"), "mine");
  std::filesystem::create_directory(folder.file("run"));
  std::filesystem::create_directory_symlink(folder.file("archive"), folder.file("run/frames"));
  std::filesystem::create_symlink(folder.file("archive/log.csv"), folder.file("run/log.csv"));
  RunFolder run(folder.file("run"), UsedFolder::replace_results, results);
  EXPECT_TRUE(folder.has("archive/p_1.vtp"));
  EXPECT_TRUE(folder.has("archive/log.csv"));
}

TEST(RunFolder, RefusesASecondRunEvenWithForceUntilTheFirstEnds) {
  ScratchFolder folder;
  auto first = std::make_unique<RunFolder>(folder.path(), UsedFolder::refuse, results);
  put(folder.file("log.csv"), "of the first");
  const auto message =
      failure_of(Exit::usage, [&] { RunFolder(folder.path(), UsedFolder::replace_results, results); });
  EXPECT_NE(message.find("another run"), std::string::npos) << message;
  EXPECT_EQ(content_of(folder.file("log.csv")), "of the first");
  first.reset();
  RunFolder second(folder.path(), UsedFolder::replace_results, results);
  EXPECT_FALSE(folder.has("log.csv"));
}

TEST(RunFolder, IsFreeAgainAfterARunThatWasKilled) {
  ScratchFolder folder;
  const pid_t run = ::fork();
  if (run == 0) {
    RunFolder held(folder.path(), UsedFolder::refuse, results);
    ::_exit(0);  // as if killed: no destructor runs, the lock file stays
  }
  int status = 0;
  ASSERT_EQ(::waitpid(run, &status, 0), run);
  ASSERT_TRUE(folder.has(".pulvis.lock"));
  EXPECT_NO_THROW(RunFolder(folder.path(), UsedFolder::refuse, results));
}

TEST(RunFolder, FailsWhereAFileIsInTheWay) {
  ScratchFolder folder;
  put(folder.file("plain"), "mine");
  failure_of(Exit::io, [&] { RunFolder(folder.file("plain"), UsedFolder::replace_results, results); });
  failure_of(Exit::io, [&] { RunFolder(folder.file("plain/below"), UsedFolder::refuse, results); });
  EXPECT_EQ(content_of(folder.file("plain")), "mine");
}

TEST(RunFolder, FailsWhereNothingMayBeWritten) {
  if (!std::filesystem::is_directory("/proc/self")) GTEST_SKIP() << "no /proc here";
  // Not even root creates files there.
  const auto message = failure_of(Exit::io, [] { RunFolder("/proc/self", UsedFolder::refuse, results); });
  EXPECT_NE(message.find("cannot write /proc/self"), std::string::npos) << message;
}

TEST(RunFolder, IsResumedWithAllThatIsInIt) {
  ScratchFolder folder;
  for (const char* name : {"log.csv", "a.pvd", "frames/p_1.vtp", "notes.txt"})
    put(folder.file(name), "there");
  RunFolder run(folder.path(), UsedFolder::resume, results);
  for (const char* name : {"log.csv", "a.pvd", "frames/p_1.vtp", "notes.txt"}) EXPECT_TRUE(folder.has(name));
}

TEST(RunFolder, IsNotMadeToBeResumed) {
  ScratchFolder folder;
  const auto message =
      failure_of(Exit::usage, [&] { RunFolder(folder.file("none"), UsedFolder::resume, results); });
  EXPECT_NE(message.find("--resume"), std::string::npos) << message;
  EXPECT_FALSE(folder.has("none"));
}

TEST(RunFolder, RemovesTheResultsThatAreNotKnown) {
  ScratchFolder folder;
  for (const char* name : {"log.csv", "a.pvd", "frames/p_1.vtp", "frames/p_2.vtp", "frames/p_2.vtp.part"})
    put(folder.file(name), "result");
  put(folder.file("notes.txt"), "mine");
  RunFolder run(folder.path(), UsedFolder::resume, results);
  run.remove_results(results, {"log.csv", "frames/p_1.vtp"});
  for (const char* name : {"log.csv", "frames/p_1.vtp", "notes.txt"}) EXPECT_TRUE(folder.has(name)) << name;
  for (const char* name : {"a.pvd", "frames/p_2.vtp", "frames/p_2.vtp.part"})
    EXPECT_FALSE(folder.has(name)) << name;
}

}  // namespace
}  // namespace pulvis
