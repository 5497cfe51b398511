// SPDX-License-Identifier: Apache-2.0
#include "output/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/base/failure.hpp"
#include "output/file_calls.hpp"

namespace pulvis {
namespace {

namespace fs = std::filesystem;
constexpr const char* lock_name = ".pulvis.lock";

void create_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail_to_write(path, error.value());
  if (!fs::is_directory(path, error)) fail_to_write(path, ENOTDIR);
}

bool matches(std::span<const std::string> patterns, const std::string& name) {
  for (const std::string& pattern : patterns) {
    if (::fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME) == 0) return true;
    if (::fnmatch((pattern + ".part").c_str(), name.c_str(), FNM_PATHNAME) == 0) return true;
  }
  return false;
}

// "." and the sub-folders named before a slash in the patterns; nobody looks anywhere else.
std::set<std::string> result_folders(std::span<const std::string> patterns) {
  std::set<std::string> folders{"."};
  for (const std::string& pattern : patterns) {
    const auto parent = fs::path(pattern).parent_path().string();
    if (!parent.empty()) folders.insert(parent);
  }
  return folders;
}

std::vector<fs::path> results_in(const fs::path& root, std::span<const std::string> patterns) {
  std::vector<fs::path> found;
  for (const std::string& folder : result_folders(patterns)) {
    // A link is followed by neither the listing nor the removal: what it points to is not ours.
    if (fs::is_symlink(root / folder) || !fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::directory_iterator(root / folder)) {
      const auto name = entry.path().filename().string();
      const auto relative = folder == "." ? name : folder + "/" + name;
      if (entry.symlink_status().type() == fs::file_type::regular && matches(patterns, relative))
        found.push_back(entry.path());
    }
  }
  return found;
}

void remove_results_in(const fs::path& root, std::span<const std::string> patterns,
                       const std::set<std::string>& known) {
  for (const fs::path& file : results_in(root, patterns))
    if (!known.contains(file.lexically_relative(root).lexically_normal().string())) fs::remove(file);
  for (const std::string& folder : result_folders(patterns)) {
    if (folder == "." || fs::is_symlink(root / folder) || !fs::is_directory(root / folder)) continue;
    if (fs::is_empty(root / folder)) fs::remove(root / folder);
  }
}

bool is_used(const fs::path& root) {
  for (const auto& entry : fs::directory_iterator(root))
    if (entry.path().filename() != lock_name) return true;
  return false;
}

// The holder before us may have removed the lock file between our open and our lock; such a lock guards
// nothing, since the next process makes a new file.
bool still_named(int lock, const std::string& path) {
  struct stat held {
  }, named{};
  return ::fstat(lock, &held) == 0 && ::stat(path.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
         held.st_dev == named.st_dev;
}

}  // namespace

bool is_held(const std::string& folder) {
  const int lock = ::open((folder + "/" + lock_name).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (lock < 0) return false;
  const bool held = ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(lock);
  return held;
}

RunFolder::RunFolder(std::string path, UsedFolder used, std::span<const std::string> result_files)
    : path_(std::move(path)), lock_(-1) {
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
  if (used != UsedFolder::resume) {
    create_folder(path_);
  } else if (!fs::is_directory(path_)) {
    throw Failure(Exit::usage,
                  fmt::format("there is no results folder {} to go on with; start the run without "
                              "--resume",
                              path_));
  }
  lock();
  try {
    if (used == UsedFolder::replace_results) {
      remove_results_in(path_, result_files, {});
    } else if (used == UsedFolder::refuse && is_used(path_)) {
      throw Failure(Exit::usage,
                    fmt::format("the results folder {} is already in use; choose another one, or "
                                "give --force to replace the results in it",
                                path_));
    }
  } catch (const fs::filesystem_error& error) {
    unlock();
    fail_to_write(error.path1().string(), error.code().value());
  } catch (...) {
    unlock();
    throw;
  }
}

RunFolder::~RunFolder() { unlock(); }

std::string RunFolder::folder(const std::string& name) const {
  create_folder(file(name));
  return file(name);
}

void RunFolder::remove_results(std::span<const std::string> result_files,
                               const std::set<std::string>& known) const {
  try {
    remove_results_in(path_, result_files, known);
  } catch (const fs::filesystem_error& error) {
    fail_to_write(error.path1().string(), error.code().value());
  }
}

void RunFolder::lock() {
  const std::string name = file(lock_name);
  for (;;) {
    lock_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (lock_ < 0) fail_to_write(path_, errno);
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      ::close(std::exchange(lock_, -1));
      if (error == EINTR) continue;
      if (error != EWOULDBLOCK) fail_to_write(name, error);
      throw Failure(Exit::usage, fmt::format("another run is writing to {}; wait for it to end, or choose "
                                             "another results folder",
                                             path_));
    }
    if (still_named(lock_, name)) return;
    ::close(std::exchange(lock_, -1));
  }
}

void RunFolder::unlock() {
  if (lock_ < 0) return;
  ::unlink(file(lock_name).c_str());  // while still locked, see still_named
  ::close(std::exchange(lock_, -1));
}

}  // namespace pulvis
