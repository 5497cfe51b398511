// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <string>

namespace pulvis {

/// The system calls that can fail when results are written. Tests put failing ones in their place, since a
/// disk cannot be filled up for a test.
struct FileCalls {
  ssize_t (*write)(int file, const void* data, std::size_t size);
  int (*sync)(int file);
  int (*rename)(const char* from, const char* to);

  /// write(2), fsync(2) and rename(2).
  static FileCalls system();
};

/// Throws Failure(Exit::io) "cannot write PATH: REASON; what to do" for the errno value `error_number`.
[[noreturn]] void fail_to_write(const std::string& path, int error_number);

/// Writes all `size` bytes to `file`, going on after interruptions and partial writes.
/// Returns 0, or the errno value of the call that failed.
int write_fully(const FileCalls& calls, int file, const void* data, std::size_t size);

}  // namespace pulvis
