// SPDX-License-Identifier: Apache-2.0
#include "output/vtk_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace pulvis {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say byte_order=LittleEndian");

// Fastest: particle data is mostly noise, where higher levels take several times as long for a few per cent.
constexpr int level = 1;

void append_compressed(std::string& blocks, std::span<const std::byte> block) {
  uLongf length = ::compressBound(static_cast<uLong>(block.size()));
  const std::size_t start = blocks.size();
  blocks.resize(start + length);
  const int result =
      ::compress2(reinterpret_cast<Bytef*>(blocks.data() + start), &length,
                  reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()), level);
  if (result != Z_OK) throw std::bad_alloc();  // the buffer is large enough, so memory is all that can fail
  blocks.resize(start + length);
}

}  // namespace

std::string encode_vtk_blocks(std::size_t size, std::size_t block_size,
                              const std::function<void(std::size_t, std::span<std::byte>)>& read) {
  const std::size_t count = (size + block_size - 1) / block_size;
  std::vector<std::uint64_t> header{count, block_size, size % block_size};
  std::vector<std::byte> block(std::min(size, block_size));
  std::string blocks;
  for (std::size_t offset = 0; offset < size; offset += block_size) {
    const auto part = std::span(block).first(std::min(block_size, size - offset));
    read(offset, part);
    const std::size_t before = blocks.size();
    append_compressed(blocks, part);
    header.push_back(blocks.size() - before);
  }
  std::string encoded(header.size() * sizeof(std::uint64_t), '\0');
  std::memcpy(encoded.data(), header.data(), encoded.size());
  return encoded += blocks;
}

}  // namespace pulvis
