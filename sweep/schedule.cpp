// SPDX-License-Identifier: Apache-2.0
#include "sweep/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <list>
#include <thread>

#include "engine/base/failure.hpp"
#include "output/run_folder.hpp"
#include "run/stop_request.hpp"
#include "sweep/child.hpp"
#include "sweep/run_state.hpp"

namespace pulvis::sweep {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr auto look_interval = std::chrono::milliseconds(20);
// A run whose sweep was killed stops by itself within a step, and then writes its checkpoint.
constexpr double patience = 60.0;  // s

class Scheduler {
 public:
  Scheduler(const std::vector<Task>& tasks, const std::string& program, int jobs, Overview& overview)
      : tasks_(tasks),
        program_(program),
        jobs_(static_cast<std::size_t>(jobs)),
        overview_(overview),
        outcomes_(tasks.size()) {}

  std::vector<Outcome> run() {
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      if (standing_of(tasks_[k].folder) == Standing::complete)
        outcomes_[k].state = Outcome::State::complete;
      else
        waiting_.push_back(k);
    }
    while (true) {
      collect();
      if (signal_to_stop() != 0)
        stop();
      else
        start();
      overview_.update(counts(), seconds_left());
      if (running_.empty() && (waiting_.empty() || stopping_)) return std::move(outcomes_);
      std::this_thread::sleep_for(look_interval);
    }
  }

 private:
  struct Running {
    std::size_t task;
    Child child;
    Clock::time_point start;
    std::uint64_t log_start;  ///< bytes that were in the log before
  };

  void start() {
    for (auto next = waiting_.begin(); next != waiting_.end() && running_.size() < jobs_;) {
      const Task& task = tasks_[*next];
      if (is_held(task.folder) && since(begin_) < patience) {
        ++next;
        continue;
      }
      const std::size_t index = *next;
      next = waiting_.erase(next);
      const Standing standing = standing_of(task.folder);
      std::vector<std::string> arguments = task.arguments;
      const bool told = task.continues == Task::Continues::when_told;
      if (told && standing == Standing::resumable) arguments.push_back("--resume");
      if (told && standing == Standing::broken_off) arguments.push_back("--force");
      std::error_code none;
      const auto size = std::filesystem::file_size(task.log, none);
      running_.push_back(
          {index, Child(program_, arguments, task.log), Clock::now(), none ? 0 : std::uint64_t(size)});
    }
  }

  void collect() {
    for (auto at = running_.begin(); at != running_.end();) {
      const auto exit = at->child.ended();
      if (!exit) {
        ++at;
        continue;
      }
      close(*at, *exit);
      at = running_.erase(at);
    }
  }

  void close(const Running& run, int exit) {
    Outcome& outcome = outcomes_[run.task];
    outcome.exit = exit;
    if (exit == static_cast<int>(Exit::ok)) {
      outcome.state = Outcome::State::complete;
      seconds_ += since(run.start);
      ++timed_;
      return;
    }
    const bool on_request = exit == static_cast<int>(Exit::interrupted) ||
                            exit == static_cast<int>(Exit::cancelled) || (stopping_ && exit == 128 + SIGTERM);
    outcome.state = on_request ? Outcome::State::stopped : Outcome::State::failed;
    if (on_request) return;
    outcome.line = exit > 128 ? fmt::format("ended by signal {}", exit - 128)
                              : telling_line(tasks_[run.task].log, run.log_start);
    overview_.message(
        fmt::format("{} failed with exit code {}: {}", tasks_[run.task].name, exit, outcome.line));
  }

  void stop() {
    if (stopping_) return;
    stopping_ = true;
    overview_.message("stopping; the same command goes on");
    for (const Running& run : running_) run.child.signal(SIGTERM);
  }

  Counts counts() const {
    Counts c;
    c.running = running_.size();
    c.waiting = waiting_.size();
    for (const Outcome& outcome : outcomes_) {
      c.complete += outcome.state == Outcome::State::complete;
      c.failed += outcome.state == Outcome::State::failed;
      c.stopped += outcome.state == Outcome::State::stopped;
    }
    return c;
  }

  // As if all that is left took as long as what has ended here.
  std::optional<double> seconds_left() const {
    if (timed_ == 0 || stopping_ || (running_.empty() && waiting_.empty())) return {};
    const double each = seconds_ / static_cast<double>(timed_);
    double work = each * static_cast<double>(waiting_.size());
    for (const Running& run : running_) work += std::max(0.0, each - since(run.start));
    return work / static_cast<double>(std::min(jobs_, waiting_.size() + running_.size()));
  }

  const std::vector<Task>& tasks_;
  const std::string& program_;
  const std::size_t jobs_;
  Overview& overview_;
  std::vector<Outcome> outcomes_;
  std::list<std::size_t> waiting_;
  std::list<Running> running_;
  const Clock::time_point begin_ = Clock::now();
  bool stopping_ = false;
  double seconds_ = 0.0;  ///< that runs took which have ended here
  std::size_t timed_ = 0;
};

}  // namespace

std::vector<Outcome> run_all(const std::vector<Task>& tasks, const std::string& program, int jobs,
                             Overview& overview) {
  return Scheduler(tasks, program, jobs, overview).run();
}

Exit exit_of(const std::vector<Outcome>& outcomes) {
  bool all = true;
  for (const Outcome& outcome : outcomes) {
    all = all && outcome.state == Outcome::State::complete;
    if (outcome.state == Outcome::State::failed)
      return outcome.exit < static_cast<int>(Exit::interrupted) ? static_cast<Exit>(outcome.exit)
                                                                : Exit::unexpected;
  }
  if (all) return Exit::ok;
  return signal_to_stop() == SIGINT ? Exit::cancelled : Exit::interrupted;
}

void print_what_is_missing(const std::vector<Task>& tasks, const std::vector<Outcome>& outcomes,
                           const std::string& what) {
  for (std::size_t k = 0; k < tasks.size(); ++k)
    if (outcomes[k].state == Outcome::State::failed)
      fmt::print(stderr, "pulvis: {} failed with exit code {}: {}\n  see {}\n", tasks[k].name,
                 outcomes[k].exit, outcomes[k].line, tasks[k].log);
  const auto left = std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) {
    return o.state == Outcome::State::stopped || o.state == Outcome::State::not_started;
  });
  if (left > 0)
    fmt::print(stderr, "pulvis: {} {} are not complete; the same command goes on with them\n", left, what);
}

}  // namespace pulvis::sweep
