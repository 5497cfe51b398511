// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <set>
#include <span>
#include <string>

namespace pulvis {

/// What to do with a results folder that is not empty.
enum class UsedFolder {
  refuse,           ///< Failure(Exit::usage) that names --force
  replace_results,  ///< --force: remove what a run writes, and nothing else
  resume,           ///< --resume: it must be there, and everything in it stays
  keep,             ///< everything in it stays, if there is anything
};

/// The results folder of one run, held by this process until destruction (flock on `.pulvis.lock`), so that
/// two runs never mix their results.
class RunFolder {
 public:
  /// Creates the folder (and those above it) where missing, locks it and, if `used` allows, clears it.
  /// `result_files` are shell patterns relative to the folder of all a run writes ("log.csv",
  /// "frames/*.vtp"); `*` does not reach into sub-folders. Only matching regular files (and their unfinished
  /// `.part`) are removed, and sub-folders named in a pattern if that leaves them empty.
  /// Throws Failure(Exit::usage) if another process holds the folder, it is used, or it is to be resumed and
  /// not there; Failure(Exit::io) if it cannot be created or written.
  RunFolder(std::string path, UsedFolder used, std::span<const std::string> result_files);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::string& path() const { return path_; }
  /// The path of `name` in the folder.
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// As `file`, for a sub-folder, which is created where missing; Failure(Exit::io) if it cannot be.
  std::string folder(const std::string& name) const;
  /// Removes the results that match a pattern (see above) except those named in `known`.
  void remove_results(std::span<const std::string> result_files, const std::set<std::string>& known) const;

 private:
  void lock();
  void unlock();

  std::string path_;
  int lock_;
};

/// Whether a process holds this results folder.
bool is_held(const std::string& folder);

}  // namespace pulvis
