// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>

#include "report/report.hpp"
#include "tests/output/scratch_folder.hpp"
#include "tests/report/sample_run.hpp"
#include "tests/run/program.hpp"

// The pages in a real browser, if chromium is there: nothing to complain of, nothing fetched, every image drawn.
using namespace pulvis;
using namespace pulvis::test;

namespace {

constexpr const char* chromium = "/usr/bin/chromium";

/// What the browser prints when it opens a page. It resolves no name, for it would look for news of itself.
tests::Outcome open(const ScratchFolder& scratch, const std::string& page) {
  tests::Surroundings browser;
  browser.executable = chromium;
  return tests::call(
      {"--headless", "--no-sandbox", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND",
       "--user-data-dir=" + scratch.file("profile"), "--enable-logging=stderr", "--virtual-time-budget=5000",
       "--log-net-log=" + scratch.file("net.json"), "--dump-dom", "file://" + page},
      browser);
}

bool complained(const tests::Outcome& seen) { return seen.err.find("CONSOLE") != std::string::npos; }

/// Whether the last page that was opened asked for something. What the browser asks for itself has "not an origin" as its
/// initiator.
bool fetched(const ScratchFolder& scratch) {
  const std::string net = content_of(scratch.file("net.json")), initiator = "\"initiator\":\"";
  EXPECT_FALSE(net.empty());
  for (auto at = net.find(initiator); at != std::string::npos; at = net.find(initiator, at + 1))
    if (net.compare(at + initiator.size(), 13, "not an origin") != 0) return true;
  return false;
}

/// The page with a script that, once all is there, counts images and those that have no size; a page of ours forbids
/// scripts, so that is taken out.
std::string with_counter(std::string page) {
  const auto at = page.find("<meta http-equiv=\"Content-Security-Policy\"");
  EXPECT_NE(at, std::string::npos);
  page.erase(at, page.find('>', at) + 1 - at);
  return page.insert(
      page.rfind("</body>"),
      "<script>addEventListener('load',()=>{const all=[...document.images];document.body.setAttribute("
      "'data-images',all.length+' images, '+all.filter(i=>!i.complete||i.naturalWidth<10||"
      "i.getBoundingClientRect().height<10).length+' broken')})</script>");
}

void expect_sound(const ScratchFolder& scratch, const std::string& page, const std::string& images) {
  const tests::Outcome seen = open(scratch, page);
  ASSERT_EQ(seen.exit, 0) << seen.err;
  EXPECT_NE(seen.out.find("</html>"), std::string::npos);
  EXPECT_FALSE(complained(seen)) << seen.err;
  EXPECT_FALSE(fetched(scratch));
  put(scratch.file("counted.html"), with_counter(content_of(page)));
  const tests::Outcome counted = open(scratch, scratch.file("counted.html"));
  EXPECT_NE(counted.out.find("data-images=\"" + images + " images, 0 broken\""), std::string::npos)
      << counted.out.substr(counted.out.find("data-images"), 60);
}

TEST(Browser, ShowsEveryFigureOfAReportAndFetchesNothing) {
  if (!std::filesystem::exists(chromium)) GTEST_SKIP() << "chromium is not installed";
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  report::write_report(scratch.file("run"), "");
  expect_sound(scratch, scratch.file("run/report.html"), "16");
}

TEST(Browser, ShowsEveryFigureOfAComparisonAndFetchesNothing) {
  if (!std::filesystem::exists(chromium)) GTEST_SKIP() << "chromium is not installed";
  const ScratchFolder scratch;
  write_sample_run(scratch.file("a"));
  write_sample_run(scratch.file("b"), {.seed = 2, .porosity = 0.5});
  report::write_comparison({scratch.file("a"), scratch.file("b")}, scratch.file("out"));
  expect_sound(scratch, scratch.file("out/comparison.html"), "18");
}

TEST(Browser, NoticesWhatIsBrokenFetchedOrComplainedOf) {
  if (!std::filesystem::exists(chromium)) GTEST_SKIP() << "chromium is not installed";
  const ScratchFolder scratch;
  put(scratch.file("broken.html"),
      with_counter(
          "<!DOCTYPE html><meta http-equiv=\"Content-Security-Policy\" content=\"\"><body>"
          "<img src=\"data:image/png;base64,AAAA\"><img src=\"http://127.0.0.1:9/picture.png\"></body>"));
  const tests::Outcome seen = open(scratch, scratch.file("broken.html"));
  EXPECT_NE(seen.out.find("2 images, 2 broken"), std::string::npos);
  EXPECT_TRUE(fetched(scratch));
  put(scratch.file("loud.html"), "<!DOCTYPE html><body><script>console.error('oh')</script></body>");
  EXPECT_TRUE(complained(open(scratch, scratch.file("loud.html"))));
  EXPECT_FALSE(fetched(scratch));
}

}  // namespace
