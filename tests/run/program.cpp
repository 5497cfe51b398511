// SPDX-License-Identifier: Apache-2.0
#include "tests/run/program.hpp"

namespace pulvis::tests {

std::string program_path() { return PULVIS_PROGRAM; }
std::string source_folder() { return PULVIS_SOURCE_DIR; }

}  // namespace pulvis::tests
