// SPDX-License-Identifier: Apache-2.0
#include "sweep/overview.hpp"

#include <fmt/format.h>

namespace pulvis::sweep {

std::string overview_text(const Counts& c, std::optional<double> seconds_left, const std::string& what) {
  const std::size_t all = c.complete + c.running + c.waiting + c.failed + c.stopped;
  std::string text = fmt::format("{} of {} {} complete", c.complete, all, what);
  if (c.running > 0) text += fmt::format(", {} running", c.running);
  if (c.failed > 0) text += fmt::format(", {} failed", c.failed);
  if (c.stopped > 0) text += fmt::format(", {} stopped", c.stopped);
  if (seconds_left) text += fmt::format(", about {} left", duration_text(*seconds_left));
  return text;
}

void Overview::update(const Counts& counts, std::optional<double> seconds_left) {
  const std::string text = overview_text(counts, seconds_left, what_),
                    counted = overview_text(counts, {}, what_);
  if (options_.style == ProgressStyle::bar) {
    if (text == shown_) return;
    const auto room = static_cast<std::size_t>(options_.width > 1 ? options_.width - 1 : 1);
    stream_ << '\r' << text.substr(0, room) << "\x1b[K" << std::flush;
    line_open_ = true;
  } else if (options_.style == ProgressStyle::lines) {
    if (counted == counted_) return;
    stream_ << text << '\n' << std::flush;
  }
  shown_ = text;
  counted_ = counted;
}

void Overview::message(const std::string& text) {
  if (options_.style == ProgressStyle::quiet) return;
  if (line_open_) stream_ << "\r\x1b[K";
  line_open_ = false;
  shown_.clear();
  stream_ << text << '\n' << std::flush;
}

void Overview::end_line() {
  if (line_open_) stream_ << '\n' << std::flush;
  line_open_ = false;
}

}  // namespace pulvis::sweep
