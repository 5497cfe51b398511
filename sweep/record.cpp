// SPDX-License-Identifier: Apache-2.0
#include "sweep/record.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "case/reader.hpp"
#include "engine/base/failure.hpp"
#include "output/checksum.hpp"
#include "output/result_json.hpp"
#include "run/case_keys.hpp"

namespace pulvis::sweep {
namespace {

using Json = nlohmann::ordered_json;

std::string checksum_of_keys(const Case& c) {
  std::string text;
  for (const CaseKey& k : deciding_keys(c)) text += k.key + "=" + k.meaning + "\n";
  return fmt::format("{:016x}", checksum_of(std::as_bytes(std::span(text.data(), text.size()))));
}

Json to_json(const RecordedRun& run) {
  Json varied = Json::object();
  for (const Override& o : run.varied) varied[o.key] = o.value;
  return {{"name", run.name}, {"case", run.case_file}, {"varied", varied}, {"checksum", run.checksum}};
}

}  // namespace

std::vector<RecordedRun> record_of(const std::vector<Member>& members) {
  std::vector<RecordedRun> runs;
  for (const Member& member : members) {
    try {
      const Case c = read_case(member.case_file, member.settings);
      runs.push_back({member.name, std::filesystem::absolute(member.case_file).lexically_normal().string(),
                      member.varied, checksum_of_keys(c)});
    } catch (const Failure& failure) {
      throw Failure(failure.code(),
                    fmt::format("{}\nof the run {}; nothing has been started", failure.what(), member.name));
    }
  }
  return runs;
}

void write_record(const std::string& file, const std::vector<RecordedRun>& runs) {
  Json list = Json::array();
  for (const RecordedRun& run : runs) list.push_back(to_json(run));
  write_json(file, {{"version", PULVIS_VERSION}, {"runs", list}});
}

std::vector<RecordedRun> read_record(const std::string& file) {
  std::ifstream stream(file);
  try {
    std::vector<RecordedRun> runs;
    const Json record = Json::parse(stream);
    for (const Json& run : record.at("runs")) {
      runs.push_back({run.at("name"), run.at("case"), {}, run.at("checksum")});
      for (const auto& [key, value] : run.at("varied").items()) runs.back().varied.push_back({key, value});
    }
    return runs;
  } catch (const Json::exception& error) {
    throw Failure(Exit::bad_input,
                  fmt::format("{}: is no record of a sweep: {}; choose another --out", file, error.what()));
  }
}

std::vector<std::string> differences(const std::vector<RecordedRun>& before,
                                     const std::vector<RecordedRun>& now) {
  std::map<std::string, const RecordedRun*> old;
  for (const RecordedRun& run : before) old[run.name] = &run;
  std::vector<std::string> lines;
  for (const RecordedRun& run : now) {
    const auto at = old.find(run.name);
    if (at == old.end())
      lines.push_back(fmt::format("{} is not in it", run.name));
    else if (at->second->checksum != run.checksum)
      lines.push_back(fmt::format("{} is another there: {} or what it is run with has changed", run.name,
                                  at->second->case_file));
    if (at != old.end()) old.erase(at);
  }
  for (const RecordedRun& run : before)
    if (old.contains(run.name)) lines.push_back(fmt::format("{} is in it, and not asked for now", run.name));
  return lines;
}

}  // namespace pulvis::sweep
