// SPDX-License-Identifier: Apache-2.0
// Head-on collisions of two parcels against the factor of coarse graining: figures 2.3 to 2.5 of G. Schiochet Nasato,
// Die filling of cohesive powders (JKU Linz, 2016), for every law of the catalogue.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/laws/estimates.hpp"
#include "single_contact/adhesion.hpp"
#include "single_contact/collision.hpp"
#include "study/studies.hpp"

namespace pulvis::study {
namespace {

using validation::Compare;
using validation::Findings;

// The molybdenum grains of the tests: diameter, density, Poisson's ratio, speed.
constexpr double grain_radius = 2.3e-6, density = 10200.0, poisson = 0.3, speed = 0.05;
constexpr double soft = 1e7, stiff = 1e9;  // Pa
const std::vector<double> standard_factors{1, 2, 5, 10, 20, 50, 100};

laws::MaterialPair material_of(const Json& settings) {
  const double young = settings.at("young_modulus");
  laws::MaterialPair m;
  m.effective_modulus = laws::effective_modulus(young, poisson, young, poisson);
  m.effective_shear_modulus = laws::effective_shear_modulus(young, poisson, young, poisson);
  m.work_of_adhesion = 2e-4;
  m.restitution = 0.5;
  m.characteristic_speed = speed;
  m.plastic_ratio = 5.0;
  m.adhesion_ratio = 0.2;
  m.plasticity_depth = 0.05;
  m.unloading_ratio = 1.5;
  m.constant_pull = -1e-10;
  m.cohesion_energy_density = settings.value("cohesion_energy_density", 2e-3 * young);
  m.surface_tension = 2e-5;
  m.contact_angle = 0.2;
  m.liquid_content = 1e-3;
  m.liquid_viscosity = 1e-6;
  m.hamaker_constant = 2e-21;
  m.shortest_gap = 4e-10;
  m.longest_gap = 4e-8;
  return m;
}

laws::Similarity similarity_of(const Json& settings) {
  return laws::similarity_named(settings.at("similarity").get<std::string>());
}

laws::Law law_of(const Json& settings) {
  return laws::find_law(settings.at("normal").get<std::string>(), "restitution", "none", "none",
                        settings.at("cohesion").get<std::string>());
}

Json compute(const Work& work) {
  const laws::Law law = law_of(work.settings);
  const laws::MaterialPair grain = material_of(work.settings);
  Json rows = Json::array();
  for (const double alpha : work.settings.at("factors")) {
    const double radius = alpha * grain_radius, mass = density * 4.0 / 3.0 * M_PI * radius * radius * radius;
    const single_contact::Contact contact(law, law.for_parcels(grain, alpha, similarity_of(work.settings)),
                                          {}, {radius, radius, mass, mass});
    const single_contact::Collision c = single_contact::collide(contact, speed);
    // The law may remember how strongly it was pressed: by a force that grows with alpha^2.
    const double pull = single_contact::adhesion(contact, 1e-9 * alpha * alpha).pull_off;
    rows.push_back({{"factor", alpha},
                    {"overlap_over_radius", c.largest_overlap / radius},
                    {"restitution", c.restitution},
                    {"sticks", c.sticks},
                    {"time_over_factor", c.duration / alpha},
                    {"pull_off_over_mass", pull / mass}});
  }
  return {{"rows", rows}};
}

/// Every normal law, and every cohesion with each normal law it goes with.
std::vector<std::pair<std::string, std::string>> head_on_laws() {
  std::vector<std::pair<std::string, std::string>> list;
  const laws::MaterialPair material = material_of({{"young_modulus", soft}});
  for (const auto& normal : laws::catalogue().normal)
    for (const auto& cohesion : laws::catalogue().cohesion)
      if (laws::find_law(normal.name, "restitution", "none", "none", cohesion.name)
              .problems(material, {})
              .empty())
        list.emplace_back(normal.name, cohesion.name);
  return list;
}

std::string law_text(const Json& settings) {
  const std::string normal = settings.at("normal"), cohesion = settings.at("cohesion");
  return cohesion == "none" ? normal : normal + " with " + cohesion;
}

Point point(const std::string& name, const std::string& normal, const std::string& cohesion, double young,
            const std::string& similarity, const std::vector<double>& factors) {
  return {name,
          {{"normal", normal},
           {"cohesion", cohesion},
           {"young_modulus", young},
           {"similarity", similarity},
           {"factors", factors}}};
}

std::vector<Point> points(const Options& options) {
  std::vector<double> factors = options.factors.empty() ? standard_factors : options.factors;
  if (options.quick && options.factors.empty()) factors = {1, 10, 100};
  std::vector<Point> list;
  for (const auto& [normal, cohesion] : head_on_laws()) {
    const laws::Law law = laws::find_law(normal, "restitution", "none", "none", cohesion);
    for (const double young : {soft, stiff})
      for (const char* similarity : {"stress", "bond", "none"}) {
        if (!law.why_not(laws::similarity_named(similarity)).empty()) continue;
        list.push_back(
            point(fmt::format("{}-{}-{}-{}", normal, cohesion, young == soft ? "soft" : "stiff", similarity),
                  normal, cohesion, young, similarity, factors));
      }
  }
  // What the published table has besides.
  list.push_back(point("table-jkr-bond", "jkr", "none", soft, "bond", {1, 5, 6, 10, 50, 100}));
  list.push_back(point("table-jkr-none", "jkr", "none", soft, "none", {1, 10, 50}));
  for (const double energy : {1e4, 2e4, 1e5}) {
    list.push_back(point(fmt::format("table-sjkr2-{:.0f}", energy), "hertz", "sjkr2_reduced_radius", soft,
                         "stress", {1, 10, 50, 100}));
    list.back().settings["cohesion_energy_density"] = energy;
  }
  return list;
}

const Done& find(const std::vector<Done>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Done& d) { return d.point.name == name; });
}

