// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "report/report.hpp"
#include "tests/output/failures.hpp"
#include "tests/output/scratch_folder.hpp"
#include "tests/report/sample_run.hpp"
#include "tests/run/program.hpp"

using namespace pulvis;
using namespace pulvis::test;

namespace {

using Json = nlohmann::ordered_json;

/// What the report says of a sample run one file of which was replaced.
std::string failure_with(const std::string& file, const std::string& content) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"), {.pictures = false});
  put(scratch.file("run/" + file), content);
  const std::string message =
      failure_of(Exit::bad_input, [&] { report::write_report(scratch.file("run"), ""); });
  EXPECT_FALSE(scratch.has("run/report.html"));
  EXPECT_FALSE(scratch.has("run/report"));
  EXPECT_NE(message.find(file), std::string::npos) << message;
  return message;
}

TEST(RunFolderToRead, MustBeThere) {
  const tests::Outcome outcome = tests::call({"report", "/nowhere/at-all"});
  EXPECT_EQ(outcome.exit, 4);
  EXPECT_NE(outcome.err.find("/nowhere/at-all is not a folder"), std::string::npos) << outcome.err;
}

TEST(RunFolderToRead, MustHoldARun) {
  const ScratchFolder scratch;
  const std::string message = failure_of(Exit::bad_input, [&] { report::write_report(scratch.path(), ""); });
  EXPECT_NE(message.find("holds no run"), std::string::npos);
  EXPECT_FALSE(scratch.has("report.html"));
}

TEST(RunFolderToRead, NamesADamagedJsonFile) {
  failure_with("result.json", "{\"exit\": 0, ");
  failure_with("run.json", "");
  failure_with("measures/after-shake.json", "\xff\xfe");
  failure_with("result.json", std::string(100'000, '['));
}

TEST(RunFolderToRead, NamesTheEntryThatIsWrong) {
  EXPECT_NE(failure_with("result.json", "[]").find("expected an object"), std::string::npos);
  EXPECT_NE(failure_with("result.json", R"({"exit": "no"})").find("/exit: expected a number"),
            std::string::npos);
  EXPECT_NE(failure_with("result.json", R"({"exit": 0, "phases": [{"name": 3}]})").find("/phases/0/name"),
            std::string::npos);
  EXPECT_NE(failure_with("result.json", R"({"exit": 0, "phases": [{"name": "../../etc"}]})")
                .find("no name of a phase"),
            std::string::npos);
  EXPECT_NE(failure_with("run.json", R"({"keys": {"seed": {"value": 1}}})").find("/keys/seed/value"),
            std::string::npos);
}

TEST(RunFolderToRead, NamesWhatIsWrongInMeasures) {
  const std::string file = "measures/after-shake.json",
                    start = R"({"format": "pulvis measures", "version": 1, "phase": "shake", "time_s": 1, )";
  const auto failure = [&](const std::string& rest) { return failure_with(file, start + rest + "}"); };
  EXPECT_NE(failure(R"("porosity": {"cells": [2, 2], "spacing_m": [1, 1, 1], "values": [], "volume_m3": []})")
                .find("/porosity/cells"),
            std::string::npos);
  EXPECT_NE(
      failure(R"("porosity": {"cells": [2, 2, 1], "spacing_m": [1, 1, 1], "values": [1], "volume_m3": []})")
          .find("expected 4 numbers, not 1"),
      std::string::npos);
  EXPECT_NE(
      failure(
          R"("porosity": {"cells": [99999999, 99999999, 99999999], "spacing_m": [1, 1, 1], "values": [1], "volume_m3": []})")
          .find("the size of a grid"),
      std::string::npos);
  EXPECT_NE(
      failure(R"("porosity": {"cells": [-1, 1, 1], "spacing_m": [1, 1, 1], "values": [], "volume_m3": []})")
          .find("whole number"),
      std::string::npos);
  EXPECT_NE(failure(R"("surface": {"columns": [1, 1], "spacing_m": [0, 1], "heights_m": [1]})")
                .find("lengths above zero"),
            std::string::npos);
  EXPECT_NE(failure(R"("porosity_histogram": {"edges": [1], "share": [1]})").find("one edge more"),
            std::string::npos);
  EXPECT_NE(failure(R"("layers": {"height_m": [1], "stress_Pa": [[[1, 2]]]})").find("/layers/stress_Pa/0"),
            std::string::npos);
  EXPECT_NE(failure_with(file, R"({"format": "something else"})").find("pulvis measures"), std::string::npos);
}

TEST(RunFolderToRead, OfAnotherVersionOfTheMeasuresSaysWhichOneIsRead) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"), {.version = 2});
  const std::string message =
      failure_of(Exit::bad_input, [&] { report::write_report(scratch.file("run"), ""); });
  EXPECT_NE(message.find("version 2"), std::string::npos);
  EXPECT_NE(message.find("reads version 1"), std::string::npos);
}

TEST(RunFolderToRead, NamesTheLineOfADamagedTable) {
  EXPECT_NE(failure_with("log.csv", "time_s,kinetic_energy_J\n0,1\n1\n").find("log.csv:3: 1 cells"),
            std::string::npos);
  EXPECT_NE(failure_with("measures.csv", "time_s,porosity_mean\n0,abc\n").find("measures.csv:2: \"abc\""),
            std::string::npos);
  EXPECT_NE(failure_with("log.csv", "time_s,\"x\n0,1\n").find("quote"), std::string::npos);
  EXPECT_NE(failure_with("log.csv", "").find("no header"), std::string::npos);
  EXPECT_NE(failure_with("wall-pressure/after-shake.csv", "wall,surface\na,b\n").find("no column u_m"),
            std::string::npos);
}

TEST(RunFolderToRead, MayHoldADamagedPictureOrCase) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  put(scratch.file("run/picture.png"), "not a picture");
  put(scratch.file("run/case.toml"), "title = [");
  report::write_report(scratch.file("run"), "");
  const std::string page = content_of(scratch.file("run/report.html"));
  EXPECT_NE(page.find("picture.png is not a whole PNG image"), std::string::npos);
  EXPECT_NE(page.find("The case cannot be put into words"), std::string::npos);
}

TEST(RunFolderToRead, MayHoldNumbersThatCannotBeDrawn) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  put(scratch.file("run/log.csv"), "time_s,kinetic_energy_J\n0,-1\n1e308,1e308\n-1e308,inf\nnan,0\n");
  put(scratch.file("run/measures.csv"), "porosity_mean\n1e-320\n");
  put(scratch.file("run/wall-pressure/after-shake.csv"),
      "wall,surface,u_m,v_m,area_m2,pressure_Pa\nw,w.-x,1e300,1e300,1e-300,1\nw,w.+x,,,0,1\n,,nan,0,1,nan\nw,"
      "s,1e-310,0,1e308,5\n");
  Json m = Json::parse(content_of(scratch.file("run/measures/after-shake.json")));
  m["surface"]["heights_m"] = {1e308, -1e308, nullptr, 0.0};
  m["coordination"]["count"] = Json::array();
  m["porosity"]["values"] = Json::array();
  for (int k = 0; k < 18; ++k) m["porosity"]["values"].push_back(nullptr);
  m["porosity_profiles"] = Json::array();
  m["scalars"]["porosity_mean"]["value"] = nullptr;
  m["scalars"]["strange"] = {{"value", 3.0}, {"unit", "furlong"}};
  m["contact_forces"]["density"] = {0, 0, 0};
  put(scratch.file("run/measures/after-shake.json"), m.dump());
  const tests::Outcome outcome = tests::call({"report", scratch.file("run")});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_NE(content_of(scratch.file("run/report.html")).find("furlong"), std::string::npos);
}

