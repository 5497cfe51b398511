// SPDX-License-Identifier: Apache-2.0
// A box sheared by Lees-Edwards boundaries: pressure and shear stress against parcel diameter, shear rate and solid
// fraction, figures 2.6 to 2.11 of G. Schiochet Nasato, Die filling of cohesive powders (JKU Linz, 2016); set-up and
// regimes after S. Chialvo, J. Sun, S. Sundaresan, Phys. Rev. E 85 (2012) 021305, doi:10.1103/PhysRevE.85.021305.
#include "study/sheared_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "case/reader.hpp"
#include "run/assemble.hpp"
#include "run/sheared_box.hpp"
#include "run/stop_request.hpp"
#include "study/cases.hpp"
#include "study/statistics.hpp"
#include "study/studies.hpp"

namespace pulvis::study {
namespace {

// Shares of the smallest time-step limit: about ten steps per contact time of the linear spring, and per that of Hertz
// at the overlaps of a jammed box.
constexpr double hooke_step = 0.3, hertz_step = 0.2;
constexpr std::size_t blocks = 10;

/// The stress that pressures are set against, Pa: k/d of the linear spring, E of Hertz. The same for grains and parcels.
double stress_scale(const Case& c) {
  if (c.contact.normal == "hooke") return c.contact.normal_stiffness / c.powders[0].size.diameter;
  return c.materials[0].young_modulus;
}

/// Time in which that stress moves a grain by its diameter, s: rates are given in its inverse.
double time_scale(const Case& c) {
  return c.powders[0].size.diameter * std::sqrt(c.materials[0].density / stress_scale(c));
}

std::string number(double value) { return fmt::format("{:.17g}", value); }

/// The case with a number of parcels that does not depend on the factor: the box grows with it.
Case case_of(const Work& work) {
  const Json& settings = work.settings;
  const bool linear = settings.at("law") == "hooke";
  const double factor = settings.at("factor"), fraction = settings.at("solid_fraction");
  std::vector<Override> set{{"materials.beads.friction", number(settings.at("friction"))},
                            {"sources.beads.solid_fraction", number(fraction)},
                            {"powders.beads.coarse_graining", number(factor)},
                            {"time.fraction", number(linear ? hooke_step : hertz_step)},
                            {"seed", std::to_string(settings.at("seed").get<int>())}};
  if (settings.at("friction") == 0.0) set.push_back({"contact.sliding", "none"});
  const std::string file = written_case(work.folder, linear ? "sheared-box.toml" : "sheared-box-hertz.toml");
  const Case grains = read_case(file, set);
  const double diameter = factor * grains.powders[0].size.diameter;
  const double width = diameter * std::cbrt(settings.at("parcels").get<double>() * pi / (6.0 * fraction));
  set.push_back({"domain.max", fmt::format("[\"{0:.17g} m\", \"{0:.17g} m\", \"{0:.17g} m\"]", width)});
  set.push_back(
      {"domain.shear.rate", number(settings.at("rate").get<double>() / time_scale(grains)) + " 1/s"});
  return read_case(file, set);
}

/// Means over equal blocks of the strain.
class Means {
 public:
  void add(std::size_t block, const std::array<double, 5>& values) {
    for (std::size_t k = 0; k < values.size(); ++k) sum_[k][block] += values[k];
    ++count_[block];
  }
  /// Mean of the k-th quantity in each block.
  std::vector<double> of(std::size_t k) const {
    std::vector<double> means;
    for (std::size_t b = 0; b < blocks; ++b)
      if (count_[b] > 0) means.push_back(sum_[k][b] / static_cast<double>(count_[b]));
    return means;
  }

 private:
  std::array<std::array<double, blocks>, 5> sum_{};
  std::array<std::size_t, blocks> count_{};
};

Json compute(const Work& work) {
  const Case c = case_of(work);
  Model model = assemble(c).model;
  const double rate = std::fabs(model.domain.shear.rate), strain_of_step = rate * model.dt;
  const auto before =
                 static_cast<std::uint64_t>(work.settings.at("strain_before").get<double>() / strain_of_step),
             steps =
                 static_cast<std::uint64_t>(work.settings.at("strain").get<double>() / strain_of_step) + 1;
  Simulation simulation(model, Simulation::initial_state(model), work.threads);
  simulation.open_source(0);
  const std::uint64_t every = std::clamp<std::uint64_t>(steps / 4000, 4, 100);
  const double scale = stress_scale(c);
  Means means;
  for (std::uint64_t step = 0; step < before + steps; ++step) {
    const bool looks = step >= before && step % every == 0;
    simulation.step(looks ? Simulation::Then::look : Simulation::Then::go_on);
    if (signal_to_stop() != 0) throw Stopped{};
    if (!looks) continue;
    const ShearedBox box = look_at_sheared_box(simulation);
    means.add((step - before) * blocks / steps,
              {box.stress.pressure() / scale, box.shear_stress / scale, box.stress.kinetic_pressure() / scale,
               box.coordination, box.solid_fraction});
  }
  const std::vector<double> pressure = means.of(0), shear = means.of(1);
  return {{"pressure", mean_of(pressure)},
          {"pressure_error", standard_error_of(pressure)},
          {"shear_stress", mean_of(shear)},
          {"shear_stress_error", standard_error_of(shear)},
          {"kinetic_pressure", mean_of(means.of(2))},
          {"coordination", mean_of(means.of(3))},
          {"solid_fraction", mean_of(means.of(4))},
          {"diameter_m", 2.0 * model.largest_radius},
          {"shear_rate_per_s", model.domain.shear.rate},
          {"stress_scale_Pa", scale},
          {"time_step_s", model.dt},
          {"steps", before + steps},
          {"parcels", simulation.state().parcels.size()}};
}

// --- the points ------------------------------------------------------------------------------------------

class Points {
 public:
  explicit Points(const Options& options) : quick_(options.quick) {}

