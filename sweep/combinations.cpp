// SPDX-License-Identifier: Apache-2.0
#include "sweep/combinations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/base/failure.hpp"

namespace pulvis::sweep {
namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// At commas that are in no quotes and no brackets.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts{""};
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '[' || c == '{')
      ++depth;
    else if (c == ']' || c == '}')
      --depth;
    if (c == ',' && quote == 0 && depth <= 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

// What may stand in the name of a folder on any system, without blanks.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter || c == '_' || c == '.' || c == '+' || c == '-')
      result += c;
    else if (!result.empty() && result.back() != '-')
      result += '-';
  }
  constexpr std::size_t longest = 40;
  result.resize(std::min(result.size(), longest));
  while (result.ends_with('-')) result.pop_back();
  return result;
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

// "sine-5hz"; with its folder before it where another case is called the same.
std::vector<std::string> names_of(const std::vector<std::string>& cases) {
  std::vector<std::string> stems, names;
  for (const std::string& file : cases) {
    stems.push_back(plain(fs::path(file).stem().string()));
    if (stems.back().empty()) stems.back() = "case";  // of other letters only
  }
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const bool alone = std::count(stems.begin(), stems.end(), stems[k]) == 1;
    const std::string folder = plain(fs::absolute(cases[k]).parent_path().filename().string());
    names.push_back(alone || folder.empty() ? stems[k] : folder + "-" + stems[k]);
  }
  return names;
}

void refuse_twice(const std::vector<std::string>& list, const char* what) {
  std::set<std::string> seen;
  for (const std::string& item : list)
    if (!seen.insert(item).second)
      throw Failure(Exit::usage, fmt::format("{} {} is given twice", what, item));
}

void check(const Choice& choice) {
  if (choice.cases.empty()) throw Failure(Exit::usage, "no case is given");
  std::vector<std::string> files, keys;
  for (const std::string& file : choice.cases)
    files.push_back(fs::absolute(file).lexically_normal().string());
  refuse_twice(files, "the case");
  for (const Factor& factor : choice.factors) keys.push_back(factor.key);
  if (choice.seeds > 0) keys.push_back("seed");
  for (const Override& common : choice.common)
    if (std::find(keys.begin(), keys.end(), common.key) != keys.end())
      throw Failure(Exit::usage, fmt::format("{} is varied, and set for all", common.key));
  refuse_twice(keys, "the key");
}

/// What each run of one case has of each factor and of the seeds; the seed changes last.
std::vector<std::vector<Override>> variations(const Choice& choice) {
  std::vector<Factor> factors = choice.factors;
  if (choice.seeds > 0) {
    factors.push_back({"seed", {}});
    for (int seed = 1; seed <= choice.seeds; ++seed) factors.back().values.push_back(std::to_string(seed));
  }
  std::vector<std::vector<Override>> all{{}};
  for (const Factor& factor : factors) {
    const std::vector<std::vector<Override>> before = std::move(all);
    all.clear();
    const bool is_seed = choice.seeds > 0 && &factor == &factors.back();
    const auto append = [&](const std::vector<Override>& start, const std::string& value) {
      all.push_back(start);
      all.back().push_back({factor.key, value});
    };
    if (is_seed)
      for (const std::string& value : factor.values)
        for (const auto& start : before) append(start, value);
    else
      for (const auto& start : before)
        for (const std::string& value : factor.values) append(start, value);
  }
  return all;
}

}  // namespace

Factor factor_from(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Failure(Exit::usage, fmt::format("--vary {}: expected key.path=value,value", text));
  Factor factor{text.substr(0, equals), split(text.substr(equals + 1))};
  for (const std::string& value : factor.values)
    if (value.empty()) throw Failure(Exit::usage, fmt::format("--vary {}: a value is empty", text));
  refuse_twice(factor.values, ("--vary " + factor.key + ": the value").c_str());
  return factor;
}

std::vector<Member> combinations(const Choice& choice) {
  check(choice);
  const std::vector<std::string> names = names_of(choice.cases);
  const auto varied = variations(choice);
  const std::size_t blocks = choice.seeds > 0 ? static_cast<std::size_t>(choice.seeds) : 1;
  const std::size_t of_block = varied.size() / blocks;
  std::set<std::string> taken{"comparison", "sweep"};  // what else lies in the folder of a sweep
  std::vector<Member> members;
  for (std::size_t block = 0; block < blocks; ++block)
    for (std::size_t k = 0; k < choice.cases.size(); ++k)
      for (std::size_t v = 0; v < of_block; ++v) {
        Member member{names[k], choice.cases[k], varied[block * of_block + v], choice.common};
        for (const Override& o : member.varied) {
          member.name += "-" + plain(last_part(o.key)) + "-" + plain(o.value);
          member.settings.push_back(o);
        }
        const std::string wish = member.name;
        for (int number = 2; !taken.insert(member.name).second; ++number)
          member.name = fmt::format("{}-{}", wish, number);
        members.push_back(std::move(member));
      }
  return members;
}

}  // namespace pulvis::sweep
