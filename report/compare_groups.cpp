// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "report/compare.hpp"
#include "report/quantity_text.hpp"
#include "report/result_tables.hpp"

namespace pulvis::report {
namespace {

constexpr double rounding = 1e-12;  // what sums of equal numbers may be off by

/// What decides the course of a run, besides chance.
std::string identity_of(const RunData& run, std::size_t place) {
  if (run.keys.empty()) return fmt::format("run {}", place);
  std::string text;
  for (const Key& k : run.keys)
    if (k.name != "seed" && k.name != "title" && !k.name.starts_with("output."))
      text += fmt::format("{}={}\n", k.name, k.value);
  return text;
}

std::string mean_text(const Statistic& s, std::size_t runs, const DisplayUnit& unit) {
  if (s.count == 0) return "-";
  std::string text = fmt::format("{:.4g}", s.mean * unit.factor);
  if (std::isfinite(s.deviation)) text += fmt::format(" ± {:.2g}", s.deviation * unit.factor);
  return s.count == runs ? text : text + fmt::format(" (of {} only)", s.count);
}

std::string verdict_text(const Verdict& v, const DisplayUnit& unit) {
  if (!v.judged) return "not judged: too few seeds";
  if (v.error == 0.0) return v.difference == 0.0 ? "no difference" : "differs; the seeds do not scatter";
  return fmt::format("{}: {:+.3g}, {:.2g} standard errors (limit {:.3g})",
                     v.beyond ? "beyond the scatter of the seeds" : "within the scatter of the seeds",
                     v.difference * unit.factor, std::abs(v.difference) / v.error, v.limit);
}

}  // namespace

std::vector<Group> groups_of(const std::vector<RunData>& runs) {
  std::map<std::string, std::size_t> known;
  std::vector<Group> groups;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto [at, is_new] = known.emplace(identity_of(runs[k], k), groups.size());
    if (is_new) groups.push_back({fmt::format("like {}", runs[k].label), {}});
    groups[at->second].runs.push_back(k);
  }
  for (Group& g : groups)
    if (g.runs.size() == 1) g.label = runs[g.runs.front()].label;
  return groups;
}

