// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace pulvis {

/// Where a run stands.
struct ProgressState {
  std::string_view phase;          ///< as named in the case
  double simulated_time = 0.0;     ///< s
  std::optional<double> fraction;  ///< done, 0 to 1; none where the end cannot be foreseen
  std::uint64_t parcels = 0;
  std::uint64_t particle_steps = 0;  ///< since the start: the sum over steps of the parcels moved
};

enum class ProgressStyle {
  bar,    ///< one line, redrawn at most every 0.2 s
  lines,  ///< a plain line every 30 s and with each phase
  quiet,  ///< nothing
};

struct ProgressOptions {
  ProgressStyle style = ProgressStyle::lines;
  bool colour = false;
  int width = 80;  ///< columns of the terminal

  /// For this process's stderr: a bar if that is a terminal that can redraw a line, plain lines otherwise;
  /// colour unless NO_COLOR is set (https://no-color.org).
  static ProgressOptions for_stderr();
};

/// Shows the progress of a run on a stream (stderr; stdout belongs to data). The remaining time follows from
/// an exponentially weighted rate, so that it forgets phases that went faster or slower.
class Progress {
 public:
  using Clock = std::function<double()>;  ///< s, from any origin, never backwards

  Progress(std::ostream& stream, ProgressOptions options, Clock clock);
  /// On std::cerr, by the steady clock.
  explicit Progress(ProgressOptions options);
  /// Ends the bar's line, so that what follows starts on one of its own.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call as often as convenient (each step): it draws only when due.
  void update(const ProgressState& state);
  /// A message on a line of its own, with the bar redrawn below by the next update.
  void message(std::string_view text);
  /// Draws the last state and ends the line. Later updates start a new one.
  void finish();

 private:
  // Change per second of a growing quantity, older times weighted less.
  class Rate {
   public:
    void sample(double time, double value);
    void restart() { started_ = false, weight_ = 0.0, rate_ = 0.0; }
    std::optional<double> per_second() const;

   private:
    bool started_ = false;
    double time_ = 0.0, value_ = 0.0, rate_ = 0.0, weight_ = 0.0;
  };

  void sample(const ProgressState& state, double now);
  void draw(const ProgressState& state, double now);
  std::string details(const ProgressState& state, bool brief) const;
  std::string bar(const ProgressState& state) const;

  std::ostream& stream_;
  ProgressOptions options_;
  Clock clock_;
  Rate fraction_rate_, step_rate_;
  std::optional<double> last_fraction_;
  std::string last_phase_;
  ProgressState last_state_;
  double last_draw_ = 0.0, last_sample_ = 0.0;
  bool drawn_ = false, sampled_ = false, line_open_ = false;
};

/// A duration for people: "45 s", "3 min 05 s", "2 h 14 min", "3 d 4 h".
std::string duration_text(double seconds);

/// A count for people, in three digits: "950", "12.3 k", "4.56 M".
std::string count_text(double count);

}  // namespace pulvis
