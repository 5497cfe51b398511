// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "study/study.hpp"

namespace pulvis::study {

/// OUT/points.json: which points a study in a folder has. What a point is computed from stands there, not on the
/// command line of its process.
struct Record {
  std::string study;
  std::vector<Point> points;
};

std::string record_file(const std::string& out);
/// Throws Failure(Exit::io).
void write_record(const std::string& out, const Record& record);
/// Throws Failure(Exit::bad_input) if there is none that can be read.
Record read_record(const std::string& out);

/// The folder of a point.
std::string point_folder(const std::string& out, const Point& point);
/// Writes a point's result.json, by which it counts as complete; throws Failure(Exit::internal_check) if a number is
/// not finite.
void write_result(const std::string& out, const Point& point, double seconds, const Json& result);
/// What write_result wrote. Throws Failure(Exit::bad_input) if that cannot be read.
Json read_result(const std::string& out, const Point& point);

}  // namespace pulvis::study
