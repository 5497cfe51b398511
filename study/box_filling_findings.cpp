// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "study/box_filling.hpp"
#include "study/statistics.hpp"

namespace pulvis::study {
namespace {

using validation::Compare;
using validation::Findings;

constexpr double strong_load = 3.0;  // overburden over the Rumpf strength from which on the profile is judged

/// All points of a study, to be asked by law, similarity and factor.
class Beds {
 public:
  explicit Beds(const std::vector<Done>& all) {
    for (const Done& done : all) {
      const Json& s = done.point.settings;
      beds_[{s.at("law"), s.at("similarity")}][s.at("factor")].push_back(&done.result);
      factors_.insert(s.at("factor").get<double>());
    }
  }

  const std::set<double>& factors() const { return factors_; }
  bool has(const std::string& law, const std::string& similarity) const {
    return beds_.contains({law, similarity});
  }
  const std::vector<const Json*>& of(const std::string& law, const std::string& similarity,
                                     double factor) const {
    return beds_.at({law, similarity}).at(factor);
  }
  std::vector<double> values(const std::string& law, const std::string& similarity, double factor,
                             const char* quantity) const {
    std::vector<double> list;
    for (const Json* bed : of(law, similarity, factor)) list.push_back(bed->at(quantity));
    return list;
  }

