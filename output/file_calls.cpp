// SPDX-License-Identifier: Apache-2.0
#include "output/file_calls.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

const char* remedy(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "free some space or choose another results folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a results folder you may write to";
    case ENOENT:
    case ENOTDIR:
      return "check that its folder exists";
    case EISDIR:
      return "a folder of that name is in the way, move it";
    case EFBIG:
      return "raise the file size limit (ulimit -f) or write output less often";
    default:
      return "check the disk, or choose another results folder";
  }
}

}  // namespace

FileCalls FileCalls::system() { return {&::write, &::fsync, &std::rename}; }

void fail_to_write(const std::string& path, int error_number) {
  throw Failure(Exit::io, fmt::format("cannot write {}: {}; {}", path,
                                      std::generic_category().message(error_number), remedy(error_number)));
}

int write_fully(const FileCalls& calls, int file, const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = calls.write(file, next, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return ENOSPC;  // POSIX allows it for a device that takes no more
    next += written;
    size -= static_cast<std::size_t>(written);
  }
  return 0;
}

}  // namespace pulvis
