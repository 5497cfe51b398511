// SPDX-License-Identifier: Apache-2.0
#include "study/record.hpp"

#include <fmt/format.h>

#include <fstream>

#include "engine/base/failure.hpp"
#include "output/result_json.hpp"

namespace pulvis::study {

std::string record_file(const std::string& out) { return out + "/points.json"; }

std::string point_folder(const std::string& out, const Point& point) { return out + "/points/" + point.name; }

void write_record(const std::string& out, const Record& record) {
  Json points = Json::array();
  for (const Point& p : record.points) points.push_back({{"name", p.name}, {"settings", p.settings}});
  write_json(record_file(out), {{"version", PULVIS_VERSION}, {"study", record.study}, {"points", points}});
}

Record read_record(const std::string& out) {
  std::ifstream stream(record_file(out));
  try {
    const Json content = Json::parse(stream);
    Record record{content.at("study"), {}};
    for (const Json& p : content.at("points")) record.points.push_back({p.at("name"), p.at("settings")});
    return record;
  } catch (const Json::exception& error) {
    throw Failure(Exit::bad_input, fmt::format("{}: is no record of a study: {}; choose another --out",
                                               record_file(out), error.what()));
  }
}

void write_result(const std::string& out, const Point& point, double seconds, const Json& result) {
  // "exit" is what a run's result has, too: 0 says complete.
  write_json(point_folder(out, point) + "/result.json",
             {{"exit", 0}, {"version", PULVIS_VERSION}, {"seconds", seconds}, {"result", result}});
}

Json read_result(const std::string& out, const Point& point) {
  const std::string file = point_folder(out, point) + "/result.json";
  std::ifstream stream(file);
  try {
    return Json::parse(stream).at("result");
  } catch (const Json::exception& error) {
    throw Failure(Exit::bad_input, fmt::format("{}: is no result of a point: {}; remove its folder and "
                                               "give the same command again",
                                               file, error.what()));
  }
}

}  // namespace pulvis::study
