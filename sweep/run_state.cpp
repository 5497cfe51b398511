// SPDX-License-Identifier: Apache-2.0
#include "sweep/run_state.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace pulvis::sweep {

namespace fs = std::filesystem;

nlohmann::ordered_json result_in(const std::string& folder) {
  std::ifstream file(folder + "/result.json");
  auto result = nlohmann::ordered_json::parse(file, nullptr, false);
  return result.is_object() ? result : nlohmann::ordered_json::object();
}

Standing standing_of(const std::string& folder) {
  std::error_code none;
  const auto begin = [&](const std::string& name) { return fs::directory_iterator(folder + name, none); };
  const auto result = result_in(folder);
  if (result.contains("exit") && result["exit"] == 0) return Standing::complete;
  for (const auto& entry : begin("/checkpoints"))
    if (entry.path().extension() == ".pulvis") return Standing::resumable;
  return begin("") == fs::directory_iterator() ? Standing::new_run : Standing::broken_off;
}

std::string telling_line(const std::string& log, std::uint64_t start) {
  std::ifstream file(log, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(start));
  std::string last, own;
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    last = line;
    if (line.starts_with("pulvis: ")) own = line;
  }
  return own.empty() ? last : own;
}

}  // namespace pulvis::sweep
