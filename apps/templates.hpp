// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>
#include <vector>

namespace pulvis {

/// A case to start from: `pulvis new NAME DIR`.
struct Template {
  std::string_view name, help, text;
};
const std::vector<Template>& templates();

}  // namespace pulvis
