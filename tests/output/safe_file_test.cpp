// SPDX-License-Identifier: Apache-2.0
#include "output/safe_file.hpp"

#include <unistd.h>

#include <algorithm>

#include "failures.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;

TEST(SafeFile, HasItsNameAndAllItsBytesOnlyAfterCommit) {
  ScratchFolder folder;
  SafeFile file(folder.file("a.bin"));
  file.write(std::string_view("one\0two", 7));
  EXPECT_FALSE(folder.has("a.bin"));
  file.commit();
  EXPECT_EQ(content_of(folder.file("a.bin")), std::string("one\0two", 7));
  EXPECT_FALSE(folder.has("a.bin.part"));
}

TEST(SafeFile, LeavesTheOldFileAndNoOtherWhenGivenUp) {
  ScratchFolder folder;
  put(folder.file("a.txt"), "old");
  {
    SafeFile file(folder.file("a.txt"));
    file.write("new");
  }
  EXPECT_EQ(content_of(folder.file("a.txt")), "old");
  EXPECT_FALSE(folder.has("a.txt.part"));
}

TEST(SafeFile, SaysThatTheDiskIsFullAndKeepsTheOldFile) {
  ScratchFolder folder;
  put(folder.file("a.txt"), "old");
  const auto message = failure_of(Exit::io, [&] {
    write_file_safely(folder.file("a.txt"), "longer than ten bytes", SmallDisk::calls(10));
  });
  EXPECT_EQ(message, "cannot write " + folder.file("a.txt") +
                         ": No space left on device; free some space or choose another results folder");
  EXPECT_EQ(content_of(folder.file("a.txt")), "old");
  EXPECT_FALSE(folder.has("a.txt.part"));
}

TEST(SafeFile, FailsWhereTheDiskRefusesToSync) {
  ScratchFolder folder;
  FileCalls calls = FileCalls::system();
  calls.sync = [](int) {
    errno = EIO;
    return -1;
  };
  const auto message = failure_of(Exit::io, [&] { write_file_safely(folder.file("a.txt"), "x", calls); });
  EXPECT_NE(message.find("Input/output error"), std::string::npos) << message;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(SafeFile, FailsWhereTheNameCannotBeTaken) {
  ScratchFolder folder;
  std::filesystem::create_directories(folder.file("a.txt/inside"));
  const auto message = failure_of(Exit::io, [&] { write_file_safely(folder.file("a.txt"), "x"); });
  EXPECT_NE(message.find("a folder of that name is in the way"), std::string::npos) << message;
  EXPECT_FALSE(folder.has("a.txt.part"));
}

TEST(SafeFile, GoesOnAfterInterruptionsAndPartialWrites) {
  ScratchFolder folder;
  FileCalls calls = FileCalls::system();
  calls.write = [](int file, const void* data, std::size_t size) -> ssize_t {
    static int count = 0;
    if (++count % 2 == 1) {
      errno = EINTR;
      return -1;
    }
    return FileCalls::system().write(file, data, std::min<std::size_t>(size, 3));
  };
  write_file_safely(folder.file("a.txt"), "abcdefgh", calls);
  EXPECT_EQ(content_of(folder.file("a.txt")), "abcdefgh");
}

TEST(SafeFile, FailsInAFolderThatIsAFile) {
  ScratchFolder folder;
  put(folder.file("plain"), "");
  const auto message = failure_of(Exit::io, [&] { write_file_safely(folder.file("plain/a.txt"), "x"); });
  EXPECT_NE(message.find("check that its folder exists"), std::string::npos) << message;
}

TEST(SafeFile, FailsInAFolderWithoutPermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  ScratchFolder folder;
  std::filesystem::permissions(folder.path(),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const auto message = failure_of(Exit::io, [&] { write_file_safely(folder.file("a.txt"), "x"); });
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  EXPECT_NE(message.find("Permission denied"), std::string::npos) << message;
}

}  // namespace
}  // namespace pulvis
