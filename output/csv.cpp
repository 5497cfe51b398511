// SPDX-License-Identifier: Apache-2.0
#include "output/csv.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "engine/base/failure.hpp"
#include "output/safe_file.hpp"

namespace pulvis {
namespace {

template <class Number>
void append_number(std::string& line, Number value) {
  std::array<char, 32> digits;  // the longest double takes 24
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  line.append(digits.data(), end);
}

// RFC 4180: text with a separator, a quote or a line end is quoted, quotes are doubled.
void append_text(std::string& line, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    line += text;
    return;
  }
  line += '"';
  for (const char letter : text) {
    if (letter == '"') line += '"';
    line += letter;
  }
  line += '"';
}

void append_cell(std::string& line, const CsvCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) {
    append_number(line, *number);
  } else if (const auto* count = std::get_if<std::int64_t>(&cell)) {
    append_number(line, *count);
  } else {
    append_text(line, std::get<std::string_view>(cell));
  }
}

void append_line(std::string& text, std::span<const CsvCell> cells, std::size_t columns) {
  if (cells.size() != columns) throw std::invalid_argument("a line of a table has a wrong number of cells");
  for (const CsvCell& cell : cells) {
    if (&cell != cells.data()) text += ',';
    append_cell(text, cell);
  }
  text += '\n';
}

}  // namespace

CsvLog::CsvLog(std::string path, std::vector<std::string> columns, FileCalls calls)
    : path_(std::move(path)), columns_(columns.size()), calls_(calls), file_(-1) {
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) fail_to_write(path_, errno);
  try {
    std::vector<CsvCell> header(columns.begin(), columns.end());
    add(header);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

CsvLog::CsvLog(AtEnd, std::string path, std::size_t columns, FileCalls calls)
    : path_(std::move(path)), columns_(columns), calls_(calls), file_(-1) {
  file_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC);
  if (file_ < 0 && errno == ENOENT)
    throw Failure(Exit::bad_input, fmt::format("{} is gone; the run cannot go on with it", path_));
  if (file_ < 0) fail_to_write(path_, errno);
}

CsvLog CsvLog::continued(std::string path, std::vector<std::string> columns, std::uint64_t length,
                         FileCalls calls) {
  CsvLog log(AtEnd{}, std::move(path), columns.size(), calls);
  const auto end = static_cast<off_t>(length);
  char last = '\n';
  if (::lseek(log.file_, 0, SEEK_END) < end || end < 1 || ::pread(log.file_, &last, 1, end - 1) != 1 ||
      last != '\n')
    throw Failure(Exit::bad_input, fmt::format("{} is not the file that was written: no line of it ends "
                                               "after {} bytes; the run cannot go on with it",
                                               log.path_, length));
  if (::ftruncate(log.file_, end) != 0) fail_to_write(log.path_, errno);
  ::lseek(log.file_, end, SEEK_SET);
  return log;
}

CsvLog::CsvLog(CsvLog&& other) noexcept
    : path_(std::move(other.path_)),
      columns_(other.columns_),
      calls_(other.calls_),
      file_(std::exchange(other.file_, -1)) {}

CsvLog::~CsvLog() {
  if (file_ >= 0) ::close(file_);
}

std::uint64_t CsvLog::sync() {
  if (calls_.sync(file_) != 0) fail_to_write(path_, errno);
  const off_t length = ::lseek(file_, 0, SEEK_CUR);
  return length > 0 ? static_cast<std::uint64_t>(length) : 0;
}

void CsvLog::add(std::span<const CsvCell> cells) {
  line_.clear();
  append_line(line_, cells, columns_);
  write_line();
}

void CsvLog::write_line() {
  const off_t start = ::lseek(file_, 0, SEEK_CUR);
  const int error = write_fully(calls_, file_, line_.data(), line_.size());
  if (error == 0) return;
  // Half a line would be read as wrong numbers. A device that cannot be cut back holds no lines anyway.
  if (start >= 0 && ::ftruncate(file_, start) == 0) ::lseek(file_, start, SEEK_SET);
  fail_to_write(path_, error);
}

CsvTable::CsvTable(const std::vector<std::string>& columns) : columns_(columns.size()) {
  add(std::vector<CsvCell>(columns.begin(), columns.end()));
}

void CsvTable::add(std::span<const CsvCell> cells) { append_line(text_, cells, columns_); }

void CsvTable::save(const std::string& path, FileCalls calls) const { write_file_safely(path, text_, calls); }

}  // namespace pulvis
