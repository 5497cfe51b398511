// SPDX-License-Identifier: Apache-2.0
#include "output/chunk_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "engine/base/archive.hpp"
#include "engine/base/failure.hpp"
#include "output/checksum.hpp"
#include "output/safe_file.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t magic = 0x504b4843'534c5550;  // "PULSCHKP" read as little-endian text
constexpr std::size_t checksum_size = sizeof(std::uint64_t);

struct ChunkEntry {
  std::string name;
  std::uint64_t size = 0, checksum = 0;
};
template <class Archive>
void fields(Archive& archive, ChunkEntry& entry) {
  archive(entry.name, entry.size, entry.checksum);
}

/// What stands before the bytes of the chunks, followed by its own checksum.
struct Contents {
  std::uint64_t magic = pulvis::magic;
  std::uint64_t size = 0;  ///< of the whole file
  std::uint32_t version = 0;
  std::vector<ChunkEntry> chunks;
};
template <class Archive>
void fields(Archive& archive, Contents& contents) {
  archive(contents.magic, contents.size, contents.version, contents.chunks);
}

}  // namespace

void write_chunk_file(const std::string& path, std::uint32_t version, std::span<const Chunk> chunks,
                      FileCalls calls) {
  Contents contents;
  contents.version = version;
  for (const Chunk& chunk : chunks)
    contents.chunks.push_back({chunk.name, chunk.bytes.size(), checksum_of(chunk.bytes)});
  contents.size = to_bytes(contents).size() + checksum_size;
  for (const Chunk& chunk : chunks) contents.size += chunk.bytes.size();

  SafeFile file(path, calls);
  const std::vector<std::byte> head = to_bytes(contents);
  const std::uint64_t checksum = checksum_of(head);
  file.write(head.data(), head.size());
  file.write(&checksum, sizeof checksum);
  for (const Chunk& chunk : chunks) file.write(chunk.bytes.data(), chunk.bytes.size());
  file.commit();
}

ChunkFile::ChunkFile(const std::string& path, std::uint32_t version)
    : ChunkFile(bytes_of_file(path), path, version) {}

ChunkFile::ChunkFile(std::vector<std::byte> bytes, const std::string& name, std::uint32_t version)
    : name_(name), bytes_(std::move(bytes)) {
  find_chunks(version);
}

void ChunkFile::fail(const std::string& why) const {
  throw Failure(Exit::bad_input, fmt::format("{}: {}", name_, why));
}

void ChunkFile::find_chunks(std::uint32_t version) {
  Contents contents;
  std::uint64_t checksum = 0;
  std::span<const std::byte> rest(bytes_);
  try {
    ByteReader reader(rest);
    reader(contents, checksum);
  } catch (const Failure&) {
    fail("its table of contents is damaged or cut short");
  }
  if (contents.magic != magic) fail("it is no file of this kind, or its beginning is damaged");
  const std::size_t head = to_bytes(contents).size();
  if (checksum != checksum_of(rest.first(head))) fail("its table of contents is damaged");
  if (contents.version != version)
    fail(fmt::format("it is of version {}, and this program reads version {}", contents.version, version));
  if (contents.size != rest.size())
    fail(fmt::format("it has {} bytes where {} were written", rest.size(), contents.size));
  rest = rest.subspan(head + checksum_size);
  for (const ChunkEntry& entry : contents.chunks) {
    if (entry.size > rest.size()) fail("its chunks are longer than the file");
    const auto bytes = rest.first(entry.size);
    if (entry.checksum != checksum_of(bytes)) fail(fmt::format("its chunk {} is damaged", entry.name));
    chunks_.emplace_back(entry.name, bytes);
    rest = rest.subspan(entry.size);
  }
}

std::span<const std::byte> ChunkFile::operator[](std::string_view chunk) const {
  for (const auto& [name, bytes] : chunks_)
    if (name == chunk) return bytes;
  fail(fmt::format("it has no chunk {}", chunk));
}

}  // namespace pulvis
