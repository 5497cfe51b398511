// SPDX-License-Identifier: Apache-2.0
// Slips of the pen in the example cases: `pulvis check` passes them, or says in which line they are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>

#include "case/reader.hpp"
#include "run/preflight.hpp"
#include "tests/reliability/edits.hpp"

namespace pulvis::tests {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> example_cases() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(PULVIS_SOURCE_DIR "/cases"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Answer {
  Exit exit = Exit::ok;
  std::string message;
};

/// What `pulvis check` makes of a text in the place of that file.
Answer check(const std::string& text, const fs::path& file) {
  try {
    const Case c = read_case_text(text, file.string());
    const Assembly assembly = assemble(c);
    check_report(c, assembly, forecast(c, assembly));
    return {};
  } catch (const Failure& failure) {
    return {failure.code(), failure.what()};
  } catch (const std::exception& error) {
    return {Exit::unexpected, error.what()};
  }
}

/// The lines of a file that a message names.
std::set<int> lines_named(const std::string& message, const fs::path& file) {
  std::set<int> lines;
  for (std::size_t at = message.find(file.string()); at != std::string::npos;
       at = message.find(file.string(), at)) {
    at += file.string().size();
    while (message[at] == ':' || message.compare(at, 2, ", ") == 0) {  // "die.toml:14, 17"
      char* end = nullptr;
      const long line = std::strtol(message.c_str() + at + 1, &end, 10);
      if (end == message.c_str() + at + 1) break;
      lines.insert(static_cast<int>(line));
      at = static_cast<std::size_t>(end - message.c_str());
    }
  }
  static const std::regex word("lines? ([0-9]+)");
  for (auto m = std::sregex_iterator(message.begin(), message.end(), word); m != std::sregex_iterator(); ++m)
    lines.insert(std::stoi((*m)[1]));
  return lines;
}

/// What is wrong with an answer; empty if nothing is.
std::string fault_of(const Answer& answer, const Edit& edit, const fs::path& file) {
  if (answer.exit == Exit::ok) return "";
  const bool about_a_file = answer.exit == Exit::bad_input;
  if (answer.exit != Exit::bad_case && !about_a_file)
    return fmt::format("exit {}", static_cast<int>(answer.exit));
  const std::set<int> named = lines_named(answer.message, file);
  const auto fits = [&](int line) { return edit.places.contains(line); };
  if (std::any_of(named.begin(), named.end(), fits)) return "";
  return "names none of its lines";
}

/// 500 of them; tools/reliability asks for more by PULVIS_ROUNDS.
TEST(SlipsOfThePen, AreFoundInTheirLineOrChangeNothing) {
  const std::vector<fs::path> files = example_cases();
  ASSERT_GE(files.size(), 15u);
  const char* asked = std::getenv("PULVIS_ROUNDS");
  const char* from = std::getenv("PULVIS_FIRST_ROUND");
  const std::uint64_t rounds = asked ? std::strtoull(asked, nullptr, 10) : 500;
  const std::uint64_t first = from ? std::strtoull(from, nullptr, 10) : 0;
  ASSERT_GT(rounds, 0u);
  std::uint64_t clean = 0, named = 0, faults = 0;
  double longest = 0.0;
  for (std::uint64_t round = first; round < first + rounds; ++round) {
    const fs::path& file = files[round % files.size()];
    const std::string whole = text_of(file);
    const Edit edit = edit_of(whole, round);
    const auto began = std::chrono::steady_clock::now();
    const Answer answer = check(edit.text, file);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    longest = std::max(longest, seconds);
    const std::string fault = fault_of(answer, edit, file);
    if (fault.empty()) {
      ++(answer.exit == Exit::ok ? clean : named);
      continue;
    }
    ++faults;
    const auto lines = lines_in(edit.text);
    const auto line = static_cast<std::size_t>(std::stoi(edit.what.substr(5)));
    ADD_FAILURE() << "round " << round << ", " << file.filename() << ", " << edit.what << ": " << fault
                  << "\n"
                  << (line <= lines.size() ? lines[line - 1] : "") << "\n"
                  << answer.message;
  }
  std::cout << rounds << " edits: " << named << " named in their line, " << clean << " check clean, "
            << faults << " faults; longest " << longest << " s\n";
}

}  // namespace
}  // namespace pulvis::tests
