// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "study/sheared_box.hpp"

namespace pulvis::study {
namespace {

using validation::Compare;
using validation::Findings;

const char* const regimes_source = "S. Chialvo et al., Phys. Rev. E 85 (2012) 021305";
const char* const scaling_source = "similarity: the rate in the parcel's own units grows with the factor";

/// One point in short.
struct Spot {
  double fraction, friction, rate, factor, pressure, shear, pressure_error, shear_error, diameter;
};

std::vector<Spot> spots_of(const std::vector<Done>& all, const std::string& series, const std::string& law) {
  std::vector<Spot> list;
  for (const Done& d : all) {
    const Json &s = d.point.settings, &r = d.result;
    if (s.at("series") != series || s.at("law") != law) continue;
    list.push_back({s.at("solid_fraction"), s.at("friction"), s.at("rate"), s.at("factor"), r.at("pressure"),
                    r.at("shear_stress"), r.at("pressure_error"), r.at("shear_stress_error"),
                    r.at("diameter_m")});
  }
  std::sort(list.begin(), list.end(), [](const Spot& a, const Spot& b) {
    return std::tie(a.friction, a.fraction, a.rate, a.factor) <
           std::tie(b.friction, b.fraction, b.rate, b.factor);
  });
  return list;
}

template <class Test>
std::vector<Spot> those(const std::vector<Spot>& list, Test&& test) {
  std::vector<Spot> some;
  std::copy_if(list.begin(), list.end(), std::back_inserter(some), test);
  return some;
}

std::set<double> fractions_of(const std::vector<Spot>& list) {
  std::set<double> fractions;
  for (const Spot& s : list) fractions.insert(s.fraction);
  return fractions;
}

/// Exponent of y = c x^n by least squares of the logarithms.
template <class X, class Y>
double exponent(const std::vector<Spot>& list, X&& x, Y&& y) {
  double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  const auto n = static_cast<double>(list.size());
  for (const Spot& s : list) {
    const double lx = std::log(x(s)), ly = std::log(y(s));
    sum_x += lx, sum_y += ly, sum_xx += lx * lx, sum_xy += lx * ly;
  }
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}
double rate_of(const Spot& s) { return s.rate; }
double factor_of(const Spot& s) { return s.factor; }
double pressure_of(const Spot& s) { return s.pressure; }
double shear_of(const Spot& s) { return s.shear; }

constexpr std::pair<const char*, double (*)(const Spot&)> stresses[] = {{"P", pressure_of},
                                                                        {"tau", shear_of}};

// --- the three regimes ------------------------------------------------------------------------------------

void judge_regime(const std::vector<Spot>& regimes, const char* name, double fraction, double low,
                  double high, double slope, Findings& f) {
  const auto list = those(regimes, [&](const Spot& s) {
    return s.fraction == fraction && s.rate > 0.99 * low && s.rate < 1.01 * high;
  });
  if (list.size() < 2) return;
  f.compare(
      fmt::format("Hooke, {} (solid fraction {:g}, rates {:g} to {:g}): exponent of P in the shear rate",
                  name, fraction, list.front().rate, list.back().rate),
      regimes_source, slope, exponent(list, rate_of, pressure_of), Compare::absolute, 0.1);
}

// --- the jamming fraction ---------------------------------------------------------------------------------

/// Exponent of P in the rate against the solid fraction.
Curve exponents(const std::vector<Spot>& jamming, double friction) {
  Curve curve;
  curve.label = friction == 0.0 ? "no friction" : fmt::format("friction {:g}", friction);
  for (const double fraction : fractions_of(jamming)) {
    const auto list =
        those(jamming, [&](const Spot& s) { return s.fraction == fraction && s.friction == friction; });
    if (list.size() < 2) continue;
    curve.x.push_back(fraction);
    curve.y.push_back(exponent(list, rate_of, pressure_of));
  }
  return curve;
}

/// Where the exponent falls through 1/2: P of both flowing and jammed boxes tends to the root of the rate there.
double jamming_fraction(const Curve& curve) {
  for (std::size_t k = 1; k < curve.x.size(); ++k)
    if (curve.y[k - 1] >= 0.5 && curve.y[k] < 0.5)
      return curve.x[k - 1] +
             (curve.y[k - 1] - 0.5) / (curve.y[k - 1] - curve.y[k]) * (curve.x[k] - curve.x[k - 1]);
  return std::nan("");
}

void judge_jamming(const std::vector<Spot>& jamming, Findings& f) {
  const Curve smooth = exponents(jamming, 0.0), rough = exponents(jamming, 0.5);
  f.compare("jamming fraction without friction: 0.630 to 0.645", regimes_source, 0.6375,
            jamming_fraction(smooth), Compare::absolute, 0.0075);
  f.compare("jamming fraction at friction 0.5: 0.575 to 0.60", regimes_source, 0.5875,
            jamming_fraction(rough), Compare::absolute, 0.0125);
  Figure figure;
  figure.name = "jamming";
  figure.title = "Exponent of the pressure in the shear rate, Hooke: 2 flowing, 1/2 at jamming, 0 jammed";
  figure.x_label = "solid fraction";
  figure.y_label = "exponent between rates of 0.001 and 0.003";
  figure.curves = {smooth, rough};
  f.figure(std::move(figure));
}

// --- coarse graining --------------------------------------------------------------------------------------

std::string law_words(const std::string& law) { return law == "hooke" ? "Hooke" : "Hertz"; }

void judge_factors(const std::vector<Spot>& factors, const std::string& law, Findings& f) {
  for (const double fraction : fractions_of(factors)) {
    const auto list = those(factors, [&](const Spot& s) { return s.fraction == fraction; });
    if (list.size() < 2) continue;
    const std::string where = fmt::format("{}, solid fraction {:g}, factors {:g} to {:g}", law_words(law),
                                          fraction, list.front().factor, list.back().factor);
    const double of_pressure = exponent(list, factor_of, pressure_of),
                 of_shear = exponent(list, factor_of, shear_of);
    if (fraction < 0.55) {
      f.compare(where + ": exponent of P in the factor", scaling_source, 2.0, of_pressure, Compare::absolute,
                0.1);
      f.compare(where + ": exponent of tau in the factor", scaling_source, 2.0, of_shear, Compare::absolute,
                0.1);
    } else if (fraction > 0.6) {
      for (const auto& [name, value] : stresses) {
        const double grain = value(list.front());
        double worst = grain;
        for (const Spot& s : list)
          if (std::fabs(value(s) - grain) > std::fabs(worst - grain)) worst = value(s);
        f.compare(fmt::format("{}: {} over {}, furthest from that of the smallest factor", where, name,
                              law == "hooke" ? "k/d" : "E"),
                  "stress similarity: quasi-static flow does not change", grain, worst, Compare::relative,
                  0.05);
      }
    } else {
      f.compare(where + ": exponent of P in the factor", "near jamming, between the regimes", 0.5,
                of_pressure, Compare::absolute, std::nullopt);
    }
  }
}

// --- figures ----------------------------------------------------------------------------------------------

template <class X, class Y>
std::vector<Curve> curves_by_fraction(const std::vector<Spot>& list, X&& x, Y&& y) {
  std::vector<Curve> curves;
  for (const double fraction : fractions_of(list)) {
    Curve curve;
    curve.label = fmt::format("solid fraction {:g}", fraction);
    for (const Spot& s : those(list, [&](const Spot& t) { return t.fraction == fraction; })) {
      curve.x.push_back(x(s));
      curve.y.push_back(y(s));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

Figure log_figure(const std::string& name, const std::string& title, const std::string& x_label,
                  const std::string& y_label, std::vector<Curve> curves) {
  Figure figure;
  figure.name = name;
  figure.title = title;
  figure.x_label = x_label;
  figure.y_label = y_label;
  figure.log_x = figure.log_y = true;
  figure.curves = std::move(curves);
  return figure;
}

void add_figures(const std::vector<Spot>& regimes, const std::map<std::string, std::vector<Spot>>& factors,
                 Findings& f) {
  const std::string rate = "shear rate / sqrt(k/(rho d^3))";
  f.figure(log_figure("regimes-pressure", "Pressure in the three regimes, Hooke, friction 0.5", rate, "P d/k",
                      curves_by_fraction(regimes, rate_of, pressure_of)));
  f.figure(log_figure("regimes-shear-stress", "Shear stress in the three regimes, Hooke, friction 0.5", rate,
                      "tau d/k", curves_by_fraction(regimes, rate_of, shear_of)));
  const auto diameter = [](const Spot& s) { return 1e3 * s.diameter; };
  for (const auto& [law, list] : factors) {
    const std::string over = law == "hooke" ? " d/k" : "/E";
    f.figure(log_figure(law + "-pressure", "Pressure against the parcels' diameter, " + law_words(law),
                        "diameter of parcels (mm); grains have 1 mm", "P" + over,
                        curves_by_fraction(list, diameter, pressure_of)));
    f.figure(log_figure(law + "-shear-stress",
                        "Shear stress against the parcels' diameter, " + law_words(law),
                        "diameter of parcels (mm); grains have 1 mm", "tau" + over,
                        curves_by_fraction(list, diameter, shear_of)));
  }
}

}  // namespace

void conclude_sheared_box(const std::vector<Done>& all, Findings& f) {
  const std::vector<Spot> regimes = spots_of(all, "regimes", "hooke"),
                          jamming = spots_of(all, "jamming", "hooke");
  const std::map<std::string, std::vector<Spot>> factors{{"hooke", spots_of(all, "factors", "hooke")},
                                                         {"hertz", spots_of(all, "factors", "hertz")}};
  judge_regime(regimes, "quasi-static", 0.66, 0.0, 3e-3, 0.0, f);
  judge_regime(regimes, "intermediate", 0.5875, 3e-3, 3e-2, 0.5, f);
  judge_regime(regimes, "inertial", 0.50, 0.0, 3e-3, 2.0, f);
  judge_jamming(jamming, f);
  for (const auto& [law, list] : factors) judge_factors(list, law, f);
  for (const auto& [law, list] : factors)
    for (const Spot& s : list)
      if (s.factor == list.front().factor)
        f.compare(
            fmt::format("{}, solid fraction {:g}, factor {:g}: tau/P", law_words(law), s.fraction, s.factor),
            "reported", s.shear / s.pressure, s.shear / s.pressure, Compare::absolute, std::nullopt);
  add_figures(regimes, factors, f);
}

}  // namespace pulvis::study