Statistic statistic_of(const std::vector<double>& values) {
  Statistic s;
  double sum = 0.0, squares = 0.0;
  for (const double v : values)
    if (std::isfinite(v)) sum += v, ++s.count;
  if (s.count == 0)
    return {0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  s.mean = sum / static_cast<double>(s.count);
  for (const double v : values)
    if (std::isfinite(v)) squares += (v - s.mean) * (v - s.mean);
  s.deviation = s.count > 1 ? std::sqrt(squares / static_cast<double>(s.count - 1))
                            : std::numeric_limits<double>::quiet_NaN();
  if (s.deviation <= rounding * std::abs(s.mean)) s.deviation = 0.0;
  return s;
}

double student_limit(std::size_t degrees_of_freedom) {
  constexpr std::array limits{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                              2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                              2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
  if (degrees_of_freedom == 0) return std::numeric_limits<double>::infinity();
  return limits[std::min(degrees_of_freedom, limits.size()) - 1];
}

Verdict compare_means(const Statistic& first, const Statistic& second) {
  Verdict v;
  if (first.count == 0 || second.count == 0 || first.count + second.count < 3) return v;
  const double n1 = static_cast<double>(first.count), n2 = static_cast<double>(second.count);
  v.difference = second.mean - first.mean;
  if (std::abs(v.difference) <= rounding * std::abs(first.mean)) v.difference = 0.0;
  const auto square_of_error = [](const Statistic& s, double n) { return s.deviation * s.deviation / n; };
  double freedom = n1 + n2 - 2.0;
  if (first.count > 1 && second.count > 1) {
    const double e1 = square_of_error(first, n1), e2 = square_of_error(second, n2);
    v.error = std::sqrt(e1 + e2);
    if (const double share = e1 / (e1 + e2); std::isfinite(share))
      freedom = 1.0 / (share * share / (n1 - 1.0) + (1.0 - share) * (1.0 - share) / (n2 - 1.0));
  } else {  // the one run of a group may lie as far off as those of the other do
    const Statistic& many = first.count > 1 ? first : second;
    v.error = many.deviation * std::sqrt(1.0 / n1 + 1.0 / n2);
  }
  v.limit = student_limit(static_cast<std::size_t>(freedom + 1e-9));
  v.judged = true;
  v.beyond = std::abs(v.difference) > v.limit * v.error;
  return v;
}

namespace {

/// Runs of a group that say something of chance, and why others do not.
struct Sample {
  std::vector<std::size_t> runs;
  std::vector<std::string> left_out;
};

/// Complete runs that ended in the same phase, one of each seed: what is the same by nature is no second sample.
Sample sample_of(const Group& group, const std::vector<RunData>& runs,
                 const std::vector<const PhaseData*>& last) {
  Sample sample;
  std::set<std::string> seeds;
  for (const std::size_t k : group.runs) {
    const Key* seed = runs[k].key("seed");
    if (!runs[k].ended || last[k] == nullptr)
      sample.left_out.push_back(runs[k].label + " has not ended");
    else if (!sample.runs.empty() && last[k]->name != last[sample.runs.front()]->name)
      sample.left_out.push_back(fmt::format("{} ended in phase {}", runs[k].label, last[k]->name));
    else if (seed != nullptr && !seeds.insert(seed->value).second)
      sample.left_out.push_back(fmt::format("{} repeats seed {}", runs[k].label, seed->value));
    else
      sample.runs.push_back(k);
  }
  return sample;
}

}  // namespace

void add_groups(HtmlPage& page, const std::vector<RunData>& runs, const std::vector<const PhaseData*>& last) {
  const std::vector<Group> groups = groups_of(runs);
  if (groups.size() == runs.size()) return;
  page.heading("Chance: runs that differ only in their seed");
  std::vector<std::string> words, header{"measure", "unit"};
  std::vector<Sample> samples;
  for (const Group& g : groups) {
    samples.push_back(sample_of(g, runs, last));
    const Sample& s = samples.back();
    std::string names;
    for (const std::size_t k : s.runs) names += (names.empty() ? "" : ", ") + runs[k].label;
    words.push_back(fmt::format("{}: {} run{} ({}){}{}", g.label, s.runs.size(),
                                s.runs.size() == 1 ? "" : "s", names,
                                s.left_out.empty() ? "" : "; left out: ", fmt::join(s.left_out, ", ")));
    header.push_back(g.label);
    if (&g != &groups.front()) header.push_back(fmt::format("{} against {}", g.label, groups.front().label));
  }
  page.list(words);
  page.paragraph(
      "Mean ± standard deviation between seeds. A difference of means is called beyond the scatter of the "
      "seeds "
      "if it exceeds the 97.5 % point of Student's distribution times the standard error of the difference. "
      "Of twenty "
      "measures that do not really differ, one is so by chance; and with few seeds a real difference "
      "may stay hidden.");
  std::vector<HtmlPage::Row> rows;
  for (const Scalar& m : measures_of(last)) {
    std::vector<std::vector<double>> values(groups.size());
    double largest = 0.0;
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::size_t k : samples[g].runs) values[g].push_back(last[k]->measure(m.name));
    for (const auto& v : values) largest = std::max(largest, largest_of(v));
    const DisplayUnit unit = display_unit(largest, m.unit);
    std::vector<std::string> cells{measure_words(m.name), unit.name};
    for (std::size_t g = 0; g < groups.size(); ++g) {
      cells.push_back(mean_text(statistic_of(values[g]), samples[g].runs.size(), unit));
      if (g > 0)
        cells.push_back(verdict_text(compare_means(statistic_of(values[0]), statistic_of(values[g])), unit));
    }
    rows.push_back({std::move(cells)});
  }
  page.table(header, rows);
}

}  // namespace pulvis::report