double at(const Done& done, double factor, const char* quantity) {
  for (const Json& row : done.result.at("rows"))
    if (row.at("factor") == factor) return row.at(quantity);
  return std::nan("");
}

/// The value that is furthest from that of the grain.
double furthest(const Json& rows, const char* quantity) {
  const double grain = rows.front().at(quantity);
  double worst = grain;
  for (const Json& row : rows)
    if (const double value = row.at(quantity); std::fabs(value - grain) > std::fabs(worst - grain))
      worst = value;
  return worst;
}

void compare_with_the_grain(const Done& done, const char* quantity, const std::string& words,
                            std::optional<double> limit, Findings& f) {
  const Json& rows = done.result.at("rows");
  const double grain = rows.front().at(quantity), worst = furthest(rows, quantity);
  const std::string stiffness = done.point.settings.at("young_modulus") == soft ? "soft" : "stiff";
  // A collision that sticks has restitution 0.
  f.compare(fmt::format("{}, {}: {}", law_text(done.point.settings), stiffness, words),
            fmt::format("the factor {:g}", double(rows.front().at("factor"))), grain, worst,
            grain == 0.0 ? Compare::absolute : Compare::relative, limit);
}

void add_table(const std::vector<Done>& all, Findings& f) {
  const auto row = [&](const std::string& name, double factor, const char* quantity, const std::string& words,
                       double reference) {
    f.compare(fmt::format("{}, factor {:g}: {}", words, factor, quantity),
              "integrated apart, at alpha = 1 and larger", reference, at(find(all, name), factor, quantity),
              Compare::relative, 0.01);
  };
  for (const double factor : {1.0, 10.0, 50.0}) {
    const double overlaps[] = {0.008920, 0.008735, 0.008719}, leaves[] = {0.4698, 0.4977, 0.4996},
                 times[] = {1.753e-6, 1.658e-6, 1.645e-6};
    const std::size_t k = factor == 1.0 ? 0 : factor == 10.0 ? 1 : 2;
    row("table-jkr-none", factor, "overlap_over_radius", "jkr unscaled", overlaps[k]);
    row("table-jkr-none", factor, "restitution", "jkr unscaled", leaves[k]);
    row("table-jkr-none", factor, "time_over_factor", "jkr unscaled", times[k]);
  }
  const double factors[] = {10.0, 50.0, 100.0}, overlaps[] = {0.01103, 0.02106, 0.03199};
  for (std::size_t k = 0; k < 3; ++k)
    row("table-jkr-bond", factors[k], "overlap_over_radius", "jkr, only cohesion rescaled", overlaps[k]);
  row("table-jkr-bond", 5.0, "restitution", "jkr, only cohesion rescaled", 0.189);
  const Json& sticking = find(all, "table-jkr-bond").result.at("rows");
  f.compare("jkr, only cohesion rescaled: factors of 1, 5, 6, 10, 50, 100 that stick",
            "integrated apart: from 6 on", 4.0,
            static_cast<double>(
                std::count_if(sticking.begin(), sticking.end(),
                              [](const Json& r) { return r.at("sticks") && r.at("factor") >= 6.0; })),
            Compare::absolute, 0.0);
  const double energies[] = {1e4, 2e4, 1e5}, overlap[] = {0.008926, 0.009151, 0.01177},
               leave[] = {0.4831, 0.4645, 0.1962}, time[] = {1.695e-6, 1.756e-6, 2.769e-6};
  for (std::size_t k = 0; k < 3; ++k)
    for (const double factor : {1.0, 100.0}) {
      const std::string name = fmt::format("table-sjkr2-{:.0f}", energies[k]),
                        words = fmt::format("sjkr2, k_c = {:g} J/m^3", energies[k]);
      row(name, factor, "overlap_over_radius", words, overlap[k]);
      row(name, factor, "restitution", words, leave[k]);
      row(name, factor, "time_over_factor", words, time[k]);
    }
  for (const double factor : {1.0, 10.0, 100.0})
    if (!std::isnan(at(find(all, "hertz-none-soft-stress"), factor, "restitution"))) {
      row("hertz-none-soft-stress", factor, "overlap_over_radius", "hertz", 0.008716);
      row("hertz-none-soft-stress", factor, "restitution", "hertz", 0.5);
      row("hertz-none-soft-stress", factor, "time_over_factor", "hertz", 1.638e-6);
    }
}

