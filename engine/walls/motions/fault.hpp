// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <initializer_list>
#include <optional>
#include <string>

#include "engine/math/vec3.hpp"

namespace pulvis::motions {

/// What is wrong with a motion, in words that follow its name and a colon; nothing if all is well.
using Fault = std::optional<std::string>;

/// The first that is a fault.
Fault first_of(std::initializer_list<Fault> faults);

Fault unless_finite(const char* name, double value);
Fault unless_finite(const char* name, const Vec3& value);
/// Also unless finite. The unit is for the message, "" for none.
Fault unless_above_zero(const char* name, double value, const char* unit);
Fault unless_not_negative(const char* name, double value, const char* unit);
/// Unless its length is 1 to 1e-9.
Fault unless_unit_vector(const char* name, const Vec3& value);

}  // namespace pulvis::motions
