// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// Runs the built program as a user would: with arguments, an environment and a folder to stand in.
namespace pulvis::tests {

/// Where the build put the program, and where the sources are.
std::string program_path();
std::string source_folder();

using Json = nlohmann::json;

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

inline Json json_of(const std::filesystem::path& path) { return Json::parse(text_of(path)); }

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  if (text_of(path) != text) throw std::runtime_error("cannot write " + path.string());
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// A folder of its own for each test; gone with what is in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "pulvis-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& text) const {
    write_text(path_ / name, text);
    return *this / name;
  }

 private:
  std::filesystem::path path_;
};

struct Outcome {
  int exit = -1;  ///< 128 + signal if one killed it, as a shell has it
  std::string out, err;
};

struct Surroundings {
  std::vector<std::pair<std::string, std::string>> environment{};  ///< besides that of the test
  std::string folder{};                                            ///< to stand in; empty: that of the test
  std::string executable = program_path();
};

/// A process that runs; ends with the test at the latest.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments, const Surroundings& surroundings = {}) {
    arguments.insert(arguments.begin(), surroundings.executable);
    std::vector<char*> words;
    for (std::string& a : arguments) words.push_back(a.data());
    words.push_back(nullptr);
    const std::string out = streams_ / "out", err = streams_ / "err";
    child_ = ::fork();
    if (child_ < 0) throw std::runtime_error("cannot fork");
    if (child_ > 0) return;
    // Threads of a test must not spin while they wait: there may be more of them than processors.
    ::setenv("OMP_WAIT_POLICY", "passive", 1);
    for (const auto& [name, value] : surroundings.environment) ::setenv(name.c_str(), value.c_str(), 1);
    if (!surroundings.folder.empty() && ::chdir(surroundings.folder.c_str()) != 0) ::_exit(126);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  ~Process() {
    if (child_ > 0) ::kill(child_, SIGKILL), ::waitpid(child_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int number) const { ::kill(child_, number); }
  pid_t id() const { return child_; }

  /// Waits for its end; nothing if it has not come after that many seconds.
  std::optional<Outcome> wait(double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    for (;;) {
      int status = 0;
      const pid_t got = ::waitpid(child_, &status, WNOHANG);
      if (got == child_) {
        child_ = 0;
        Outcome outcome;
        outcome.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        outcome.out = text_of(streams_ / "out");
        outcome.err = text_of(streams_ / "err");
        return outcome;
      }
      if (got < 0 && errno != EINTR) throw std::runtime_error("lost a process");
      if (std::chrono::steady_clock::now() > end) return {};
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

 private:
  TemporaryFolder streams_;
  pid_t child_ = 0;
};

/// Runs a program to its end. One that hangs is killed and throws.
inline Outcome call(const std::vector<std::string>& arguments, const Surroundings& surroundings = {}) {
  Process process(arguments, surroundings);
  if (const auto outcome = process.wait(100.0)) return *outcome;
  throw std::runtime_error("the program hangs");
}

/// Whether VTK's own readers find no fault in any file of a folder; see tests/output/read_back.py.
inline testing::AssertionResult vtk_reads_all_of(const std::string& folder) {
  Surroundings python;
  python.executable = "/usr/bin/python3";
  const Outcome seen = call({source_folder() + "/tests/output/read_back.py", folder}, python);
  if (seen.exit == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << seen.err;
}

/// What VTK's own readers find in the frames of a series; see open_series.py.
inline Json open_series(const std::string& file) {
  Surroundings python;
  python.executable = "/usr/bin/python3";
  const Outcome seen = call({source_folder() + "/tests/run/open_series.py", file}, python);
  if (seen.exit != 0) throw std::runtime_error("VTK cannot open " + file + ":\n" + seen.err);
  return Json::parse(seen.out);
}

}  // namespace pulvis::tests
