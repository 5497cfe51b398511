// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/file_calls.hpp"

// Files of named chunks of bytes, each with a checksum: docs/checkpoint-format.md.
namespace pulvis {

struct Chunk {
  std::string name;
  std::vector<std::byte> bytes;
};

/// Writes the chunks to `path`, completely or not at all. `version` is that of what the chunks hold.
/// Throws Failure(Exit::io) if it cannot be written.
void write_chunk_file(const std::string& path, std::uint32_t version, std::span<const Chunk> chunks,
                      FileCalls calls = FileCalls::system());

/// A file of chunks, read whole.
class ChunkFile {
 public:
  /// Throws Failure(Exit::bad_input), saying why, if it cannot be read, is of another version, is cut short,
  /// or has a bit that is not as it was written.
  ChunkFile(const std::string& path, std::uint32_t version);
  /// The same for bytes; `name` stands for the file in messages.
  ChunkFile(std::vector<std::byte> bytes, const std::string& name, std::uint32_t version);

  /// The bytes of a chunk; Failure(Exit::bad_input) if there is none of that name.
  std::span<const std::byte> operator[](std::string_view chunk) const;

 private:
  void find_chunks(std::uint32_t version);
  [[noreturn]] void fail(const std::string& why) const;

  std::string name_;
  std::vector<std::byte> bytes_;
  std::vector<std::pair<std::string, std::span<const std::byte>>> chunks_;
};

}  // namespace pulvis
