// SPDX-License-Identifier: Apache-2.0
#include "sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <thread>

#include "output/run_folder.hpp"
#include "run/run_case.hpp"
#include "run/stop_request.hpp"
#include "sweep/child.hpp"
#include "sweep/record.hpp"
#include "sweep/result_table.hpp"
#include "sweep/run_state.hpp"
#include "sweep/schedule.hpp"

namespace pulvis::sweep {
namespace {

namespace fs = std::filesystem;

void refuse_other_sweep(const std::string& out, const std::string& record_file,
                        const std::vector<RecordedRun>& now) {
  const std::vector<std::string> lines = differences(read_record(record_file), now);
  if (lines.empty()) return;
  constexpr std::size_t most = 10;
  std::string list;
  for (std::size_t k = 0; k < std::min(most, lines.size()); ++k) list += "\n  " + lines[k];
  if (lines.size() > most) list += fmt::format("\n  and {} more", lines.size() - most);
  throw Failure(Exit::usage, fmt::format("{} holds a sweep of other runs; give what it was begun with, or "
                                         "another --out:{}",
                                         out, list));
}

bool is_empty(const std::string& folder) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().filename() != ".pulvis.lock") return false;  // of a sweep that was killed at once
  return true;
}

/// Whether a sweep is there to go on with.
bool goes_on(const Request& request, const std::string& record, const std::vector<RecordedRun>& runs) {
  std::error_code none;
  if (fs::exists(record, none)) {
    refuse_other_sweep(request.out, record, runs);
    return true;
  }
  if (request.resume)
    throw Failure(Exit::usage,
                  fmt::format("there is no sweep in {} to go on with; leave out --resume", request.out));
  if (!is_empty(request.out))
    throw Failure(Exit::usage,
                  fmt::format("{} holds other things than a sweep; give another --out", request.out));
  return false;
}

std::vector<Task> tasks_of(const std::vector<Member>& members, const RunFolder& folder, int threads) {
  std::vector<Task> tasks;
  for (const Member& member : members) {
    Task task{member.name, folder.file(member.name), folder.file(member.name + ".log"), {}};
    task.arguments = {"run", member.case_file, "--out", task.folder, "--threads", std::to_string(threads)};
    for (const Override& o : member.settings) {
      task.arguments.push_back("--set");
      task.arguments.push_back(o.key + "=" + o.value);
    }
    tasks.push_back(std::move(task));
  }
  return tasks;
}

/// The page that compares the complete runs, made by `pulvis compare`.
void compare(const std::string& program, const RunFolder& folder, const std::vector<Task>& tasks,
             const std::vector<Outcome>& outcomes) {
  std::vector<std::string> arguments{"compare"};
  for (std::size_t k = 0; k < tasks.size(); ++k)
    if (outcomes[k].state == Outcome::State::complete) arguments.push_back(tasks[k].folder);
  constexpr std::size_t two_runs = 3;
  if (arguments.size() < two_runs) return;
  const std::string page = folder.file("comparison"), log = folder.file("comparison.log");
  arguments.insert(arguments.end(), {"--out", page});
  Child child(program, arguments, log);
  std::optional<int> exit;
  while (!(exit = child.ended())) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (*exit == 0)
    fmt::print("{}/comparison.html\n", page);
  else
    fmt::print(stderr, "warning: no comparison was made (exit code {}): {}\n", *exit, telling_line(log, 0));
}

}  // namespace

Shares shares(int jobs, int threads, std::size_t runs, int processors) {
  const int wanted = static_cast<int>(std::clamp<std::size_t>(runs, 1, 1024));
  Shares s{jobs, threads};
  if (s.jobs <= 0)
    s.jobs = s.threads > 0 ? std::max(1, processors / s.threads) : std::min(wanted, processors);
  if (s.threads <= 0) s.threads = std::max(1, processors / std::min(s.jobs, wanted));
  return s;
}

Exit run_sweep(const Request& request) {
  const std::vector<Member> members = combinations(request.choice);
  const std::vector<RecordedRun> record = record_of(members);
  const std::string record_file = request.out + "/sweep.json";
  const bool again = goes_on(request, record_file, record);
  const RunFolder folder(request.out, again ? UsedFolder::resume : UsedFolder::refuse, {});
  if (!again) write_record(record_file, record);
  const auto to_do = std::count_if(members.begin(), members.end(), [&](const Member& m) {
    return standing_of(folder.file(m.name)) != Standing::complete;
  });
  const Shares share =
      shares(request.jobs, request.threads, static_cast<std::size_t>(to_do), available_processors());
  const std::vector<Task> tasks = tasks_of(members, folder, share.threads);
  const std::string program = this_program();
  std::vector<Outcome> outcomes;
  {
    Overview overview(std::cerr, ProgressOptions::for_stderr());
    if (to_do > 0)
      overview.message(fmt::format("{} runs in {}, {} at once with {} thread{} each", to_do, folder.path(),
                                   share.jobs, share.threads, share.threads == 1 ? "" : "s"));
    outcomes = run_all(tasks, program, share.jobs, overview);
  }
  write_table(folder.file("sweep.csv"), members, tasks, outcomes);
  fmt::print("{}{}\n", table_text(members, tasks, outcomes), folder.file("sweep.csv"));
  if (signal_to_stop() == 0) compare(program, folder, tasks, outcomes);
  print_what_is_missing(tasks, outcomes);
  return exit_of(outcomes);
}

}  // namespace pulvis::sweep
