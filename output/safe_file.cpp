// SPDX-License-Identifier: Apache-2.0
#include "output/safe_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

namespace pulvis {
namespace {

constexpr int closed = -1;

}  // namespace

SafeFile::SafeFile(std::string path, FileCalls calls)
    : path_(std::move(path)), part_(path_ + ".part"), calls_(calls), file_(closed) {
  file_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) fail_to_write(path_, errno);
}

SafeFile::~SafeFile() { discard(); }

void SafeFile::write(const void* data, std::size_t size) {
  if (const int error = write_fully(calls_, file_, data, size)) give_up(error);
}

void SafeFile::commit() {
  if (calls_.sync(file_) != 0) give_up(errno);
  if (const int error = close_file()) {
    ::unlink(part_.c_str());
    fail_to_write(path_, error);
  }
  if (calls_.rename(part_.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    ::unlink(part_.c_str());
    fail_to_write(path_, error);
  }
  // A rename survives a power cut only when the folder itself is on the disk.
  const auto parent = std::filesystem::path(path_).parent_path().string();
  sync_folder(parent.empty() ? "." : parent, calls_);
}

void SafeFile::give_up(int error_number) {
  discard();
  fail_to_write(path_, error_number);
}

void SafeFile::discard() {
  if (file_ == closed) return;
  close_file();
  ::unlink(part_.c_str());
}

// Network file systems report a full disk only here.
int SafeFile::close_file() {
  const int result = ::close(std::exchange(file_, closed));
  return result == 0 || errno == EINTR ? 0 : errno;
}

// Some file systems cannot sync folders; the files are complete by then, so that is no error.
void sync_folder(const std::string& path, const FileCalls& calls) {
  const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  calls.sync(folder);
  ::close(folder);
}

void write_file_safely(const std::string& path, std::string_view content, FileCalls calls) {
  SafeFile file(path, calls);
  file.write(content);
  file.commit();
}

}  // namespace pulvis
