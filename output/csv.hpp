// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "output/file_calls.hpp"

namespace pulvis {

/// One entry of a log line. A double is written with the fewest digits that read back as the same bits.
using CsvCell = std::variant<double, std::int64_t, std::string_view>;

/// A table of comma-separated values that grows line by line (log.csv). Each line reaches the file as one
/// write, so that a reader beside the run, or after a crash, sees whole lines only.
class CsvLog {
 public:
  /// Starts the file with its header; column names carry their unit: "time_s", "kinetic_energy_J".
  /// Throws Failure(Exit::io) if the file cannot be written.
  CsvLog(std::string path, std::vector<std::string> columns, FileCalls calls = FileCalls::system());
  /// Goes on with a log as it was when it had `length` bytes: what was added since is cut off.
  /// Throws Failure(Exit::bad_input) if it has not as many, or no line ends there.
  static CsvLog continued(std::string path, std::vector<std::string> columns, std::uint64_t length,
                          FileCalls calls = FileCalls::system());
  ~CsvLog();
  CsvLog(CsvLog&& other) noexcept;
  CsvLog& operator=(CsvLog&&) = delete;

  /// Adds one line. Throws Failure(Exit::io) if it cannot be written, after taking back what part of it was;
  /// std::invalid_argument if `cells` are not as many as the columns.
  void add(std::span<const CsvCell> cells);
  void add(std::initializer_list<CsvCell> cells) { add(std::span(cells.begin(), cells.size())); }

  /// Brings all lines to the disk and returns the length of the file in bytes. Throws Failure(Exit::io).
  std::uint64_t sync();

 private:
  struct AtEnd {};
  CsvLog(AtEnd, std::string path, std::size_t columns, FileCalls calls);
  void write_line();

  std::string path_;
  std::size_t columns_;
  FileCalls calls_;
  int file_;
  std::string line_;
};

/// A table that appears with all its lines or not at all: see SafeFile.
class CsvTable {
 public:
  explicit CsvTable(const std::vector<std::string>& columns);

  /// Adds one line. Throws std::invalid_argument if `cells` are not as many as the columns.
  void add(std::span<const CsvCell> cells);
  void add(std::initializer_list<CsvCell> cells) { add(std::span(cells.begin(), cells.size())); }

  /// Throws Failure(Exit::io).
  void save(const std::string& path, FileCalls calls = FileCalls::system()) const;

 private:
  std::size_t columns_;
  std::string text_;
};

}  // namespace pulvis
