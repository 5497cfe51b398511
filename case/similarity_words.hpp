// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace pulvis {

/// What a similarity of parcels to grains (contact.similarity) keeps of the grains, and what it does not: lists for
/// people.
std::string what_is_kept(const std::string& similarity);
std::string what_is_not_kept(const std::string& similarity);

}  // namespace pulvis
