// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pulvis {

/// A page in one file that opens from disk: no scripts, no network, images within. Text is escaped.
class HtmlPage {
 public:
  explicit HtmlPage(std::string title);

  void heading(std::string_view text, int level = 2);
  void paragraph(std::string_view text);
  struct Row {
    std::vector<std::string> cells;
    std::string kind{};  ///< "", "good", "bad" or "plain": its colour and weight
  };
  /// A table; cells that are numbers stand right.
  void table(const std::vector<std::string>& header, const std::vector<Row>& rows);
  /// An SVG image with the words that stand for it where it cannot be seen.
  void image(std::string_view svg, std::string_view alternative);

  std::string text() const;

 private:
  std::string title_, body_;
};

}  // namespace pulvis
