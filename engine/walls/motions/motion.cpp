// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/motion.hpp"

#include <fmt/format.h>

namespace pulvis::motions {

Rigid displacement(const Motion& motion, double since) {
  const double t = least(since, motion.end) - motion.start;
  if (!(t > 0.0)) return {};
  return std::visit([&](const auto& kind) { return kind.displacement(t); }, motion.kind);
}

Peaks peaks(const Motion& motion) {
  return std::visit([](const auto& kind) { return kind.peaks(); }, motion.kind);
}

std::optional<double> cycle(const Motion& motion) {
  return std::visit([](const auto& kind) { return kind.cycle(); }, motion.kind);
}

std::optional<double> duration(const Motion& motion) {
  const auto own = std::visit([](const auto& kind) { return kind.duration(); }, motion.kind);
  const double until = own ? least(motion.start + *own, motion.end) : motion.end;
  if (until == std::numeric_limits<double>::infinity()) return std::nullopt;
  return until;
}

Fault fault(const Motion& motion) {
  if (Fault fault = unless_not_negative("start", motion.start, "s")) return fault;
  if (!(motion.end > motion.start))
    return fmt::format("the end, {:g} s, must be after the start, {:g} s", motion.end, motion.start);
  return std::visit([](const auto& kind) { return kind.fault(); }, motion.kind);
}

}  // namespace pulvis::motions
