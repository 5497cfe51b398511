// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/insertion/source.hpp"

namespace pulvis {

/// What of a source cannot be done, as messages with their remedy: a region or sieve too narrow for its
/// parcels, a pack too full. `key` says which key of the source each is about, if not the source itself.
struct SourceProblem {
  std::string key, message;
};
std::vector<SourceProblem> source_problems(const Source& source, const SourceModel& model,
                                           double expected_parcels);

/// The mass rate, kg/s, that a rain keeps by and large: its region emptied at the speed of its parcels, over
/// and over, as full as places are found quickly. Of equal parcels it is between 0.9 and 2 times this.
double highest_rain_rate(const SourceModel& rain, const Vec3& gravity);

/// A warning if a rain is to give more than that; else empty.
std::string rain_warning(const SourceModel& rain, const Vec3& gravity);

}  // namespace pulvis
