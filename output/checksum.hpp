// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pulvis {

/// XXH3, 64 bits.
std::uint64_t checksum_of(std::span<const std::byte> bytes);

/// What is in a file. Throws Failure(Exit::bad_input) if it cannot be read.
std::vector<std::byte> bytes_of_file(const std::string& path);

/// The checksum of what is in a file, as text; errors as bytes_of_file.
std::string checksum_of_file(const std::string& path);

}  // namespace pulvis
