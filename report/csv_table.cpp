// SPDX-License-Identifier: Apache-2.0
#include "report/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "engine/base/failure.hpp"
#include "report/json_entry.hpp"

namespace pulvis::report {
namespace {

[[noreturn]] void fail(const std::string& name, std::size_t line, const std::string& what) {
  throw Failure(Exit::bad_input, fmt::format("{}:{}: {}; the file is damaged", name, line, what));
}

/// One line as RFC 4180 has it, from `at`, which it moves on; `line` counts.
std::vector<std::string> next_row(const std::string& text, std::size_t& at, std::size_t& line,
                                  const std::string& name) {
  std::vector<std::string> cells(1);
  const std::size_t begin = line;
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\n') ++line;
    if (quoted) {
      if (c != '"')
        cells.back() += c;
      else if (at + 1 < text.size() && text[at + 1] == '"')
        cells.back() += text[++at];
      else
        quoted = false;
    } else if (c == '"' && cells.back().empty()) {
      quoted = true;
    } else if (c == ',') {
      cells.emplace_back();
    } else if (c == '\n') {
      ++at;
      return cells;
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  if (quoted) fail(name, begin, "a quote is not closed");
  return cells;
}

}  // namespace

std::optional<CsvTable> CsvTable::read(const std::string& path) {
  const auto text = read_bytes(path);
  if (!text) return {};
  return CsvTable(*text, path);
}

CsvTable::CsvTable(const std::string& text, std::string name) : name_(std::move(name)) {
  std::size_t at = 0, line = 1;
  columns_ = next_row(text, at, line, name_);
  if (columns_.size() == 1 && columns_.front().empty()) fail(name_, 1, "there is no header");
  while (at < text.size()) {
    const std::size_t begin = line;
    std::vector<std::string> cells = next_row(text, at, line, name_);
    if (cells.size() == 1 && cells.front().empty()) continue;
    if (cells.size() != columns_.size())
      fail(name_, begin, fmt::format("{} cells where the header has {}", cells.size(), columns_.size()));
    rows_.push_back(std::move(cells));
    lines_.push_back(begin);
  }
}

std::optional<std::size_t> CsvTable::place_of(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return {};
  return static_cast<std::size_t>(found - columns_.begin());
}

std::vector<double> CsvTable::numbers(const std::string& column) const {
  const auto place = place_of(column);
  if (!place) return {};
  std::vector<double> list;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const std::string& cell = rows_[k][*place];
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto end = cell.data() + cell.size();
    if (!cell.empty()) {
      const auto [stop, error] = std::from_chars(cell.data(), end, value);
      if (error != std::errc{} || stop != end)
        fail(name_, lines_[k], fmt::format("\"{}\" in the column {} is not a number", cell, column));
    }
    list.push_back(value);
  }
  return list;
}

std::vector<std::string> CsvTable::texts(const std::string& column) const {
  const auto place = place_of(column);
  if (!place) return {};
  std::vector<std::string> list;
  for (const auto& row : rows_) list.push_back(row[*place]);
  return list;
}

void CsvTable::require(const std::vector<std::string>& columns) const {
  for (const std::string& column : columns)
    if (!has(column)) fail(name_, 1, fmt::format("there is no column {}", column));
}

}  // namespace pulvis::report
