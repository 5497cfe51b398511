// SPDX-License-Identifier: Apache-2.0
#include "output/vtk_series.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "engine/base/failure.hpp"
#include "output/safe_file.hpp"
#include "output/xml_text.hpp"

namespace pulvis {
namespace {

constexpr std::string_view last_line = "</VTKFile>";

std::optional<std::string_view> attribute(std::string_view line, std::string_view name) {
  const auto start = line.find(fmt::format(" {}=\"", name));
  if (start == std::string_view::npos) return std::nullopt;
  const auto first = start + name.size() + 3;
  const auto end = line.find('"', first);
  if (end == std::string_view::npos) return std::nullopt;
  return line.substr(first, end - first);
}

// Reads the lines that write() makes; nothing else continues a run.
std::optional<VtkSeries::Frame> frame_from(std::string_view line) {
  const auto time = attribute(line, "timestep");
  const auto file = attribute(line, "file");
  if (!time || !file) return std::nullopt;
  VtkSeries::Frame frame{0.0, xml_unescape(*file)};
  const auto end = time->data() + time->size();
  const auto result = std::from_chars(time->data(), end, frame.time);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return frame;
}

}  // namespace

VtkSeries VtkSeries::continued(std::string path, double time) {
  VtkSeries series(std::move(path));
  if (!std::filesystem::exists(series.path_)) return series;
  std::ifstream input(series.path_);
  std::string line, last;
  for (int number = 1; std::getline(input, line); ++number) {
    last = line;
    if (line.find("<DataSet") == std::string::npos) continue;
    auto frame = frame_from(line);
    if (!frame)
      throw Failure(Exit::bad_input, fmt::format("{}:{}: not a frame of a time series; remove the file, its "
                                                 "frames can still be opened one by one",
                                                 series.path_, number));
    if (frame->time < time) series.frames_.push_back(std::move(*frame));
  }
  if (last != last_line)
    throw Failure(
        Exit::bad_input,
        fmt::format("{} is not a complete time series of frames; remove it to go on without", series.path_));
  return series;
}

void VtkSeries::add(double time, const std::string& file) {
  const std::string folder = std::filesystem::path(path_).parent_path().string() + "/";
  const bool inside = folder.size() > 1 && file.starts_with(folder);
  frames_.push_back({time, inside ? file.substr(folder.size()) : file});
  write();
}

void VtkSeries::write() const {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const Frame& frame : frames_)
    xml += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time,
                       xml_escape(frame.file));
  xml += fmt::format("</Collection>\n{}\n", last_line);
  write_file_safely(path_, xml);
}

}  // namespace pulvis
