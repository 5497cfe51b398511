// SPDX-License-Identifier: Apache-2.0
#include "output/checksum.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <filesystem>
#include <fstream>

#include "engine/base/failure.hpp"

namespace pulvis {

std::uint64_t checksum_of(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::vector<std::byte> bytes_of_file(const std::string& path) {
  // A folder opens like a file, and a device may never end.
  std::error_code error;
  const bool regular = std::filesystem::is_regular_file(path, error);
  const std::uintmax_t size = regular ? std::filesystem::file_size(path, error) : 0;
  if (!regular || error) throw Failure(Exit::bad_input, fmt::format("{}: there is no such file", path));
  std::vector<std::byte> bytes(size);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) throw Failure(Exit::bad_input, fmt::format("{}: cannot be read", path));
  return bytes;
}

std::string checksum_of_file(const std::string& path) {
  return fmt::format("{:016x}", checksum_of(bytes_of_file(path)));
}

}  // namespace pulvis
