// SPDX-License-Identifier: Apache-2.0
#include "output/csv.hpp"

#include <cstdlib>
#include <stdexcept>

#include "failures.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;

TEST(CsvLog, StartsWithItsHeaderAndHoldsEachLineAtOnce) {
  ScratchFolder folder;
  CsvLog log(folder.file("log.csv"), {"time_s", "parcels", "phase"});
  EXPECT_EQ(content_of(folder.file("log.csv")), "time_s,parcels,phase\n");
  log.add({0.1, std::int64_t{12}, "fill"});
  EXPECT_EQ(content_of(folder.file("log.csv")), "time_s,parcels,phase\n0.1,12,fill\n");
}

TEST(CsvLog, WritesDoublesThatReadBackAsTheSameBits) {
  ScratchFolder folder;
  for (const double value : {0.1, 1.0 / 3.0, 6.02214076e23, -1.7976931348623157e308, 5e-324, 4.6e-6, 1e22}) {
    CsvLog log(folder.file("log.csv"), {"x"});
    log.add({value});
    EXPECT_EQ(std::strtod(content_of(folder.file("log.csv")).c_str() + 2, nullptr), value);
  }
}

TEST(CsvLog, QuotesTextThatWouldBreakTheTable) {
  ScratchFolder folder;
  CsvLog log(folder.file("log.csv"), {"phase", "n"});
  log.add({"fill, then \"settle\"", std::int64_t{-1}});
  EXPECT_EQ(content_of(folder.file("log.csv")), "phase,n\n\"fill, then \"\"settle\"\"\",-1\n");
}

TEST(CsvLog, RefusesALineOfAnotherLength) {
  ScratchFolder folder;
  CsvLog log(folder.file("log.csv"), {"a", "b"});
  EXPECT_THROW(log.add({1.0}), std::invalid_argument);
  EXPECT_EQ(content_of(folder.file("log.csv")), "a,b\n");
}

TEST(CsvLog, TakesBackTheLineThatDidNotFit) {
  ScratchFolder folder;
  CsvLog log(folder.file("log.csv"), {"a"}, SmallDisk::calls(9));
  log.add({0.25});  // 2 bytes of header and 5 of this leave 2
  const auto message = failure_of(Exit::io, [&] { log.add({0.125}); });
  EXPECT_NE(message.find("No space left on device"), std::string::npos) << message;
  EXPECT_EQ(content_of(folder.file("log.csv")), "a\n0.25\n");
}

TEST(CsvTable, AppearsWithAllItsLinesOrNotAtAll) {
  ScratchFolder folder;
  CsvTable table({"a", "b"});
  table.add({1.5, "x,y"});
  EXPECT_THROW(table.add({1.5}), std::invalid_argument);
  const auto message =
      failure_of(Exit::io, [&] { table.save(folder.file("table.csv"), SmallDisk::calls(9)); });
  EXPECT_NE(message.find("table.csv"), std::string::npos) << message;
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("")));
  table.save(folder.file("table.csv"));
  EXPECT_EQ(content_of(folder.file("table.csv")), "a,b\n1.5,\"x,y\"\n");
}

TEST(CsvLog, FailsOnADeviceThatIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto message = failure_of(Exit::io, [] { CsvLog("/dev/full", {"a"}); });
  EXPECT_EQ(
      message,
      "cannot write /dev/full: No space left on device; free some space or choose another results folder");
}

TEST(CsvLog, FailsWithoutItsFolder) {
  ScratchFolder folder;
  failure_of(Exit::io, [&] { CsvLog(folder.file("missing/log.csv"), {"a"}); });
}

TEST(CsvLog, GoesOnWhereItWasWhateverWasAddedSince) {
  ScratchFolder folder;
  const std::string file = folder.file("log.csv");
  std::uint64_t length = 0;
  {
    CsvLog log(file, {"a", "b"});
    log.add({0.25, 1.0});
    length = log.sync();
    log.add({0.5, 2.0});
  }
  put(file, content_of(file) + "0.75,");  // torn by a crash
  EXPECT_EQ(length, 11u);
  CsvLog log = CsvLog::continued(file, {"a", "b"}, length);
  EXPECT_EQ(content_of(file), "a,b\n0.25,1\n") << "cut back at once";
  log.add({0.5, 3.0});
  EXPECT_EQ(content_of(file), "a,b\n0.25,1\n0.5,3\n");
}

TEST(CsvLog, DoesNotGoOnWithAFileThatIsNotTheOneWritten) {
  ScratchFolder folder;
  const std::string file = folder.file("log.csv");
  failure_of(Exit::bad_input, [&] { CsvLog::continued(file, {"a"}, 10); });
  put(file, "a\n0.5\n0.75\n");
  for (const std::uint64_t length : {0, 3, 12, 1000}) {
    const auto message = failure_of(Exit::bad_input, [&] { CsvLog::continued(file, {"a"}, length); });
    EXPECT_NE(message.find(file), std::string::npos) << message;
  }
  EXPECT_EQ(content_of(file), "a\n0.5\n0.75\n") << "it was left as it is";
}

}  // namespace
}  // namespace pulvis
