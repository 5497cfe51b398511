// SPDX-License-Identifier: Apache-2.0
#include "output/vtk_blocks.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace pulvis {
namespace {

std::string encode(const std::string& bytes, std::size_t block_size) {
  return encode_vtk_blocks(bytes.size(), block_size, [&](std::size_t offset, std::span<std::byte> block) {
    std::memcpy(block.data(), bytes.data() + offset, block.size());
  });
}

std::vector<std::uint64_t> header_of(const std::string& encoded) {
  std::uint64_t blocks = 0;
  std::memcpy(&blocks, encoded.data(), sizeof(blocks));
  std::vector<std::uint64_t> header(3 + blocks);
  std::memcpy(header.data(), encoded.data(), header.size() * sizeof(std::uint64_t));
  return header;
}

// Undoes the encoding by the rules of the format, with zlib alone.
std::string decode(const std::string& encoded) {
  const auto header = header_of(encoded);
  std::size_t next = header.size() * sizeof(std::uint64_t);
  std::string bytes;
  for (std::size_t i = 0; i < header[0]; ++i) {
    const bool partial = i + 1 == header[0] && header[2] != 0;
    std::string block(partial ? header[2] : header[1], '\0');
    uLongf length = block.size();
    EXPECT_EQ(::uncompress(reinterpret_cast<Bytef*>(block.data()), &length,
                           reinterpret_cast<const Bytef*>(encoded.data() + next), header[3 + i]),
              Z_OK);
    EXPECT_EQ(length, block.size());
    bytes += block;
    next += header[3 + i];
  }
  EXPECT_EQ(next, encoded.size());
  return bytes;
}

std::string some_bytes(std::size_t size) {
  std::string bytes(size, '\0');
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * i % 251);
  return bytes;
}

TEST(VtkBlocks, CutsAnArrayIntoBlocksWithAPartialLastOne) {
  const auto header = header_of(encode(some_bytes(1000), 256));
  ASSERT_EQ(header.size(), 3u + 4u);
  EXPECT_EQ(header[0], 4u);
  EXPECT_EQ(header[1], 256u);
  EXPECT_EQ(header[2], 1000u - 3u * 256u);
}

TEST(VtkBlocks, SaysZeroForALastBlockThatIsFull) {
  const auto header = header_of(encode(some_bytes(512), 256));
  EXPECT_EQ(header[0], 2u);
  EXPECT_EQ(header[2], 0u);
}

TEST(VtkBlocks, HasNoBlocksForAnEmptyArray) {
  const auto encoded = encode("", 256);
  EXPECT_EQ(encoded.size(), 3 * sizeof(std::uint64_t));
  EXPECT_EQ(header_of(encoded)[0], 0u);
}

TEST(VtkBlocks, GiveBackAllBytes) {
  for (const std::size_t size : {1u, 255u, 256u, 257u, 512u, 100'000u})
    EXPECT_EQ(decode(encode(some_bytes(size), 256)), some_bytes(size)) << size;
}

}  // namespace
}  // namespace pulvis
