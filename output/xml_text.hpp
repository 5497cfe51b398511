// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace pulvis {

/// `text` as it may stand in an XML attribute between double quotes.
std::string xml_escape(std::string_view text);

}  // namespace pulvis
