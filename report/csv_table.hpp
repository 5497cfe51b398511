// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace pulvis::report {

/// A table of comma-separated values that a run wrote. Columns go by their names.
class CsvTable {
 public:
  /// A file; nothing if there is none. Throws Failure(Exit::bad_input) with file and line if a line has not as many
  /// cells as the header or a quote is not closed.
  static std::optional<CsvTable> read(const std::string& path);
  CsvTable(const std::string& text, std::string name);

  std::size_t rows() const { return rows_.size(); }
  const std::vector<std::string>& columns() const { return columns_; }
  bool has(const std::string& column) const { return place_of(column).has_value(); }
  /// Numbers of a column, NaN where a cell is empty; none at all if there is no such column. Throws
  /// Failure(Exit::bad_input) with file and line for a cell that is no number.
  std::vector<double> numbers(const std::string& column) const;
  std::vector<std::string> texts(const std::string& column) const;
  /// Throws Failure(Exit::bad_input) naming the file if one of them is missing.
  void require(const std::vector<std::string>& columns) const;

 private:
  std::optional<std::size_t> place_of(const std::string& column) const;
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;  ///< where each row begins
};

}  // namespace pulvis::report
