// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace pulvis {

/// The bytes of one data array as VTK's XML formats want them after `compressor="vtkZLibDataCompressor"`
/// with UInt64 headers: number of blocks, bytes of a full block, bytes of the last block (0 if it is full),
/// compressed bytes of each block, then the blocks.
/// The `size` bytes come block by block from `read(offset, block)`, so that no second copy of a large array
/// is needed. `block_size` must be a multiple of the element size.
std::string encode_vtk_blocks(
    std::size_t size, std::size_t block_size,
    const std::function<void(std::size_t offset, std::span<std::byte> block)>& read);

}  // namespace pulvis
