// SPDX-License-Identifier: Apache-2.0
// A user's own case at several factors of coarse graining.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "case/reader.hpp"
#include "engine/base/failure.hpp"
#include "run/assemble.hpp"
#include "study/extrapolation.hpp"
#include "study/run_of_case.hpp"
#include "study/statistics.hpp"
#include "study/studies.hpp"
#include "sweep/record.hpp"

namespace pulvis::study {
namespace {

using validation::Compare;
using validation::Findings;

std::vector<Override> settings_of(const Options& options, const Case& c, double factor, int seed) {
  std::vector<Override> settings = options.settings;
  for (const Powder& p : c.powders)
    settings.push_back({fmt::format("powders.{}.coarse_graining", p.name), fmt::format("{:.17g}", factor)});
  settings.push_back({"seed", std::to_string(seed)});
  return settings;
}

Json to_json(const std::vector<Override>& settings) {
  Json list = Json::array();
  for (const Override& o : settings) list.push_back({o.key, o.value});
  return list;
}

std::vector<Override> from_json(const Json& list) {
  std::vector<Override> settings;
  for (const Json& o : list) settings.push_back({o.at(0), o.at(1)});
  return settings;
}

std::vector<double> factors_of(const Options& options) {
  std::vector<double> factors = options.factors;
  std::sort(factors.begin(), factors.end());
  if (factors.size() < 2 || std::adjacent_find(factors.begin(), factors.end()) != factors.end())
    throw Failure(Exit::usage,
                  "converge needs two different factors at least: --factors 8,6,4; with three, the order of "
                  "convergence can be seen");
  return factors;
}

std::vector<Point> points(const Options& options) {
  const Case c = read_case(options.case_file, options.settings);
  const int seeds = options.seeds > 0 ? options.seeds : options.quick ? 1 : 2;
  std::vector<Point> list;
  std::vector<sweep::Member> members;
  for (const double factor : factors_of(options))  // the finest takes longest
    for (int seed = 1; seed <= seeds; ++seed) {
      const std::vector<Override> settings = settings_of(options, c, factor, seed);
      if (seed == 1) assemble(read_case(options.case_file, settings));  // what is wrong with it is said now
      list.push_back({fmt::format("factor-{:g}-seed-{}", factor, seed), {}});
      members.push_back({list.back().name, options.case_file, {}, settings});
    }
  const std::vector<sweep::RecordedRun> record = sweep::record_of(members);
  for (std::size_t k = 0; k < list.size(); ++k)
    list[k].settings = {{"case", record[k].case_file},
                        {"factor", factors_of(options)[k / static_cast<std::size_t>(seeds)]},
                        {"settings", to_json(members[k].settings)},
                        {"checksum", record[k].checksum}};
  return list;
}

Json compute(const Work& work) {
  const Json result = run_of_case(work, work.settings.at("case"), from_json(work.settings.at("settings")));
  return {{"measures", result.at("measures")},
          {"parcels", result.at("particles")},
          {"seconds", result.at("stepping_time_s")}};
}

/// Measures of single parcels change with their size by definition: what grains would have is no limit of theirs.
bool is_of_parcels(const std::string& name) { return name == "fill_count" || name == "contact_force_mean"; }

/// Value and unit of each measure by factor: what every run has.
struct Values {
  std::string unit;
  std::map<double, std::vector<double>> by_factor;
};

std::vector<std::pair<std::string, Values>> values_of(const std::vector<Done>& all) {
  std::vector<std::pair<std::string, Values>> list;
  for (const auto& [name, first] : all.front().result.at("measures").items()) {
    if (is_of_parcels(name)) continue;
    Values values{first.at("unit"), {}};
    bool complete = true;
    for (const Done& done : all) {
      const Json& measures = done.result.at("measures");
      complete = complete && measures.contains(name) && measures.at(name).at("value").is_number();
      if (complete)
        values.by_factor[done.point.settings.at("factor")].push_back(measures.at(name).at("value"));
    }
    if (complete) list.emplace_back(name, std::move(values));
  }
  return list;
}

bool is_plain(const std::string& unit) { return unit.empty() || unit == "1"; }

Figure figure_of(const std::string& name, const Values& values, const Extrapolation& e) {
  Figure figure;
  figure.name = "converge-" + name;
  std::replace(figure.name.begin(), figure.name.end(), '_', '-');
  figure.title = name + " against the factor of coarse graining";
  figure.x_label = "factor of coarse graining";
  figure.y_label = is_plain(values.unit) ? name : fmt::format("{} ({})", name, values.unit);
  Curve runs{"runs", {}, {}, true},
      line{fmt::format("order {:.2g}, {}", e.order, e.order_observed ? "observed" : "assumed"), {}, {}};
  const double coarsest = values.by_factor.rbegin()->first;
  for (const auto& [factor, list] : values.by_factor)
    for (const double value : list) runs.x.push_back(factor), runs.y.push_back(value);
  for (int k = 0; k <= 50; ++k) {
    const double alpha = 1.0 + (coarsest - 1.0) * k / 50.0;
    line.x.push_back(alpha);
    line.y.push_back(e.value + e.growth * (std::pow(alpha, e.order) - 1.0));
  }
  figure.curves = {runs, line};
  return figure;
}

void conclude(const std::vector<Done>& all, Findings& f) {
  for (const auto& [name, values] : values_of(all)) {
    std::vector<Sample> samples;
    for (const auto& [factor, list] : values.by_factor)
      samples.push_back({factor, mean_of(list), standard_error_of(list)});
    const Extrapolation e = extrapolate(samples);
    const std::string unit = is_plain(values.unit) ? "" : fmt::format(" ({})", values.unit);
    f.compare(fmt::format("{}{} of grains; deviation: estimated error", name, unit),
              fmt::format(
                  "the mean at factor {:g}; order {:.2g} {}, safety factor {:g}, scatter of the seeds {:.2g}",
                  samples.front().factor, e.order, e.order_observed ? "observed" : "assumed",
                  e.order_observed ? observed_safety : assumed_safety, e.scatter),
              samples.front().mean, e.value, Compare::absolute, {})
        .deviation = e.error();
    f.figure(figure_of(name, values, e));
  }
}

}  // namespace

Study converge() {
  return {"converge",
          "A case of yours at several factors, extrapolated to grains",
          "Each measure of the last phase is taken to change with the factor alpha as f(1) + C (alpha^p - "
          "1). The order p "
          "is that which the three finest factors show, if their differences stand out of the scatter of the "
          "seeds and p "
          "lies between 1/2 and 3 (Celik et al. 2008); else 1. Each row has the measure extrapolated to real "
          "grains, that "
          "at the finest factor, and the estimated error of the first: 1.25 times their difference (3 times "
          "with an "
          "assumed order), and two standard errors from the seeds. Nothing is judged.",
          true,
          points,
          compute,
          conclude};
}

}  // namespace pulvis::study
