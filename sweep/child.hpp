// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace pulvis::sweep {

/// A program that runs beside this one. It stands in a process group of its own, so that Ctrl-C on the terminal
/// reaches this process only, and gets SIGTERM if this process dies, however that comes about.
class Child {
 public:
  /// Starts `program` with these arguments; no shell sees them. What it prints is appended to `log`. Throws
  /// Failure(Exit::io) if the log cannot be written, Failure(Exit::unexpected) if there can be no more processes.
  Child(const std::string& program, const std::vector<std::string>& arguments, const std::string& log);
  /// Ends it and waits for that, if it still runs.
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;

  /// Its exit code once it has ended, 128 + the signal if one ended it; nothing while it runs.
  std::optional<int> ended();
  void signal(int number) const;

 private:
  pid_t process_;
  std::optional<int> exit_;
};

/// Where this program is.
std::string this_program();

}  // namespace pulvis::sweep
