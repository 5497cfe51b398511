// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pulvis::study {

/// A file of cases/coarse-graining, which is part of the program.
struct CaseText {
  std::string_view name, text;
};
const std::vector<CaseText>& case_texts();

/// Writes all of them into `folder`, which is there, for they extend each other; returns the path of one. Throws
/// Failure(Exit::io).
std::string written_case(const std::string& folder, const std::string& name);

}  // namespace pulvis::study
