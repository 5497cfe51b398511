// SPDX-License-Identifier: Apache-2.0
#include "sweep/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include "engine/base/failure.hpp"
#include "output/file_calls.hpp"

namespace pulvis::sweep {
namespace {

constexpr int cannot_start = 127;  // as shells have it

// Between fork and exec only what is safe in a signal handler may be called: other threads may have held locks.
[[noreturn]] void become(const char* program, char* const* words, int input, int log, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(cannot_start);  // it died before that held
  ::setpgid(0, 0);
  if (::dup2(input, STDIN_FILENO) >= 0 && ::dup2(log, STDOUT_FILENO) >= 0 && ::dup2(log, STDERR_FILENO) >= 0)
    ::execv(program, words);
  ::_exit(cannot_start);
}

}  // namespace

Child::Child(const std::string& program, const std::vector<std::string>& arguments, const std::string& log)
    : process_(0) {
  std::vector<std::string> texts{program};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  for (std::string& text : texts) words.push_back(text.data());
  words.push_back(nullptr);
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0 || input < 0) {
    const int error = errno;
    if (input >= 0) ::close(input);
    if (file >= 0) ::close(file);
    fail_to_write(log, error);
  }
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) become(program.c_str(), words.data(), input, file, parent);
  const int error = errno;
  ::close(input);
  ::close(file);
  if (process_ < 0)
    throw Failure(Exit::unexpected, fmt::format("cannot start a process: {}", std::strerror(error)));
}

Child::Child(Child&& other) noexcept : process_(std::exchange(other.process_, 0)), exit_(other.exit_) {}

Child::~Child() {
  if (process_ <= 0 || exit_) return;
  signal(SIGTERM);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<int> Child::ended() {
  if (exit_) return exit_;
  int status = 0;
  const pid_t got = ::waitpid(process_, &status, WNOHANG);
  if (got == 0 || (got < 0 && errno == EINTR)) return {};
  // One that cannot be waited for is gone, and nobody knows how.
  exit_ = got < 0 ? cannot_start : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return exit_;
}

void Child::signal(int number) const {
  if (process_ > 0 && !exit_) ::kill(process_, number);
}

std::string this_program() {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw Failure(Exit::unexpected, "cannot find this program: " + error.message());
  return path.string();
}

}  // namespace pulvis::sweep