  /// One point; the rate is that of the grain in units of 1/time_scale.
  void add(const char* series, const char* law, double friction, double fraction, double rate, double factor,
           int parcels, double strain) {
    list_.push_back({fmt::format("{}-{}-mu{:g}-phi{:g}-rate{:g}-factor{:g}", series, law, friction, fraction,
                                 rate, factor),
                     {{"series", series},
                      {"law", law},
                      {"friction", friction},
                      {"solid_fraction", fraction},
                      {"rate", rate},
                      {"factor", factor},
                      {"parcels", parcels},
                      {"strain_before", quick_ ? 0.7 : 1.0},
                      {"strain", quick_ && fraction > 0.55 ? 0.4 * strain : strain},  // few contacts scatter
                      {"seed", 1}}});
  }
  /// Those that take longest first.
  std::vector<Point> sorted() {
    const auto cost = [](const Point& p) {
      const Json& s = p.settings;
      return s.at("parcels").get<double>() *
             (s.at("strain_before").get<double>() + s.at("strain").get<double>()) /
             (s.at("rate").get<double>() * s.at("factor").get<double>());
    };
    std::stable_sort(list_.begin(), list_.end(),
                     [&](const Point& a, const Point& b) { return cost(a) > cost(b); });
    return std::move(list_);
  }

 private:
  bool quick_;
  std::vector<Point> list_;
};

/// Jammed boxes must agree within 5 %, so that their means need more strain: under Hertz, where pressures scatter more
/// and steps are longer, most.
double factor_strain(const std::string& law, double fraction, double factor) {
  if (fraction < 0.55) return 8.0;  // few contacts at a time
  if (fraction < 0.6) return 4.0;
  if (law == "hertz") return 20.0;
  return factor < 2.0 ? 6.0 : factor < 4.0 ? 10.0 : 12.0;
}

std::vector<Point> points(const Options& options) {
  Points list(options);
  const int parcels = options.quick ? 300 : 500;
  const auto sweep = [&](double fraction, const std::vector<double>& rates) {
    for (const double rate : rates) list.add("regimes", "hooke", 0.5, fraction, rate, 1.0, parcels, 4.0);
  };
  // Regimes: pressure against shear rate.
  for (const double fraction : {0.50, 0.5875, 0.66})
    sweep(fraction,
          options.quick ? std::vector{1e-3, 3e-3, 1e-2, 3e-2} : std::vector{3e-4, 1e-3, 3e-3, 1e-2, 3e-2});
  // Jammed parcels at this rate overlap by more than half a radius, where a run stops.
  if (!options.quick)
    for (const double fraction : {0.50, 0.5875}) sweep(fraction, {1e-1});
  if (!options.quick)
    for (const double fraction : {0.56, 0.62}) sweep(fraction, {1e-3, 3e-3, 1e-2, 3e-2, 1e-1});
  // Where the exponent of the rate is 1/2.
  const std::vector<double> smooth =
      options.quick ? std::vector{0.62, 0.63, 0.64, 0.65} : std::vector{0.62, 0.63, 0.635, 0.64, 0.65};
  const std::vector<double> rough =
      options.quick ? std::vector{0.57, 0.58, 0.59, 0.60} : std::vector{0.57, 0.58, 0.585, 0.59, 0.60};
  for (const double rate : {1e-3, 3e-3}) {
    for (const double fraction : smooth) list.add("jamming", "hooke", 0.0, fraction, rate, 1.0, parcels, 5.0);
    for (const double fraction : rough) list.add("jamming", "hooke", 0.5, fraction, rate, 1.0, parcels, 5.0);
  }
  // Coarse graining at a given rate.
  std::vector<double> factors = options.factors;
  if (factors.empty()) factors = options.quick ? std::vector{1.0, 2.0, 4.0} : std::vector{1.0, 2.0, 4.0, 8.0};
  const double rate = options.quick ? 6e-4 : 2e-4;
  for (const char* law : {"hooke", "hertz"})
    for (const double fraction : {0.50, 0.5875, 0.66})
      for (const double factor : factors)
        list.add("factors", law, 0.5, fraction, rate, factor, parcels, factor_strain(law, fraction, factor));
  return list.sorted();
}

}  // namespace

Study sheared_box() {
  return {
      "sheared-box",
      "A sheared box of soft spheres under coarse graining",
      "500 spheres of one size in a box that is periodic all around and sheared evenly by Lees-Edwards "
      "boundaries. Restitution 0.7, friction 0.5 or none, k_t/k_n = 2/7. Pressure P and shear stress tau are "
      "means, over a strain of 4 or more after one of 1, of what contacts carry and velocities about the "
      "flow; "
      "over k/d of the linear spring (Hooke) or E (Hertz). Shear rates are over sqrt(k/(rho d^3)) or "
      "sqrt(E/rho)/d of the grain. Under stress similarity k grows with the factor and E stays, so that "
      "larger "
      "parcels at the same shear rate are sheared faster in their own units: nothing changes where the flow "
      "is "
      "quasi-static, P grows with the root of the factor in the intermediate regime and with its square "
      "where "
      "inertia rules. There are as many parcels for each factor. The jamming fraction is where P grows with "
      "the "
      "root of the shear rate, between rates of 0.001 and 0.003.",
      false,
      points,
      compute,
      conclude_sheared_box};
}

}  // namespace pulvis::study
