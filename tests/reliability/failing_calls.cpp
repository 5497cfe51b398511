// SPDX-License-Identifier: Apache-2.0
// Loaded before the C library (LD_PRELOAD), makes one system call on the files of a folder fail as a full or broken
// disk would, or come back early. The environment says which:
//   PULVIS_FAIL_UNDER  folder whose files count
//   PULVIS_FAIL_CALL   open, write, fsync, rename, ftruncate, close, mkdir or unlink
//   PULVIS_FAIL_AT     which of these calls, from 1; 0: none
//   PULVIS_FAIL_FOR    for how many of them (default 1)
//   PULVIS_FAIL_WITH   an errno value, or 0: a write of half the bytes, as the kernel may do
//   PULVIS_FAIL_COUNT  file that gets the number of calls at the end
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const char* setting(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

std::atomic<long> calls{0};

/// The function that stands behind ours.
template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool counts(const char* call, const char* path) {
  const char* folder = setting("PULVIS_FAIL_UNDER");
  return *folder && std::strcmp(setting("PULVIS_FAIL_CALL"), call) == 0 &&
         std::strncmp(path, folder, std::strlen(folder)) == 0;
}

/// Whether this call is one of those that fail.
bool fails(const char* call, const char* path) {
  if (!counts(call, path)) return false;
  const long number = ++calls, at = std::atol(setting("PULVIS_FAIL_AT"));
  const long many = *setting("PULVIS_FAIL_FOR") ? std::atol(setting("PULVIS_FAIL_FOR")) : 1;
  return at > 0 && number >= at && number < at + many;
}

bool fails(const char* call, int file) {
  char link[64], path[4096];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t size = ::readlink(link, path, sizeof path - 1);
  if (size < 0) return false;
  path[size] = '\0';
  return fails(call, path);
}

int failed() {
  errno = std::atoi(setting("PULVIS_FAIL_WITH"));
  return -1;
}

struct Count {
  ~Count() {
    if (!*setting("PULVIS_FAIL_COUNT")) return;
    if (std::FILE* file = std::fopen(setting("PULVIS_FAIL_COUNT"), "w")) {
      std::fprintf(file, "%ld\n", calls.load());
      std::fclose(file);
    }
  }
} count;

}  // namespace

extern "C" {

ssize_t write(int file, const void* data, size_t size) {
  static auto* const next = real<ssize_t(int, const void*, size_t)>("write");
  if (!fails("write", file)) return next(file, data, size);
  if (std::atoi(setting("PULVIS_FAIL_WITH")) != 0) return failed();
  return next(file, data, size > 1 ? size / 2 : size);
}

int fsync(int file) {
  static auto* const next = real<int(int)>("fsync");
  return fails("fsync", file) ? failed() : next(file);
}

int ftruncate(int file, off_t length) {
  static auto* const next = real<int(int, off_t)>("ftruncate");
  return fails("ftruncate", file) ? failed() : next(file, length);
}

// A file that reports a failure when it is closed is closed all the same.
int close(int file) {
  static auto* const next = real<int(int)>("close");
  const bool fail = fails("close", file);
  const int result = next(file);
  return fail ? failed() : result;
}

int rename(const char* from, const char* to) {
  static auto* const next = real<int(const char*, const char*)>("rename");
  return fails("rename", to) ? failed() : next(from, to);
}

int mkdir(const char* path, mode_t mode) {
  static auto* const next = real<int(const char*, mode_t)>("mkdir");
  return fails("mkdir", path) ? failed() : next(path, mode);
}

int unlink(const char* path) {
  static auto* const next = real<int(const char*)>("unlink");
  return fails("unlink", path) ? failed() : next(path);
}

int open(const char* path, int flags, ...) {
  static auto* const next = real<int(const char*, int, ...)>("open");
  std::va_list more;
  va_start(more, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
  va_end(more);
  // A folder is opened to be synced, which does no harm where it cannot be.
  if ((flags & O_DIRECTORY) != 0) return next(path, flags, mode);
  return fails("open", path) ? failed() : next(path, flags, mode);
}

}  // extern "C"
