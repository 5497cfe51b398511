// SPDX-License-Identifier: Apache-2.0
#include "study/conduct.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <set>

#include "output/run_folder.hpp"
#include "run/run_case.hpp"
#include "run/stop_request.hpp"
#include "study/record.hpp"
#include "study/report.hpp"
#include "sweep/child.hpp"
#include "sweep/run_state.hpp"
#include "sweep/schedule.hpp"
#include "sweep/sweep.hpp"

namespace pulvis::study {
namespace {

namespace fs = std::filesystem;

const Study& study_of(const std::string& name) {
  std::string known;
  for (const Study& s : studies()) {
    if (name == s.name) return s;
    known += fmt::format("\n  {:<14} {}", s.name, s.title);
  }
  throw Failure(Exit::usage, fmt::format("there is no study \"{}\"; studies are:{}", name, known));
}

void require_fit(const Study& study, const Options& options) {
  if (study.takes_case && options.case_file.empty())
    throw Failure(Exit::usage, fmt::format("the study \"{}\" needs a case: pulvis study {} CASE --out DIR",
                                           study.name, study.name));
  if (!study.takes_case && !options.case_file.empty())
    throw Failure(Exit::usage, fmt::format("the study \"{}\" has its own cases and takes none; leave out {}",
                                           study.name, options.case_file));
  if (!study.takes_case && !options.settings.empty())
    throw Failure(Exit::usage,
                  fmt::format("the study \"{}\" takes no case, so there is nothing to --set", study.name));
}

std::vector<Point> points_of(const Study& study, const Options& options) {
  require_fit(study, options);
  std::vector<Point> points = study.points(options);
  std::set<std::string> names;
  for (const Point& p : points)
    if (!names.insert(p.name).second)
      throw Failure(Exit::usage,
                    fmt::format("the study \"{}\" would have two points {}: give each factor once",
                                study.name, p.name));
  return points;
}

/// Takes over or begins the record in the folder.
void hold_record(const std::string& out, const Study& study, const std::vector<Point>& points) {
  std::error_code none;
  if (!fs::exists(record_file(out), none)) return write_record(out, {study.name, points});
  const Record before = read_record(out);
  const auto same = [](const Point& a, const Point& b) {
    return a.name == b.name && a.settings == b.settings;
  };
  if (before.study != study.name ||
      !std::equal(before.points.begin(), before.points.end(), points.begin(), points.end(), same))
    throw Failure(Exit::usage,
                  fmt::format("{} holds the study {} of other points; give the command it was begun with, "
                              "or another --out",
                              out, before.study));
}

std::vector<sweep::Task> tasks_of(const Request& request, const std::vector<Point>& points, int threads) {
  std::vector<sweep::Task> tasks;
  for (const Point& p : points) {
    const std::string folder = point_folder(request.out, p);
    tasks.push_back({p.name,
                     folder,
                     folder + ".log",
                     {"study", request.name, "--out", request.out, "--point", p.name, "--threads",
                      std::to_string(threads)},
                     sweep::Task::Continues::by_itself});
  }
  return tasks;
}

std::vector<Done> results_of(const std::string& out, const std::vector<Point>& points) {
  std::vector<Done> done;
  for (const Point& p : points) done.push_back({p, read_result(out, p)});
  return done;
}

Exit compute_point(const Request& request) {
  const Study& study = study_of(request.name);
  const Record record = read_record(request.out);
  for (const Point& point : record.points) {
    if (point.name != request.point) continue;
    const std::string folder = point_folder(request.out, point);
    const RunFolder held(folder, UsedFolder::keep, {});
    const auto start = std::chrono::steady_clock::now();
    try {
      const Json result = study.compute({point.settings, folder, request.threads});
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      write_result(request.out, point, taken.count(), result);
      return Exit::ok;
    } catch (const Stopped&) {
      return signal_to_stop() == SIGINT ? Exit::cancelled : Exit::interrupted;
    }
  }
  throw Failure(Exit::usage, fmt::format("the study in {} has no point {}", request.out, request.point));
}

}  // namespace

Exit conduct(const Request& request) {
  if (!request.point.empty()) return compute_point(request);
  const Study& study = study_of(request.name);
  const std::vector<Point> points = points_of(study, request.options);
  std::error_code none;
  const bool again = fs::exists(record_file(request.out), none);
  const RunFolder folder(request.out, again ? UsedFolder::keep : UsedFolder::refuse, {});
  hold_record(request.out, study, points);
  const std::string point_place = folder.folder("points");
  const auto to_do = std::count_if(points.begin(), points.end(), [&](const Point& p) {
    return sweep::standing_of(point_folder(request.out, p)) != sweep::Standing::complete;
  });
  const sweep::Shares share =
      sweep::shares(request.jobs, request.threads, static_cast<std::size_t>(to_do), available_processors());
  const std::vector<sweep::Task> tasks = tasks_of(request, points, share.threads);
  std::vector<sweep::Outcome> outcomes;
  {
    sweep::Overview overview(std::cerr, ProgressOptions::for_stderr(), "points");
    outcomes = sweep::run_all(tasks, sweep::this_program(), share.jobs, overview);
  }
  sweep::print_what_is_missing(tasks, outcomes, "points");
  if (const Exit exit = sweep::exit_of(outcomes); exit != Exit::ok) return exit;
  const std::vector<Done> done = results_of(request.out, points);
  validation::Findings findings;
  study.conclude(done, findings);
  write_report(folder.path(), study, done, findings);
  fmt::print("{}\n{}\n{}\n", table_text(findings), folder.file("study.html"), folder.file("study.json"));
  fmt::print("\n{}\n", findings.passed() ? "every limit is kept" : "limits are NOT kept");
  return findings.passed() ? Exit::ok : Exit::target_missed;
}

}  // namespace pulvis::study
