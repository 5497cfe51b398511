// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/fault.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pulvis::motions {
namespace {

std::string with_unit(double value, const char* unit) {
  return *unit == '\0' ? fmt::format("{:g}", value) : fmt::format("{:g} {}", value, unit);
}

}  // namespace

Fault first_of(std::initializer_list<Fault> faults) {
  for (const Fault& fault : faults)
    if (fault) return fault;
  return std::nullopt;
}

Fault unless_finite(const char* name, double value) {
  if (std::isfinite(value)) return std::nullopt;
  return fmt::format("the {} is not a finite number", name);
}

Fault unless_finite(const char* name, const Vec3& value) {
  if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) return std::nullopt;
  return fmt::format("the {} ({:g}, {:g}, {:g}) has a component that is not a finite number", name, value.x,
                     value.y, value.z);
}

Fault unless_above_zero(const char* name, double value, const char* unit) {
  if (Fault fault = unless_finite(name, value)) return fault;
  if (value > 0.0) return std::nullopt;
  return fmt::format("the {} must be above 0, but is {}", name, with_unit(value, unit));
}

Fault unless_not_negative(const char* name, double value, const char* unit) {
  if (Fault fault = unless_finite(name, value)) return fault;
  if (value >= 0.0) return std::nullopt;
  return fmt::format("the {} must not be negative, but is {}", name, with_unit(value, unit));
}

Fault unless_unit_vector(const char* name, const Vec3& value) {
  if (Fault fault = unless_finite(name, value)) return fault;
  if (magnitude(norm(value) - 1.0) <= 1e-9) return std::nullopt;
  return fmt::format("the {} ({:g}, {:g}, {:g}) is not of length 1", name, value.x, value.y, value.z);
}

}  // namespace pulvis::motions
