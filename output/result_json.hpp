// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace pulvis {

/// Writes `content` to `path`, indented, completely or not at all. Numbers read back as the same bits and
/// keys keep their order. Throws Failure(Exit::io) if it cannot be written and Failure(Exit::internal_check)
/// naming the entry if a number is NaN or infinite: JSON has no such numbers, and `null` would hide them.
void write_json(const std::string& path, const nlohmann::ordered_json& content);

}  // namespace pulvis
