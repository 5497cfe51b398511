// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/keys.hpp"

// Words about keys that `explain` and the reference page share.
namespace pulvis::case_file {

/// "required", a default, or in words what holds without the key.
std::string describe_default(const Key& key);

/// Names of the tables at the top of a case file.
std::vector<std::string> top_level_tables();

}  // namespace pulvis::case_file
