// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pulvis {

/// An image within a page. An empty source: it could not be made, and the caption says why.
struct PageImage {
  std::string source;         ///< an address that holds the whole image ("data:image/png;base64,...")
  int width = 0, height = 0;  ///< pixels; 0: unknown
  std::string alternative;    ///< words that stand for it where it cannot be seen
  std::string caption{};
};

/// An SVG image for a page.
PageImage svg_image(std::string_view svg, std::string alternative, std::string caption = "");

/// A PNG image for a page; nothing if the bytes are not a whole PNG file.
std::optional<PageImage> png_image(std::string_view bytes, std::string alternative, std::string caption = "");

/// A page in one file that opens from disk: no scripts, no network (it forbids both to the browser), images
/// within. Text is escaped.
class HtmlPage {
 public:
  explicit HtmlPage(std::string title);

  void heading(std::string_view text, int level = 2);
  /// A list of the headings of level 2 that follow, with links.
  void contents();
  void paragraph(std::string_view text);
  /// A paragraph that stands out: a warning.
  void notice(std::string_view text);
  void list(const std::vector<std::string>& items);
  struct Row {
    std::vector<std::string> cells;
    std::string kind{};  ///< "", "good", "bad" or "plain": its colour and weight
  };
  /// A table; columns of numbers stand right. A header of empty cells is left out.
  void table(const std::vector<std::string>& header, const std::vector<Row>& rows);
  /// An SVG image with the words that stand for it where it cannot be seen.
  void image(std::string_view svg, std::string_view alternative);
  /// Images side by side where there is room, each with its caption.
  void images(const std::vector<PageImage>& images);

  std::string text() const;

 private:
  std::string title_, body_;
  std::vector<std::pair<std::string, std::string>> sections_;  ///< anchor and heading
  std::optional<std::size_t> contents_;                        ///< where in the body
};

}  // namespace pulvis
