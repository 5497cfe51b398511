// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "validation/chapters.hpp"
#include "validation/references/cohesion.hpp"
#include "validation/scene.hpp"

namespace pulvis::validation {
namespace {

constexpr const char* yade = "YADE, checkCapillaryModels.py";
constexpr const char* willett = "Willett et al. (2000), doi:10.1021/la000657y";
constexpr double ten_degrees = 10.0 * std::numbers::pi / 180.0;

/// A bridge between two spheres.
struct Bridge {
  const char* law;
  double first, second;  ///< radii, m
  double volume;         ///< m^3
  double tension;        ///< N/m
  double angle;          ///< rad

  double radius() const { return 2.0 * first * second / (first + second); }
  laws::MaterialPair material() const {
    laws::MaterialPair m;
    m.effective_modulus = 1e6;
    m.surface_tension = tension;
    m.contact_angle = angle;
    m.liquid_content = volume / (sphere_volume(first) + sphere_volume(second));
    return m;
  }
  scenes::LawParts parts() const {
    scenes::LawParts parts{"hertz", "none", "none", "none", {}, law};
    parts.choices.bridges_form_on_approach = true;
    return parts;
  }
};

/// Pull on the first of two spheres at rest with this gap, N, through the engine.
double pull_at(const Bridge& b, double gap) {
  const double far = 10.0 * (b.first + b.second);
  Model m = scenes::one_pair(b.material(), b.parts(), {-far, -far, -far}, {far, far, far}, 1e-12,
                             std::fmin(b.first, b.second), std::fmax(b.first, b.second));
  m.body_force.gravity = {};
  const double apart = b.first + b.second + gap;
  const std::vector<Parcel> spheres{scenes::parcel(0, {0, 0, -0.5 * apart}, b.first, 1e6),
                                    scenes::parcel(1, {0, 0, 0.5 * apart}, b.second, 1e6)};
  Simulation s(m, scenes::state_of(m, spheres), 1);
  s.step();
  const std::size_t first = s.state().parcels.body[0].id == 0 ? 0 : 1;
  return s.state().parcels.load[first].force.z;
}

/// The gap up to which the engine's spheres pull, m, by bisection.
double rupture(const Bridge& b) {
  double bears = 0.0, broken = b.radius();
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (bears + broken);
    (pull_at(b, middle) > 0.0 ? bears : broken) = middle;
  }
  return bears;
}

void published(Findings& f) {
  struct Value {
    Bridge bridge;
    double gap, force, rupture;
  };
  for (const Value& v : {Value{{"capillary_willett", 19e-6, 35e-6, 2e-19, 0.027, ten_degrees},
                               2.4846e-7,
                               2.07328148666e-7,
                               6.373470e-7},
                         Value{{"capillary_willett_closed", 19e-6, 32.5e-6, 12e-19, 0.024, ten_degrees},
                               2.48485e-7,
                               6.78192074e-7,
                               1.160513e-6},
                         Value{{"capillary_rabinovich", 19e-6, 27.5e-6, 36e-19, 0.028, ten_degrees},
                               2.48535e-7,
                               1.58617796928e-6,
                               1.677729e-6}}) {
    f.compare(fmt::format("force of {} at a gap of {:.2f} nm, N", v.bridge.law, 1e9 * v.gap), yade, v.force,
              pull_at(v.bridge, v.gap), Compare::relative, 1e-8);
    // Given to seven digits.
    f.compare(fmt::format("rupture distance of {}, m", v.bridge.law), fmt::format("{}, eq. 15", willett),
              v.rupture, rupture(v.bridge), Compare::relative, 1e-6);
  }
}

/// R = 50 um, V = 0.01 R^3, sigma = 0.072 N/m, theta = 0.
Bridge of_50_micrometres(const char* law) { return {law, 50e-6, 50e-6, 1.25e-15, 0.072, 0.0}; }

void willetts_fit_at_three_gaps(Findings& f) {
  for (const auto& [gap, force] : {std::pair{0.1e-6, 1.961e-5}, {1e-6, 1.608e-5}, {5e-6, 5.726e-6}})
    f.compare(fmt::format("force of capillary_willett, R = 50 um, gap {:g} um, N", 1e6 * gap),
              "the fit evaluated elsewhere, four digits", force,
              pull_at(of_50_micrometres("capillary_willett"), gap), Compare::relative, 3e-4);
}

void four_laws(Findings& f) {
  Figure figure{"capillary-forces",
                "Bridges between two spheres of 50 um, V = 0.01 R^3, 0.072 N/m",
                "gap (um)",
                "pull (uN)",
                {}};
  for (const char* law :
       {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich", "capillary_soulie"}) {
    const Bridge b = of_50_micrometres(law);
    laws::Touch touch{};
    touch.radius_first = b.first, touch.radius_second = b.second;
    const Quad radius = b.radius(), third = quad_cube_root(Quad{b.volume} / (radius * radius * radius));
    const double longest = static_cast<double>(radius * (third + third * third / 10));
    Curve reference{fmt::format("{}, equation", law), {}, {}, false}, ours{law, {}, {}, true};
    double worst = 0.0;
    for (int k = 0; k <= 100; ++k) {
      const double gap = longest * 0.999 * k / 100.0, pull = pull_at(b, gap);
      const double expected = static_cast<double>(bridge_force(law, gap, touch, b.material()));
      worst = std::fmax(worst, std::fabs(pull / expected - 1.0));
      reference.x.push_back(1e6 * gap), reference.y.push_back(1e6 * expected);
      if (k % 10 == 0) ours.x.push_back(1e6 * gap), ours.y.push_back(1e6 * pull);
    }
    // Centres of such spheres are rounded to 7e-21 m, a millionth of a millionth of the gaps.
    f.compare(fmt::format("force of {} at 101 gaps up to rupture, two spheres of 50 um", law),
              "its published equation (docs/laws.md) in 113 bits", 0.0, worst, Compare::bound, 1e-10);
    f.compare(fmt::format("rupture distance of {}, two spheres of 50 um, m", law),
              fmt::format("{}, eq. 15", willett), longest, rupture(b), Compare::relative, 1e-10);
    figure.curves.push_back(std::move(reference));
    figure.curves.push_back(std::move(ours));
  }
  f.figure(std::move(figure));
}

}  // namespace

void capillary(Findings& f, Effort) {
  published(f);
  willetts_fit_at_three_gaps(f);
  four_laws(f);
}

}  // namespace pulvis::validation
