// SPDX-License-Identifier: Apache-2.0
#include "output/safe_file.hpp"
#include "study/cases.hpp"

namespace pulvis::study {

std::string written_case(const std::string& folder, const std::string& name) {
  for (const CaseText& c : case_texts()) write_file_safely(folder + "/" + std::string(c.name), c.text);
  return folder + "/" + name;
}

}  // namespace pulvis::study
