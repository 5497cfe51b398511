// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "case/toml_source.hpp"
#include "tests/case/sample_case.hpp"

namespace pulvis {
namespace {

using namespace tests;

std::string repeated(const std::string& part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

// Either a case or a CaseError whose problems lie in the file.
void expect_an_answer(const std::string& text, const std::string& what) {
  const int lines = 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  try {
    read_case_text(text, "die.toml");
  } catch (const CaseError& error) {
    ASSERT_FALSE(error.problems.empty()) << what;
    for (const Problem& problem : error.problems) {
      ASSERT_GE(problem.line, 1) << what << "\n" << error.what();
      ASSERT_LE(problem.line, lines) << what << "\n" << error.what();
      ASSERT_GE(problem.column, 1) << what << "\n" << error.what();
      ASSERT_GE(problem.length, 1) << what << "\n" << error.what();
      ASSERT_FALSE(problem.message.empty()) << what;
    }
  } catch (const std::exception& error) {
    FAIL() << what << ": " << error.what() << "\n" << text;
  }
}

TEST(HostileInput, SurvivesTwoThousandRandomEdits) {
  std::mt19937 random(20240607);  // fixed, so that a failure can be repeated
  const std::string alphabet = "[]{}\"'=.,#\\\n\t 0123456789eaxz_-+:%\x01\x7f\xff\xc2\xb5";
  const std::string sample = full_case;
  for (int i = 0; i < 2000; ++i) {
    std::string text = sample;
    const std::size_t at = random() % text.size();
    switch (random() % 4) {
      case 0:
        text.erase(at, 1 + random() % 12);
        break;
      case 1:
        text[at] = alphabet[random() % alphabet.size()];
        break;
      case 2:
        text.insert(at, 1, alphabet[random() % alphabet.size()]);
        break;
      default:
        text.insert(random() % text.size(), sample.substr(at, random() % 40));
        break;
    }
    expect_an_answer(text, "edit " + std::to_string(i));
    if (HasFatalFailure()) return;
  }
}

TEST(HostileInput, SurvivesEveryTruncation) {
  const std::string sample = full_case;
  for (std::size_t length = 0; length < sample.size(); length += 7)
    expect_an_answer(sample.substr(0, length), "truncation");
}

TEST(HostileInput, RefusesDepthAndLengthBeforeTheyCost) {
  const auto started = std::chrono::steady_clock::now();
  const auto refused = [](const std::string& text, const std::string& why) {
    const std::string all = messages_of(text);
    EXPECT_NE(all.find(why), std::string::npos) << all.substr(0, 500);
    EXPECT_LT(all.size(), 50000u);
  };
  refused("a = " + repeated("[", 60000), "brackets nested too deep");
  refused("a = " + repeated("[\n", 200000), "brackets nested too deep");
  refused("a = " + repeated("{a = ", 10000), "brackets nested too deep");
  refused(repeated("[[[", 1), "syntax error");
  refused(repeated("a.", 30000) + "a = 1", "a key of too many parts");
  refused(repeated("\"a\".", 10000) + "a = 1", "a key of too many parts");
  refused("[" + repeated("a . ", 10000) + "a]", "a key of too many parts");
  refused("a = \"" + repeated("x", 70000) + "\"", "a line of");
  refused(repeated("#\n", 3 << 20), "the file has");
  refused(repeated("a = 1\n", 100000), "syntax error");
  EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(20));
}

TEST(HostileInput, AnswersLargeFilesInTime) {
  const auto started = std::chrono::steady_clock::now();
  std::string tables, keys = "[time]\n";
  for (int i = 0; i < 60000; ++i) {
    tables += "[materials.m" + std::to_string(i) + "]\n";
    keys += "k" + std::to_string(i) + " = 1\n";
  }
  for (const std::string& text : {repeated("[[phases]]\n", 100000), tables, keys}) {
    const auto problems = problems_of(text);
    EXPECT_GE(problems.size(), 10u);
    EXPECT_LE(problems.size(), 200u);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(30));
}

TEST(HostileInput, RefusesBytesThatAreNoText) {
  const auto at = [](const std::string& text) {
    const auto problems = problems_of(text);
    return problems.empty() ? "none"
                            : std::to_string(problems[0].line) + ":" + std::to_string(problems[0].column) +
                                  " " + problems[0].message;
  };
  EXPECT_EQ(at(std::string("a = 1\nb\0 = 2", 12)), "2:2 a control character (code 0)");
  EXPECT_EQ(at("a = \"\xff\""), "1:6 a byte that is not UTF-8");
  EXPECT_EQ(at("# \xc0\xaf"), "1:3 a byte that is not UTF-8");      // overlong
  EXPECT_EQ(at("# \xed\xa0\x80"), "1:3 a byte that is not UTF-8");  // surrogate
  EXPECT_EQ(at("\xc3\xa4 = 1"), "1:1 \"\xc3\xa4\" outside a string or comment");
  EXPECT_EQ(at("# \xc3\xa4\na = \x1b"), "2:5 a control character (code 27)");
  EXPECT_EQ(at("a = \"\xc3\xa4"), "1:5 this string is not closed");
}

TEST(HostileInput, ReadsUnusualTomlThatIsRight) {
  const std::string text = with(minimal_case, "density = \"10.2 g/cm^3\"", "density = '''\n10.2 g/cm^3'''");
  EXPECT_EQ(read_case_text(text, "die.toml").materials[0].density, 10200.0);
  const std::string quotes =
      with(minimal_case, "[domain]", "title = \"\"\"a \"\"quoted\"\" \\\"word\\\" \"\"\"\"\"\n[domain]");
  EXPECT_EQ(read_case_text(quotes, "die.toml").title, "a \"\"quoted\"\" \"word\" \"\"");
  const std::string dotted = with(minimal_case, "size = { kind = \"single\", diameter = \"4.6 um\" }",
                                  "size.kind = \"single\"\n\"size\".diameter = \"4.6 um\"");
  EXPECT_EQ(read_case_text(dotted, "die.toml").powders[0].size.diameter, 4.6e-6);
}

}  // namespace
}  // namespace pulvis