Curve curve_of(const Done& done, const char* quantity, const std::string& label) {
  Curve curve;
  curve.label = label;
  for (const Json& row : done.result.at("rows")) {
    curve.x.push_back(row.at("factor"));
    curve.y.push_back(row.at(quantity));
  }
  return curve;
}

void add_figures(const std::vector<Done>& all, Findings& f) {
  struct Quantity {
    const char *name, *label, *words;
  };
  constexpr Quantity quantities[] = {
      {"overlap_over_radius", "largest overlap over radius", "largest-overlap"},
      {"restitution", "restitution; 0: sticks", "restitution"},
      {"time_over_factor", "contact time over factor (s)", "contact-time"}};
  for (const char* stiffness : {"soft", "stiff"})
    for (const Quantity& q : quantities) {
      Figure figure;
      figure.name = fmt::format("{}-{}", q.words, stiffness);
      figure.title = fmt::format("Collisions of {} parcels at 0.05 m/s", stiffness);
      figure.x_label = "factor of coarse graining";
      figure.y_label = q.label;
      figure.log_x = true;
      for (const char* law :
           {"hertz-none", "hooke-none", "hertz-sjkr2_reduced_radius", "hertz-capillary_willett"})
        figure.curves.push_back(
            curve_of(find(all, fmt::format("{}-{}-stress", law, stiffness)), q.name,
                     law_text(find(all, fmt::format("{}-{}-stress", law, stiffness)).point.settings)));
      for (const char* similarity : {"stress", "bond", "none"})
        figure.curves.push_back(curve_of(find(all, fmt::format("jkr-none-{}-{}", stiffness, similarity)),
                                         q.name, fmt::format("jkr, {}", similarity)));
      f.figure(std::move(figure));
    }
}

void conclude(const std::vector<Done>& all, Findings& f) {
  for (const Done& done : all) {
    const std::string similarity = done.point.settings.at("similarity");
    if (done.point.name.starts_with("table-")) continue;
    if (similarity == "stress") {
      compare_with_the_grain(done, "overlap_over_radius", "largest overlap over radius", 1e-3, f);
      compare_with_the_grain(done, "restitution", "restitution", 1e-3, f);
      compare_with_the_grain(done, "time_over_factor", "contact time over factor", 1e-3, f);
    } else if (similarity == "bond" && furthest(done.result.at("rows"), "pull_off_over_mass") > 0.0) {
      // Rules for small overlaps. A law that yields pulls as strongly as it was dented, and cohesion dents, too.
      const bool remembers = law_of(done.point.settings).normal->remembers;
      compare_with_the_grain(done, "pull_off_over_mass", "pull-off force over mass (bond similarity)",
                             remembers ? std::nullopt : std::optional(0.01), f);
    }
  }
  add_table(all, f);
  add_figures(all, f);
}

}  // namespace

Study collision() {
  return {"collision",
          "Collisions of coarse-grained parcels",
          "Two parcels collide head-on at 0.05 m/s; molybdenum grains of 4.6 um, softened to 10 MPa (soft) "
          "and 1 GPa "
          "(stiff). Under stress similarity largest overlap over radius, restitution and contact time over "
          "the factor "
          "are those of the grain, whatever the law; each row has the factor that is furthest from that. "
          "Under bond "
          "similarity the pull-off force over the mass is the grain's. Restitution 0: they stick.",
          false,
          points,
          compute,
          conclude};
}

}  // namespace pulvis::study