TEST(RunFolderToRead, EveryShortenedFileIsRefusedOrRead) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"), {.pictures = false});
  for (const char* name : {"result.json", "run.json", "measures/after-shake.json", "log.csv", "measures.csv",
                           "wall-pressure/after-fill.csv", "case.toml"}) {
    const std::string path = scratch.file(std::string("run/") + name), whole = content_of(path);
    for (int part = 0; part < 12; ++part) {
      put(path, whole.substr(0, whole.size() * part / 12));
      try {
        report::read_run(scratch.file("run"));
      } catch (const Failure& failure) {
        EXPECT_EQ(failure.code(), Exit::bad_input) << name;
        EXPECT_NE(std::string(failure.what()).find(name), std::string::npos) << failure.what();
      }
    }
    put(path, whole);
  }
}

TEST(Report, ThatCannotBeWrittenLeavesTheOlderOne) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"), {.pictures = false});
  put(scratch.file("run/report.html"), "older");
  put(scratch.file("run/report"), "a file where the folder should be");
  const tests::Outcome outcome = tests::call({"report", scratch.file("run")});
  EXPECT_EQ(outcome.exit, 6);
  EXPECT_NE(outcome.err.find("cannot create"), std::string::npos) << outcome.err;
  EXPECT_EQ(content_of(scratch.file("run/report.html")), "older");
}

TEST(Report, OfADamagedRunLeavesTheOlderOne) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"), {.pictures = false});
  put(scratch.file("run/report.html"), "older");
  put(scratch.file("run/log.csv"), "");
  failure_of(Exit::bad_input, [&] { report::write_report(scratch.file("run"), ""); });
  EXPECT_EQ(content_of(scratch.file("run/report.html")), "older");
  EXPECT_FALSE(scratch.has("run/report"));
}

TEST(Report, WithoutAFolderIsAUsageError) {
  EXPECT_EQ(tests::call({"report"}).exit, 2);
  EXPECT_EQ(tests::call({"compare", "a", "b"}).exit, 2);
}

}  // namespace
