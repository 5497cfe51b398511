// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <set>
#include <string>
#include <vector>

namespace pulvis::tests {

/// One slip of the pen in a case file, and where a message about it may point.
struct Edit {
  std::string text;      ///< the whole file with the edit in it
  std::string what;      ///< "line 12: quote removed", for a report
  std::set<int> places;  ///< lines of `text`, from 1, one of which a message must name
};

/// A slip drawn by number: a character deleted, inserted, replaced or swapped with the next; a line deleted or
/// doubled; a value taken from another key; a unit or a number changed; a key misspelt; a quote or bracket removed.
///
/// A message must name the line that holds the edit (either, where it made two lines of one). Only of a line that is
/// gone, or has become a comment, that cannot be asked: it must name a line of the table it stood in, or one that
/// speaks of its key. Of a header that is gone: a line of what stood under it, or of the table before, or one that
/// speaks of its name, or line 1, which stands for the file as a whole.
Edit edit_of(const std::string& text, std::uint64_t number);

/// Text as lines without their ends.
std::vector<std::string> lines_in(const std::string& text);

}  // namespace pulvis::tests
