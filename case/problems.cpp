// SPDX-License-Identifier: Apache-2.0
#include "case/problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>

namespace pulvis {
namespace {

// A part of a line that fits a terminal, and where the underlined part starts in it.
struct Excerpt {
  std::string text;
  std::string padding;
  std::size_t width = 0;  // characters from the start of the underlined part to the end of the text
};

std::vector<std::string_view> characters(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at + 1;
    while (end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) ++end;
    result.push_back(line.substr(at, end - at));
    at = end;
  }
  return result;
}

Excerpt excerpt(const Problem& problem) {
  constexpr std::size_t whole = 120;              // characters of a line that is shown as it is
  constexpr std::size_t before = 40, after = 80;  // of a longer one, beside the start of the underlined part
  const std::vector<std::string_view> line = characters(problem.source_line);
  const std::size_t start = std::min(line.size(), static_cast<std::size_t>(std::max(1, problem.column) - 1));
  const bool is_long = line.size() > whole;
  const std::size_t first = is_long && start > before + 3 ? start - before : 0;
  const std::size_t last = is_long && line.size() > start + after + 3 ? start + after : line.size();

  Excerpt result;
  if (first > 0) result.text = result.padding = "...";
  for (std::size_t i = first; i < last; ++i) {
    // Control characters would disturb the terminal; tabs stay, so that the carets still line up.
    const bool control = line[i].size() == 1 && line[i][0] != '\t' &&
                         (static_cast<unsigned char>(line[i][0]) < 0x20 || line[i][0] == 0x7F);
    result.text += control ? "?" : line[i];
    if (i < start) result.padding += line[i] == "\t" ? "\t" : " ";
  }
  if (first > 0) std::replace(result.padding.begin(), result.padding.end(), '.', ' ');
  if (last < line.size()) result.text += "...";
  result.width = last - start;
  return result;
}

}  // namespace

std::string format_problem(const Problem& problem) {
  const std::string place =
      problem.line > 0 ? fmt::format("{}:{}:{}", problem.file, problem.line, problem.column) : problem.file;
  std::string text = fmt::format("{}: error: {}\n", place, problem.message);
  const Excerpt shown = excerpt(problem);
  const std::string number = problem.line > 0 ? fmt::format("{:>4} | ", problem.line) : "     | ";
  const std::size_t carets = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, problem.length)), 1,
                                                     std::max<std::size_t>(1, shown.width));
  text += fmt::format("{}{}\n", number, shown.text);
  text += fmt::format("     | {}{}", shown.padding, std::string(carets, '^'));
  if (!problem.expected.empty()) text += " " + problem.expected;
  return text + "\n";
}

std::string CaseError::text_of(const std::vector<Problem>& all) {
  std::string text;
  for (const Problem& problem : all) text += format_problem(problem);
  if (!text.empty()) text.pop_back();  // the last line break is the printer's
  return text;
}

std::string short_list(const std::vector<std::string>& places) {
  std::vector<std::pair<std::string, std::set<int>>> files;
  for (const std::string& place : places) {
    const std::size_t colon = place.rfind(':');
    const int line = colon == std::string::npos ? 0 : std::atoi(place.c_str() + colon + 1);
    const std::string file = line > 0 ? place.substr(0, colon) : place;
    auto known = std::find_if(files.begin(), files.end(), [&](const auto& f) { return f.first == file; });
    if (known == files.end()) known = files.insert(files.end(), {file, {}});
    if (line > 0) known->second.insert(line);
  }
  std::string text;
  for (const auto& [file, lines] : files)
    text += fmt::format("{}{}{}{}", text.empty() ? "" : " and ", file, lines.empty() ? "" : ":",
                        fmt::join(lines, ", "));
  return text;
}

namespace case_file {

ProblemList::ProblemList(std::string name, std::string_view text) { add_file(std::move(name), text); }

int ProblemList::add_file(std::string name, std::string_view text) {
  Source file{std::move(name), {}, false};
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark is no character of line 1
  while (true) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    file.lines.emplace_back(line);
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  // The end of the last line belongs to it: a file of three lines has no fourth.
  if (file.lines.size() > 1 && file.lines.back().empty()) file.lines.pop_back();
  sources_.push_back(std::move(file));
  return static_cast<int>(sources_.size()) - 1;
}

int ProblemList::add_override(const std::string& key, const std::string& assignment) {
  std::string line = assignment;
  std::replace(line.begin(), line.end(), '\n', ' ');
  sources_.push_back({"--set " + key, {line}, true});
  return static_cast<int>(sources_.size()) - 1;
}

void ProblemList::add(const Place& place, std::string message, std::string expected) {
  if (full()) return;
  const Source& source = sources_[static_cast<std::size_t>(place.source)];
  Problem problem;
  problem.file = source.name;
  const int line = std::clamp(place.line, 1, static_cast<int>(source.lines.size()));
  problem.line = source.is_override ? 0 : line;
  problem.column = std::max(1, place.column);
  problem.length = std::max(1, place.length);
  problem.message = std::move(message);
  problem.expected = std::move(expected);
  problem.source_line = source.lines[static_cast<std::size_t>(line) - 1];
  problems_.emplace_back(place, std::move(problem));
}

void ProblemList::throw_if_any() const {
  if (problems_.empty()) return;
  auto sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.source, a.first.line, a.first.column) <
           std::tie(b.first.source, b.first.line, b.first.column);
  });
  std::vector<Problem> all;
  for (auto& [place, problem] : sorted) all.push_back(std::move(problem));
  throw CaseError(std::move(all));
}

std::string ProblemList::see(std::span<const Place> places) const {
  std::vector<std::string> all;
  for (const Place& place : places) all.push_back(describe(place));
  return all.empty() ? "" : "; see " + short_list(all);
}

std::string ProblemList::describe(const Place& place) const {
  const Source& source = sources_[static_cast<std::size_t>(place.source)];
  return source.is_override ? source.name : fmt::format("{}:{}", source.name, place.line);
}

std::string ProblemList::comment_at(const Place& place) const {
  const Source& source = sources_[static_cast<std::size_t>(place.source)];
  const auto number = static_cast<std::size_t>(std::max(place.line, 1)) - 1;
  if (source.is_override || number >= source.lines.size()) return {};
  const std::string& line = source.lines[number];
  char quote = 0;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char letter = line[at];
    if (quote == 0 && letter == '#') {
      const std::size_t first = line.find_first_not_of(" #\t", at), last = line.find_last_not_of(" \t\r");
      return first == std::string::npos ? "" : line.substr(first, last + 1 - first);
    }
    if (quote == 0 && (letter == '"' || letter == '\'')) {
      quote = letter;
    } else if (quote == '"' && letter == '\\') {
      ++at;  // what is escaped ends no text
    } else if (letter == quote) {
      quote = 0;
    }
  }
  return {};
}

}  // namespace case_file
}  // namespace pulvis
