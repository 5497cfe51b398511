// SPDX-License-Identifier: Apache-2.0
// docs/laws.md, the reference page of laws, is made from the catalogue and from what stands before each part in
// its file, so that nothing is written twice.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/laws/catalogue.hpp"

using namespace pulvis;

namespace {

const std::string root_folder = PULVIS_SOURCE_DIR;

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// The text of comment lines that start with `mark`, as a block that keeps its columns.
std::string block_of(const std::vector<std::string>& lines, std::size_t from, std::size_t to,
                     const std::string& mark) {
  std::string text = "```text\n";
  for (std::size_t k = from; k < to; ++k)
    text += lines[k].size() > mark.size() ? lines[k].substr(mark.size() + 1) + "\n" : "\n";
  return text + "```\n";
}

/// The comment above the struct with this name in a folder of laws; empty if there is none.
std::string description(const std::string& kind, std::string_view name) {
  const std::string declaration = fmt::format("static constexpr const char* name = \"{}\";", name);
  for (const auto& entry : std::filesystem::directory_iterator(root_folder + "/engine/laws/" + kind)) {
    const auto lines = lines_of(entry.path());
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (lines[k].find(declaration) == std::string::npos) continue;
      std::size_t end = k;
      while (!lines[end].starts_with("struct ")) --end;
      std::size_t begin = end;
      while (lines[begin - 1].starts_with("///")) --begin;
      return block_of(lines, begin, end, "///");
    }
  }
  return {};
}

/// The comment at the head of a file, before its namespace.
std::string head_of(const std::string& file) {
  const auto lines = lines_of(root_folder + "/engine/laws/" + file);
  std::size_t end = 0;
  while (!lines[end].starts_with("namespace")) ++end;
  std::size_t begin = end;
  while (lines[begin - 1].starts_with("//")) --begin;
  return block_of(lines, begin, end, "//");
}

std::string parameters_of(const laws::PartEntry& part) {
  std::string text;
  for (const laws::Parameter& p : part.parameters)
    text += fmt::format("| `{}` | {:g} to {:g} | {} |\n", p.name, p.lowest, p.highest, p.unit);
  return text.empty() ? text : "| needs | range | unit |\n|---|---|---|\n" + text + "\n";
}

template <class Entry>
std::string chapter(const std::string& title, const std::string& kind, const std::vector<Entry>& parts,
                    const std::string& intro = {}) {
  std::string text = fmt::format("## {}\n\n{}", title, intro);
  for (const Entry& part : parts) {
    const std::string found = description(kind, part.name);
    EXPECT_FALSE(found.empty()) << kind << " " << part.name;
    text += fmt::format("### {}\n\n{}\n{}", part.name, found, parameters_of(part));
  }
  return text;
}

std::string laws_page() {
  const laws::Catalogue& all = laws::catalogue();
  return "# Contact laws\n\nMade from the files in `engine/laws`; do not edit. A law is one part of each "
         "kind; "
         "`contact.*` of a case names them (docs/case-keys.md).\n\n" +
         head_of("contact_law.hpp") + "\n" + chapter("Normal laws", "normal", all.normal) +
         chapter("Cohesion", "cohesion", all.cohesion,
                 "What all laws of capillary bridges share:\n\n" + head_of("cohesion/bridge.hpp") + "\n") +
         chapter("Damping", "damping", all.damping) + chapter("Sliding", "sliding", all.sliding) +
         chapter("Rolling", "rolling", all.rolling) + chapter("Twisting", "twisting", all.twisting) +
         "SPDX-License-Identifier: Apache-2.0\n";
}

TEST(Documents, PageOfLawsIsThatOfTheirFiles) {
  // With PULVIS_WRITE_DOCUMENTS set, the page is written instead of compared.
  const std::string path = root_folder + "/docs/laws.md", page = laws_page();
  if (std::getenv("PULVIS_WRITE_DOCUMENTS") != nullptr) std::ofstream(path) << page;
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(text.str() == page) << "docs/laws.md is older than the laws; renew it with\n"
                                     "PULVIS_WRITE_DOCUMENTS=1 law_tests --gtest_filter='Documents.*'";
}

}  // namespace