 private:
  std::map<std::pair<std::string, std::string>, std::map<double, std::vector<const Json*>>> beds_;
  std::set<double> factors_;
};

void judge_without_cohesion(const Beds& beds, Findings& f) {
  const double finest = *beds.factors().begin();
  for (const char* law : {"hertz", "hooke"})
    for (const double factor : beds.factors()) {
      if (factor == finest || !beds.has(law, "stress")) continue;
      for (const auto& [quantity, limit] : {std::pair{"porosity", 0.01}, {"coordination", 0.2}}) {
        const auto fine = beds.values(law, "stress", finest, quantity),
                   coarse = beds.values(law, "stress", factor, quantity);
        const Difference d = difference(fine, coarse);
        f.compare(fmt::format("{}, factor {:g}: {} (deviation with its 95 % interval of +-{:.2g})", law,
                              factor, quantity, d.half_width),
                  fmt::format("factor {:g}", finest), mean_of(fine), mean_of(coarse), Compare::absolute,
                  limit)
            .deviation = std::fabs(d.value) + d.half_width;
      }
    }
}

void judge_similarities(const Beds& beds, Findings& f) {
  for (const char* law : {"jkr", "sjkr2", "capillary"})
    for (const double factor : beds.factors())
      for (const auto& [dense, loose] : {std::pair{"none", "stress"}, {"stress", "bond"}}) {
        if (!beds.has(law, dense) || !beds.has(law, loose)) continue;
        const auto a = beds.values(law, dense, factor, "porosity"),
                   b = beds.values(law, loose, factor, "porosity");
        const Difference d = difference(a, b);
        f.compare(
            fmt::format(
                "{}, factor {:g}: porosity under {} less that under {} ({:.4f} - {:.4f}), in standard errors",
                law, factor, loose, dense, mean_of(b), mean_of(a)),
            "at least 3 apart", 3.0, d.value / d.standard_error, Compare::at_least, 0.0);
      }
}

/// Porosity of a bed where so much lies above (Pa), between the middles of its layers; nothing beyond them, in the
/// floor's layer and in the one that the surface cuts, which is partly empty.
std::optional<double> porosity_under(const Json& bed, double overburden) {
  const Json* above = nullptr;
  const double surface = bed.at("surface_m");
  for (auto layer = bed.at("layers").rbegin(); layer != bed.at("layers").rend(); ++layer) {
    if (layer->at("high_m").get<double>() > surface + 1e-9) continue;
    if (layer->at("low_m").get<double>() < end_layer - 1e-9) break;
    const double here = layer->at("overburden_Pa");
    if (here >= overburden) {
      if (above == nullptr) return {};
      const double before = above->at("overburden_Pa"), share = (overburden - before) / (here - before);
      return (1.0 - share) * above->at("porosity").get<double>() +
             share * layer->at("porosity").get<double>();
    }
    above = &*layer;
  }
  return {};
}

std::optional<double> mean_under(const std::vector<const Json*>& beds, double overburden) {
  std::vector<double> values;
  for (const Json* bed : beds)
    if (const auto value = porosity_under(*bed, overburden)) values.push_back(*value);
  if (values.size() < beds.size()) return {};
  return mean_of(values);
}

constexpr double load_step = 20.0, largest_load = 600.0;  // Pa: where profiles are compared

void judge_profiles(const Beds& beds, Findings& f) {
  const double finest = *beds.factors().begin();
  for (const char* law : {"jkr", "sjkr2", "capillary"})
    for (const double factor : beds.factors()) {
      if (factor == finest || !beds.has(law, "stress")) continue;
      const auto &fine = beds.of(law, "stress", finest), &coarse = beds.of(law, "stress", factor);
      const double pull = fine.front()->at("pull_of_grains_Pa");
      struct Worst {
        double fine = 0.0, coarse = 0.0, load = 0.0;
        bool seen = false;
      } below, above;
      for (double load = load_step; load < largest_load; load += load_step) {
        const auto a = mean_under(fine, load), b = mean_under(coarse, load);
        if (!a || !b) continue;
        const double strength = (1.0 - *a) / *a * pull;
        Worst& worst = load > strong_load * strength ? below : above;
        if (!worst.seen || std::fabs(*b - *a) > std::fabs(worst.coarse - worst.fine))
          worst = {*a, *b, load, true};
      }
      if (below.seen)
        f.compare(
            fmt::format("{}, factor {:g}: porosity under loads above 3 Rumpf strengths, worst at {:.0f} Pa",
                        law, factor, below.load),
            fmt::format("factor {:g} under the same load", finest), below.fine, below.coarse,
            Compare::absolute, 0.02);
      if (above.seen)
        f.compare(fmt::format("{}, factor {:g}: porosity under smaller loads, worst at {:.0f} Pa", law,
                              factor, above.load),
                  fmt::format("factor {:g} under the same load", finest), above.fine, above.coarse,
                  Compare::absolute, {});
    }
}

/// Slope of the logarithm of the cost of a simulated second over that of the factor.
void report_cost(const Beds& beds, Findings& f) {
  const double fine = *beds.factors().begin(), coarse = *beds.factors().rbegin();
  const auto cost = [&](double factor) {
    const Json& bed = *beds.of("hertz", "stress", factor).front();
    return bed.at("parcels").get<double>() * bed.at("steps").get<double>() /
           bed.at("simulated_time_s").get<double>();
  };
  const auto seconds = [&](double factor) {
    return mean_of(beds.values("hertz", "stress", factor, "seconds"));
  };
  const double span = std::log(coarse / fine);
  f.compare("hertz: power of the factor with which parcel-steps per simulated second go",
            "number ~ alpha^-3, step ~ alpha", -4.0, std::log(cost(coarse) / cost(fine)) / span,
            Compare::absolute, {});
  f.compare("hertz: power of the factor with which the time on the clock goes",
            "the same, on a machine by itself", -4.0, std::log(seconds(coarse) / seconds(fine)) / span,
            Compare::absolute, {});
}

Figure over_factors(const Beds& beds, const std::string& name, const char* quantity, const char* label,
                    const std::vector<std::pair<std::string, std::string>>& lines, const std::string& title) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.x_label = "factor of coarse graining";
  figure.y_label = label;
  for (const auto& [law, similarity] : lines) {
    if (!beds.has(law, similarity)) continue;
    Curve curve;
    curve.label = law == "hertz" || law == "hooke" ? law : law + ", " + similarity;
    for (const double factor : beds.factors()) {
      curve.x.push_back(factor);
      curve.y.push_back(mean_of(beds.values(law, similarity, factor, quantity)));
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

Figure profile(const Beds& beds, const std::string& law) {
  Figure figure;
  figure.name = "profile-" + law;
  figure.title = "Porosity under the weight above, " + law + ", stress similarity";
  figure.x_label = "overburden (Pa)";
  figure.y_label = "porosity";
  for (const double factor : beds.factors()) {
    Curve curve;
    curve.label = fmt::format("factor {:g}", factor);
    for (double load = load_step; load < largest_load; load += load_step)
      if (const auto value = mean_under(beds.of(law, "stress", factor), load))
        curve.x.push_back(load), curve.y.push_back(*value);
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

void add_figures(const Beds& beds, Findings& f) {
  for (const auto& [quantity, label] :
       {std::pair{"porosity", "porosity"}, {"coordination", "contacts per parcel"}}) {
    f.figure(over_factors(beds, fmt::format("{}-without-cohesion", quantity), quantity, label,
                          {{"hertz", "stress"}, {"hooke", "stress"}}, "Beds without cohesion"));
    for (const char* law : {"jkr", "sjkr2", "capillary"}) {
      if (!beds.has(law, "stress")) continue;
      f.figure(over_factors(beds, fmt::format("{}-{}", quantity, law), quantity, label,
                            {{law, "none"}, {law, "stress"}, {law, "bond"}},
                            fmt::format("Beds with cohesion: {}", law)));
    }
  }
  for (const char* law : {"hertz", "jkr", "sjkr2", "capillary"})
    if (beds.has(law, "stress")) f.figure(profile(beds, law));
}

}  // namespace

void conclude_box_filling(const std::vector<Done>& all, Findings& f) {
  const Beds beds(all);
  judge_without_cohesion(beds, f);
  judge_similarities(beds, f);
  judge_profiles(beds, f);
  report_cost(beds, f);
  add_figures(beds, f);
}

}  // namespace pulvis::study
