// SPDX-License-Identifier: Apache-2.0
#include "run/graining.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/similarity_words.hpp"
#include "case/units.hpp"
#include "run/body_pull.hpp"
#include "run/build_walls.hpp"
#include "run/pair_numbers.hpp"
#include "single_contact/collision.hpp"

namespace pulvis {
namespace {

constexpr double fewest_parcels = 10.0;  // across a die or an outlet, for its walls not to rule the bed
constexpr double wall_layers = 2.0;      // parcels: as far as walls order a packing
// I = rate d sqrt(rho/p). Above, collisions carry the stress: GDR MiDi, Eur. Phys. J. E 14 (2004) 341-365,
// doi:10.1140/epje/i2003-10153-0, section 5.
constexpr double quick_flow = 0.1;

Case without_graining(Case c) {
  for (Powder& p : c.powders) p.coarse_graining = 1.0;
  return c;
}

std::string value_text(double x, const Dimension& dimension) {
  if (x == 0.0) return "-";
  if (std::isinf(x)) return "any";
  return dimension == dimension::none ? fmt::format("{:.4g}", x) : format_quantity(x, dimension);
}

Counterpart counterpart(std::string name, double grain, double parcel, double growth,
                        const Dimension& dimension) {
  return {
      std::move(name), grain, parcel, growth, value_text(grain, dimension), value_text(parcel, dimension)};
}

PairGraining pair_graining(const Assembly& a, const PairProperties& p, const PairNumbers& grain,
                           const PairNumbers& parcel) {
  const double speed = a.time_step.characteristic_speed;
  const single_contact::Collision g = single_contact::collide(grain.contact, speed),
                                  q = single_contact::collide(parcel.contact, speed);
  const auto strength = [](const PairNumbers& n) { return n.adhesion.pull_off / square(2.0 * n.radius); };
  PairGraining result{a.species[p.first].name + " / " + a.species[p.second].name, {}};
  result.numbers = {counterpart("pull-off force over diameter^2", strength(grain), strength(parcel), 0.0,
                                dimension::pressure),
                    counterpart("Bond number", grain.bond(), parcel.bond(), 0.0, dimension::none),
                    counterpart("largest overlap over radius", g.largest_overlap / grain.radius,
                                q.largest_overlap / parcel.radius, 0.0, dimension::none),
                    counterpart("restitution", g.restitution, q.restitution, 0.0, dimension::none),
                    counterpart("contact time", g.duration, q.duration, 1.0, dimension::time),
                    counterpart("sticking speed", grain.undamped_sticking.highest,
                                parcel.undamped_sticking.highest, 0.0, dimension::speed)};
  return result;
}

/// The smallest radii of grains, m, by species.
std::vector<double> smallest_grains(const Case& c, const std::vector<Species>& species) {
  std::vector<double> radii(species.size(), 0.0);
  for (std::size_t k = 0; k < c.powders.size(); ++k)
    radii[species_of_powder(k)] = 0.5 * SizeSampler(grain_sizes(c.powders[k])).smallest();
  return radii;
}

void add_narrow_walls(const Case& c, const Assembly& a, Graining& g) {
  const double parcel = 2.0 * a.model.largest_radius;
  for (std::size_t w = 0; w < c.walls.size(); ++w) {
    Vec3 low, high;
    if (!bounds_of_wall(a.model.walls, w, low, high)) continue;
    const double width = narrowest_width(c.walls[w], high - low), outlet = outlet_width(c.walls[w]);
    if (width < fewest_parcels * parcel)
      g.warnings.push_back(fmt::format(
          "walls.{} is only {:.3g} of the largest parcels wide (below {:g}): {:.0f} % of it lie within {:g} "
          "parcels of "
          "a wall, where packings are looser, and parcels arch sooner than grains: lower coarse_graining",
          c.walls[w].name, width / parcel, fewest_parcels,
          100.0 * std::fmin(2.0 * wall_layers * parcel / width, 1.0), wall_layers));
    if (outlet > 0.0 && outlet < fewest_parcels * parcel)
      g.warnings.push_back(
          fmt::format("the opening of walls.{} is only {:.3g} of the largest parcels wide (below {:g}): "
                      "parcels flow more slowly and clog where grains would not: lower "
                      "coarse_graining",
                      c.walls[w].name, outlet / parcel, fewest_parcels));
  }
}

/// Inertial number of a bed that is sheared over its narrowest width at the characteristic speed.
double inertial_number(const Case& c, const Assembly& a, double diameter, double bed_stress) {
  double width = 1e300, density = 0.0;
  for (std::size_t w = 0; w < c.walls.size(); ++w) {
    Vec3 low, high;
    if (bounds_of_wall(a.model.walls, w, low, high))
      width = std::fmin(width, narrowest_width(c.walls[w], high - low));
  }
  for (const Powder& p : c.powders) density = std::fmax(density, c.materials[p.material].density);
  if (!(bed_stress > 0.0) || width > 1e299) return 0.0;
  return a.time_step.characteristic_speed / width * diameter * std::sqrt(density / bed_stress);
}

}  // namespace

double Counterpart::ratio(double alpha) const {
  if (std::isinf(grain) && std::isinf(parcel)) return 1.0;
  return grain > 0.0 ? parcel / (grain * std::pow(alpha, growth)) : parcel > 0.0 ? HUGE_VAL : 0.0;
}

bool Counterpart::is_kept(double alpha) const { return std::fabs(ratio(alpha) - 1.0) < 0.01; }

Graining graining(const Case& c, const Assembly& a, double parcels, double bed_stress) {
  Graining g;
  g.factor = c.powders.front().coarse_graining;
  if (g.factor == 1.0) return g;
  const Case fine = without_graining(c);
  const std::vector<Species> species = species_of(fine);
  const std::vector<PairProperties> pairs = mix_pairs(fine, species);
  const double speed = a.time_step.characteristic_speed;
  for (std::size_t k = 0; k < a.pairs.size(); ++k)
    g.pairs.push_back(
        pair_graining(a, a.pairs[k], pair_numbers(fine, species, pairs[k], Scale::parcel, bed_stress, speed),
                      pair_numbers(c, a.species, a.pairs[k], Scale::parcel, bed_stress, speed)));
  if (!c.time.step) {
    const TimeStep step = choose_time_step(fine, species, pairs, a.model.walls, smallest_grains(c, species));
    g.whole.push_back(counterpart("time step", step.step, a.time_step.step, 1.0, dimension::time));
  }
  g.whole.push_back(counterpart("number", parcels * std::pow(g.factor, 3), parcels, -3.0, dimension::none));
  const double diameter = SizeSampler(parcel_sizes(c.powders.front())).median_by_mass(),
               inertial = inertial_number(c, a, diameter, bed_stress);
  g.whole.push_back(counterpart("inertial number at the bottom, at most about", inertial / g.factor, inertial,
                                0.0, dimension::none));
  add_narrow_walls(c, a, g);
  if (inertial > quick_flow && inertial / g.factor < quick_flow)
    g.warnings.push_back(
        fmt::format("flow at the characteristic speed has an inertial number of about {:.2g} with parcels "
                    "and {:.2g} with grains: "
                    "collisions carry stresses there, and those grow with coarse_graining^2; trust beds at "
                    "rest and slow flow",
                    inertial, inertial / g.factor));
  return g;
}

std::string graining_text(const Case& c, const Graining& g) {
  if (g.factor == 1.0) return {};
  std::string text =
      fmt::format("\ncoarse graining {:g}, similarity {}{}\n", g.factor, c.contact.similarity,
                  c.powders.front().simulated_modulus ? "; grains as soft as their parcels" : "");
  const auto add = [&](const Counterpart& n) {
    const std::string verdict = n.ratio(g.factor) == 0.0 ? ""
                                : n.is_kept(g.factor)
                                    ? n.growth == 0.0 ? "kept" : fmt::format("as factor^{:g}", n.growth)
                                    : fmt::format("times {:.3g}", n.parcel / n.grain);
    text += fmt::format("  {:<46} {:>14} {:>14}   {}\n", n.name, n.grain_text, n.parcel_text, verdict);
  };
  text += fmt::format("  {:<46} {:>14} {:>14}\n", "", "grain", "parcel");
  for (const Counterpart& n : g.whole) add(n);
  for (const PairGraining& p : g.pairs) {
    text += "  " + p.pair + "\n";
    for (const Counterpart& n : p.numbers) add(n);
  }
  text += fmt::format("  kept: {}\n  not kept: {}\n", what_is_kept(c.contact.similarity),
                      what_is_not_kept(c.contact.similarity));
  return text;
}

}  // namespace pulvis
