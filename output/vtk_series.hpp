// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace pulvis {

/// A time series for ParaView: a .pvd file that lists the frames. ParaView believes the list without looking
/// for the files, so add a frame only when it is complete.
class VtkSeries {
 public:
  struct Frame {
    double time = 0.0;  ///< s
    std::string file;   ///< relative to the folder of the .pvd
  };

  /// An empty series, whose file is written with the first frame; or one that has these frames already.
  /// Throws Failure(Exit::io) if that cannot be written.
  explicit VtkSeries(std::string path, std::vector<Frame> frames = {});

  /// Adds a frame and rewrites the .pvd, completely or not at all. `file` may be given relative to the folder
  /// of the .pvd or as a path that begins with that folder. Throws Failure(Exit::io) if it cannot be written.
  void add(double time, const std::string& file);

  const std::vector<Frame>& frames() const { return frames_; }

 private:
  void write() const;

  std::string path_;
  std::vector<Frame> frames_;
};

}  // namespace pulvis
