// SPDX-License-Identifier: Apache-2.0
#include "output/vtk_series.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "output/safe_file.hpp"
#include "output/xml_text.hpp"

namespace pulvis {

VtkSeries::VtkSeries(std::string path, std::vector<Frame> frames)
    : path_(std::move(path)), frames_(std::move(frames)) {
  if (!frames_.empty()) write();
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
  xml += "</Collection>\n</VTKFile>\n";
  write_file_safely(path_, xml);
}

}  // namespace pulvis
