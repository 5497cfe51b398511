// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/html_page.hpp"
#include "report/illustration.hpp"

namespace pulvis::report {

/// A page and the files of its figures beside it. Nothing is written before all of it is made.
class Document {
 public:
  /// `path` is that of the page; its figures lie in a folder of the same name without ".html".
  Document(std::string path, std::string title);

  HtmlPage& page() { return page_; }
  /// Shows a figure; if there is nothing to show, `otherwise` says what is missing. A figure that cannot be drawn is
  /// named, and its data are written all the same.
  void show(const std::optional<Illustration>& figure, const std::string& otherwise);
  /// What to tell the user besides: figures that could not be drawn.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Writes the figures, then the page, each file completely or not at all. Throws Failure(Exit::io).
  void write() const;

 private:
  std::string path_, folder_;
  HtmlPage page_;
  bool drawing_;
  std::vector<std::pair<std::string, std::string>> files_;  ///< name in the folder, content
  std::vector<std::string> warnings_;
};

/// All figures of a page: of the phases of `list` side by side, of those of `cut` in three cuts, of the runs over time.
void add_figures(Document& document, const Beside& cut, const Beside& list,
                 const std::vector<const RunData*>& runs);

}  // namespace pulvis::report
