// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "output/file_calls.hpp"

namespace pulvis {

/// A file that appears completely or not at all: it is written as `PATH.part` in the same folder and takes
/// its name in `commit()`, when all bytes are on the disk. Whoever reads results while a run goes on, or
/// after a crash, never meets half a file; an older file of that name stays until then.
/// Every failing call throws Failure(Exit::io) and leaves no `.part` behind.
class SafeFile {
 public:
  explicit SafeFile(std::string path, FileCalls calls = FileCalls::system());
  ~SafeFile();
  SafeFile(const SafeFile&) = delete;
  SafeFile& operator=(const SafeFile&) = delete;

  void write(const void* data, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Flushes to the disk and renames; nothing may be written after it.
  void commit();

 private:
  [[noreturn]] void give_up(int error_number);
  void discard();
  int close_file();

  std::string path_;
  std::string part_;
  FileCalls calls_;
  int file_;
};

/// Brings the names of the files in a folder to the disk; what cannot be done so is no error.
void sync_folder(const std::string& path, const FileCalls& calls = FileCalls::system());

/// Writes `content` to `path` completely or not at all; errors as SafeFile.
void write_file_safely(const std::string& path, std::string_view content,
                       FileCalls calls = FileCalls::system());

}  // namespace pulvis
