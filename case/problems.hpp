// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/value.hpp"
#include "engine/base/failure.hpp"

namespace pulvis {

/// One thing that is wrong with a case, and where.
struct Problem {
  std::string file;         ///< as given; "--set key" for an override
  int line = 0;             ///< from 1; 0 in an override, which has no lines
  int column = 0;           ///< from 1, in characters
  int length = 0;           ///< characters to underline, at least 1
  std::string message;      ///< what is wrong, one line
  std::string expected;     ///< what would be right, the nearest known name; may be empty
  std::string source_line;  ///< the line as written
};

/// The problem as a compiler would print it: place, message, excerpt with carets and what was expected.
std::string format_problem(const Problem& problem);

/// A case that is wrong: all its problems in one go. `what()` is all of them formatted.
class CaseError : public Failure {
 public:
  explicit CaseError(std::vector<Problem> all)
      : Failure(Exit::bad_case, text_of(all)), problems(std::move(all)) {}
  std::vector<Problem> problems;

 private:
  static std::string text_of(const std::vector<Problem>& all);
};

/// Places in short, each line once: "die.toml:14, 17 and base.toml:3" of "die.toml:14", "die.toml:17"...
std::string short_list(const std::vector<std::string>& places);

namespace case_file {

/// Collects problems while a case is read; knows the text of every source to quote from.
class ProblemList {
 public:
  /// The case file: source 0.
  ProblemList(std::string name, std::string_view text);

  /// A file that the case extends; returns its source number for `Place`.
  int add_file(std::string name, std::string_view text);

  /// An override, shown as "key=value"; returns its source number for `Place`.
  int add_override(const std::string& key, const std::string& assignment);

  void add(const Place& place, std::string message, std::string expected = "");
  bool empty() const { return problems_.empty(); }

  /// So many problems that the user reads no more of them; checks may then save their work.
  bool full() const { return problems_.size() >= most; }

  /// Throws CaseError with the problems in the order of the file, if there are any.
  void throw_if_any() const;

  /// "; see die.toml:14, 17" for the places of what else a problem follows from; empty if there are none.
  std::string see(std::span<const Place> places) const;

  /// "die.toml:14", "--set key".
  std::string describe(const Place& place) const;

  /// What the comment at the end of the line says, without its sign; empty without one.
  std::string comment_at(const Place& place) const;

 private:
  static constexpr std::size_t most = 100;  // a screen or two
  struct Source {
    std::string name;
    std::vector<std::string> lines;
    bool is_override = false;
  };
  std::vector<Source> sources_;
  std::vector<std::pair<Place, Problem>> problems_;
};

}  // namespace case_file
}  // namespace pulvis
