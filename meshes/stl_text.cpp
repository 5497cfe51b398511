// SPDX-License-Identifier: Apache-2.0
#include "meshes/stl_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t longest_word = 512;  // the largest double written without exponent has 309 digits

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The words of a text and the line each stands on, read a block at a time: a file needs no memory of its
// size, and not even a file without blanks makes a long word.
class WordReader {
 public:
  explicit WordReader(std::istream& input) : input_(input), block_(1 << 16) {
    if (std::string_view(block_.data(), fill()).starts_with(byte_order_mark)) next_ = byte_order_mark.size();
  }

  /// False at the end of the text.
  bool next() {
    word_.clear();
    while (more() && is_blank(block_[next_])) pass();
    while (more() && !is_blank(block_[next_])) {
      if (word_.size() < longest_word) word_.push_back(block_[next_]);
      pass();
    }
    return !word_.empty();
  }
  void skip_line() {
    while (more() && block_[next_] != '\n' && block_[next_] != '\r') pass();
  }

  const std::string& word() const { return word_; }
  /// Of the end of the word just read.
  std::uint64_t line() const { return line_; }
  bool broke_off() const { return input_.bad(); }

 private:
  std::size_t fill() {
    input_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
    next_ = 0;
    return end_ = static_cast<std::size_t>(input_.gcount());
  }
  bool more() { return next_ < end_ || fill() > 0; }
  // Lines end with LF, CR LF, or CR alone.
  void pass() {
    const char c = block_[next_++];
    if (c == '\r' || (c == '\n' && previous_ != '\r')) ++line_;
    previous_ = c;
  }

  std::istream& input_;
  std::vector<char> block_;
  std::size_t next_ = 0, end_ = 0;
  std::string word_;
  std::uint64_t line_ = 1;
  char previous_ = '\0';
};

// Keywords are written in either case. The locale has no say in it.
bool same_word(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

// Nothing if `word` is no number. What is beyond doubles is infinite or zero.
std::optional<double> number_in(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

class TextParser {
 public:
  TextParser(std::istream& input, const std::string& path, std::uint64_t most_triangles)
      : words_(input), path_(path), most_triangles_(most_triangles) {
    soup_.source = path;
  }

  TriangleSoup soup() {
    while (words_.next()) {
      if (!is("solid"))
        fail(
            fmt::format("\"{}\" where the file should end or another \"solid\" begin", shown(words_.word())));
      solid();
    }
    if (words_.broke_off()) fail("the file cannot be read further; check the disk");
    if (soup_.triangles.empty()) fail("there is no facet in the file; export the surface again");
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Failure(Exit::bad_input, fmt::format("{}:{}: error: {}", path_, words_.line(), message));
  }

  bool is(const char* keyword) const { return same_word(words_.word(), keyword); }

  void need_word(const char* what) {
    if (words_.next()) return;
    if (words_.broke_off()) fail("the file cannot be read further; check the disk");
    fail(fmt::format(
        "the file ends after {} facets where {} should follow\n  it was cut off; copy or export it "
        "again",
        soup_.triangles.size(), what));
  }

  void need(const char* keyword) {
    need_word(fmt::format("\"{}\"", keyword).c_str());
    if (is(keyword)) return;
    const bool fourth = same_word(keyword, "endloop") && is("vertex");
    fail(fmt::format("\"{}\" where \"{}\" should stand in facet {}\n  {}", shown(words_.word()), keyword,
                     facet_number(),
                     fourth ? "a facet of an STL file has three corners; export triangles"
                            : "the file is damaged; export it again"));
  }

  std::size_t facet_number() const { return soup_.triangles.size() + 1; }

  void solid() {
    words_.skip_line();  // its name
    for (;;) {
      need_word("\"facet\" or \"endsolid\"");
      if (is("endsolid")) break;
      if (!is("facet"))
        fail(fmt::format(
            "\"{}\" where \"facet\" or \"endsolid\" should stand\n  the file is damaged; export it "
            "again",
            shown(words_.word())));
      facet();
    }
    words_.skip_line();
  }

  void facet() {
    need("normal");
    for (int axis = 0; axis < 3; ++axis) need_word("a number of the normal");
    need("outer");
    need("loop");
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      need("vertex");
      for (int axis = 0; axis < 3; ++axis) corner[axis] = coordinate();
    }
    need("endloop");
    need("endfacet");
    if (soup_.triangles.size() >= most_triangles_)
      fail(fmt::format("more than {} triangles; export a coarser surface", most_triangles_));
    soup_.triangles.push_back(corners);
  }

  // The range is that of 32-bit numbers, which binary files have: its squares and cubes are far from
  // overflow.
  double coordinate() {
    need_word("a coordinate");
    const auto value = number_in(words_.word());
    if (!value || !(std::fabs(*value) <= std::numeric_limits<float>::max()))
      fail(fmt::format("\"{}\" is not a finite number, in facet {}\n  export the surface again",
                       shown(words_.word()), facet_number()));
    return *value;
  }

  WordReader words_;
  const std::string& path_;
  std::uint64_t most_triangles_;
  TriangleSoup soup_;
};

}  // namespace

TriangleSoup read_stl_text(std::istream& input, const std::string& path, std::uint64_t most_triangles) {
  return TextParser(input, path, most_triangles).soup();
}

bool begins_with_solid(std::string_view first_bytes) {
  if (first_bytes.starts_with(byte_order_mark)) first_bytes.remove_prefix(byte_order_mark.size());
  while (!first_bytes.empty() && is_blank(first_bytes.front())) first_bytes.remove_prefix(1);
  const std::string_view word = first_bytes.substr(0, 5);
  return same_word(word, "solid") && (first_bytes.size() == 5 || is_blank(first_bytes[5]));
}

std::string shown(std::string_view bytes) {
  std::string text;
  for (const char c : bytes.substr(0, 40)) {
    if (c >= ' ' && c <= '~')
      text += c;
    else
      text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return bytes.size() > 40 ? text + "..." : text;
}

}  // namespace pulvis
