// SPDX-License-Identifier: Apache-2.0
#include "report/document.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/failure.hpp"
#include "output/safe_file.hpp"

namespace pulvis::report {
namespace {

std::string folder_of(const std::string& path) {
  std::filesystem::path folder(path);
  if (folder.has_extension()) return folder.replace_extension().string();
  return path + "-figures";
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (folder.empty()) return;
  std::filesystem::create_directories(folder, error);
  if (error) throw Failure(Exit::io, fmt::format("cannot create {}: {}", folder.string(), error.message()));
}

}  // namespace

Document::Document(std::string path, std::string title)
    : path_(std::move(path)),
      folder_(folder_of(path_)),
      page_(std::move(title)),
      drawing_(can_draw_figures()) {
  if (!drawing_)
    warnings_.push_back(
        "the page has no figures: gnuplot, which draws them, is not installed; its Debian package is "
        "gnuplot-nox. The figures' data are written");
}

void Document::show(const std::optional<Illustration>& figure, const std::string& otherwise) {
  if (!figure) {
    page_.paragraph(otherwise);
    return;
  }
  const std::string data = std::filesystem::path(folder_).filename().string() + "/" + figure->name + ".csv";
  files_.emplace_back(figure->name + ".csv", figure->csv);
  files_.emplace_back(figure->name + ".gnuplot", figure->script);
  if (!drawing_) {
    page_.paragraph(fmt::format("Not drawn: {}. Its data: {}.", figure->title, data));
    return;
  }
  try {
    const std::string svg = drawn_by_gnuplot(figure->script, figure->name);
    files_.emplace_back(figure->name + ".svg", svg);
    page_.images({svg_image(svg, figure->title, fmt::format("{} Data: {}.", figure->caption, data))});
  } catch (const Failure& failure) {
    warnings_.push_back(failure.what());
    page_.paragraph(fmt::format("Not drawn: {}; gnuplot refused it. Its data: {}.", figure->title, data));
  }
}

void Document::write() const {
  make_folder(std::filesystem::path(path_).parent_path());
  if (!files_.empty()) make_folder(folder_);
  for (const auto& [name, content] : files_)
    write_file_safely((std::filesystem::path(folder_) / name).string(), content);
  write_file_safely(path_, page_.text());
}

}  // namespace pulvis::report
