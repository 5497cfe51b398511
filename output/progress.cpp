// SPDX-License-Identifier: Apache-2.0
#include "output/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace pulvis {
namespace {

constexpr double redraw_interval = 0.2;  // s; faster cannot be read
constexpr double line_interval = 30.0;   // s
constexpr double sample_interval = 0.1;  // s; rates of shorter times are noise
constexpr double memory_time = 15.0;     // s; a rate older than this counts for 1/e
constexpr int longest_bar = 24;          // columns

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

// Multi-byte letters take one column each.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char letter) { return (letter & 0xC0) != 0x80; }));
}

std::string shortened(std::string text, std::size_t width) {
  while (columns(text) > width) text.pop_back();
  while (!text.empty() && (text.back() & 0x80)) text.pop_back();  // no half letter
  return text;
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ProgressOptions ProgressOptions::for_stderr() {
  ProgressOptions options;
  const char* terminal = std::getenv("TERM");
  const bool redraws = ::isatty(STDERR_FILENO) && terminal != nullptr && std::string_view(terminal) != "dumb";
  if (!redraws) return options;
  options.style = ProgressStyle::bar;
  options.colour = !is_set("NO_COLOR");
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) options.width = size.ws_col;
  return options;
}

void Progress::Rate::sample(double time, double value) {
  if (started_ && time > time_) {
    // Old samples fade with exp(-age/memory_time); dividing by the weight removes the bias of the start.
    const double keep = std::exp(-(time - time_) / memory_time);
    rate_ = keep * rate_ + (1.0 - keep) * (value - value_) / (time - time_);
    weight_ = keep * weight_ + (1.0 - keep);
  }
  started_ = true;
  time_ = time;
  value_ = value;
}

std::optional<double> Progress::Rate::per_second() const {
  if (weight_ <= 0.0) return std::nullopt;
  return rate_ / weight_;
}

Progress::Progress(std::ostream& stream, ProgressOptions options, Clock clock)
    : stream_(stream), options_(options), clock_(std::move(clock)) {}

Progress::Progress(ProgressOptions options) : Progress(std::cerr, options, &steady_seconds) {}

Progress::~Progress() {
  if (line_open_) stream_ << '\n' << std::flush;
}

void Progress::update(const ProgressState& state) {
  if (options_.style == ProgressStyle::quiet) return;
  const double now = clock_();
  const bool new_phase = !drawn_ || state.phase != last_phase_;
  last_phase_ = state.phase;
  sample(state, now);
  last_state_ = state;
  last_state_.phase = last_phase_;
  const double interval = options_.style == ProgressStyle::bar ? redraw_interval : line_interval;
  if (new_phase || now - last_draw_ >= interval) draw(last_state_, now);
}

void Progress::message(std::string_view text) {
  if (line_open_) stream_ << "\r\x1b[K";
  line_open_ = false;
  stream_ << text << '\n' << std::flush;
}

void Progress::finish() {
  if (!drawn_) return;
  draw(last_state_, clock_());
  if (line_open_) stream_ << '\n' << std::flush;
  line_open_ = drawn_ = false;
}

void Progress::sample(const ProgressState& state, double now) {
  if (sampled_ && now - last_sample_ < sample_interval) return;
  // A fraction that starts over belongs to another phase; from one that stands still no time left follows.
  if (!state.fraction || (last_fraction_ && *state.fraction <= *last_fraction_)) fraction_rate_.restart();
  if (state.fraction) fraction_rate_.sample(now, *state.fraction);
  step_rate_.sample(now, static_cast<double>(state.particle_steps));
  last_fraction_ = state.fraction;
  last_sample_ = now;
  sampled_ = true;
}

void Progress::draw(const ProgressState& state, double now) {
  if (options_.style == ProgressStyle::bar) {
    stream_ << '\r' << bar(state) << "\x1b[K" << std::flush;
    line_open_ = true;
  } else {
    std::string line(state.phase);
    if (state.fraction) line += fmt::format(" {:.1f} %", 100.0 * *state.fraction);
    stream_ << line << details(state, false) << '\n' << std::flush;
  }
  last_draw_ = now;
  drawn_ = true;
}

std::string Progress::details(const ProgressState& state, bool brief) const {
  std::string text = brief ? fmt::format(" | {:#.3g} s", state.simulated_time)
                           : fmt::format(" | t = {:.5g} s | {} parcels", state.simulated_time, state.parcels);
  if (const auto rate = step_rate_.per_second())
    text += fmt::format(" | {} particle-steps/s", count_text(*rate));
  if (const auto rate = fraction_rate_.per_second(); rate && state.fraction && *rate > 0.0)
    text += fmt::format(" | {} left", duration_text(std::max(0.0, 1.0 - *state.fraction) / *rate));
  return text;
}

std::string Progress::bar(const ProgressState& state) const {
  const std::string head = fmt::format("{} ", state.phase);
  const std::string percent =
      state.fraction ? fmt::format("{:3.0f} %", std::floor(100.0 * std::clamp(*state.fraction, 0.0, 1.0)))
                     : "";
  const auto room = static_cast<std::size_t>(std::max(options_.width - 1, 1));
  const std::size_t needed_besides = columns(head) + 3;  // brackets and a space
  std::string rest = percent + details(state, false);
  // A bar of a few marks says more than digits that a narrow terminal would cut off.
  if (needed_besides + columns(rest) + 5 > room) rest = percent + details(state, true);
  const std::size_t needed = needed_besides + columns(rest);
  if (!state.fraction || needed + 5 > room) return shortened(head + rest, room);

  const std::size_t length = std::min<std::size_t>(longest_bar, room - needed);
  const auto full =
      static_cast<std::size_t>(std::clamp(*state.fraction, 0.0, 1.0) * static_cast<double>(length));
  const char* on = options_.colour ? "\x1b[32m" : "";
  const char* off = options_.colour ? "\x1b[0m" : "";
  return fmt::format("{}[{}{}{}{}] {}", head, on, std::string(full, '#'), off,
                     std::string(length - full, '-'), rest);
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::min(std::ceil(seconds), 1e12));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  if (whole < 86400) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  return fmt::format("{} d {} h", whole / 86400, whole % 86400 / 3600);
}

std::string count_text(double count) {
  constexpr const char* suffixes[] = {"", " k", " M", " G", " T"};
  std::size_t step = 0;
  while (count >= 999.5 && step + 1 < std::size(suffixes)) count /= 1000.0, ++step;
  if (step == 0) return fmt::format("{:.0f}", count);
  const int decimals = count < 9.995 ? 2 : count < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f}{}", count, decimals, suffixes[step]);
}

}  // namespace pulvis
