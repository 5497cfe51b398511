// SPDX-License-Identifier: Apache-2.0
#include "validation/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "output/safe_file.hpp"
#include "validation/report.hpp"

namespace pulvis::validation {
namespace {

std::vector<Result> chosen(const std::vector<std::string>& only) {
  std::string known;
  for (const Chapter& c : chapters()) known += fmt::format("\n  {:<14} {}", c.name, c.title);
  for (const std::string& name : only)
    if (std::none_of(chapters().begin(), chapters().end(), [&](const Chapter& c) { return c.name == name; }))
      throw Failure(Exit::usage, fmt::format("there is no chapter \"{}\"; chapters are:{}", name, known));
  std::vector<Result> results;
  for (const Chapter& c : chapters())
    if (only.empty() || std::find(only.begin(), only.end(), c.name) != only.end())
      results.push_back({&c, {}, 0});
  return results;
}

void run(Result& result, Effort effort) {
  const auto start = std::chrono::steady_clock::now();
  result.chapter->run(result.findings, effort);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print(stderr, "validate: {} {} after {:.1f} s\n", result.chapter->name,
             result.findings.passed() ? "passed" : "FAILED", result.seconds);
}

/// All chapters, side by side; the order in which they end does not matter.
void run_all(std::vector<Result>& results, Effort effort, int threads) {
  std::exception_ptr trouble;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (std::size_t k = 0; k < results.size(); ++k) {
    try {
      run(results[k], effort);
    } catch (...) {
#pragma omp critical(pulvis_validate)
      trouble = std::current_exception();
    }
  }
  if (trouble) std::rethrow_exception(trouble);
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Failure(Exit::io, fmt::format("cannot create {}: {}", folder, error.message()));
}

}  // namespace

Exit validate(const Request& request) {
  std::vector<Result> results = chosen(request.only);
  if (!request.out.empty()) make_folder(request.out);
  if (!request.json.empty()) write_file_safely(request.json, json_text({}));  // an hour later would be late
  run_all(results, request.quick ? Effort::quick : Effort::full, request.threads);
  fmt::print("{}", table_text(results));
  if (!request.out.empty()) {
    const std::filesystem::path folder = request.out;
    for (const Result& r : results)
      for (const Figure& figure : r.findings.figures())
        write_file_safely((folder / (figure.name + ".csv")).string(), figure_csv(figure));
    write_file_safely((folder / "validation.html").string(), page_text(results, request.quick));
    fmt::print("\n{}\n", (folder / "validation.html").string());
  }
  if (!request.json.empty()) write_file_safely(request.json, json_text(results));
  fmt::print("\n{}\n", all_passed(results) ? "all comparisons passed" : "comparisons FAILED");
  return all_passed(results) ? Exit::ok : Exit::target_missed;
}

}  // namespace pulvis::validation
