// SPDX-License-Identifier: Apache-2.0
#include "run/species.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/laws/estimates.hpp"
#include "run/pair_law.hpp"

namespace pulvis {
namespace {

double mix(Mixing rule, double a, double b) {
  switch (rule) {
    case Mixing::arithmetic_mean:
      return 0.5 * (a + b);
    case Mixing::harmonic_mean:
      return a + b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
    case Mixing::smaller:
      return least(a, b);
    case Mixing::larger:
      return greatest(a, b);
    case Mixing::geometric_mean:
      break;
  }
  return a == b ? a : root(a * b);
}

/// The numbers of the contact law: their name, where a case has them for all pairs, and where a pair has them.
struct LawNumber {
  const char* name;
  double ContactChoice::*of_all;
  double laws::MaterialPair::*of_pair;
};
#define PULVIS_LAW_NUMBER(name) \
  { #name, &ContactChoice::name, &laws::MaterialPair::name }
constexpr LawNumber law_numbers[] = {PULVIS_LAW_NUMBER(rolling_viscosity),
                                     PULVIS_LAW_NUMBER(twisting_friction),
                                     PULVIS_LAW_NUMBER(normal_stiffness),
                                     PULVIS_LAW_NUMBER(characteristic_speed),
                                     PULVIS_LAW_NUMBER(tangential_ratio),
                                     PULVIS_LAW_NUMBER(plastic_ratio),
                                     PULVIS_LAW_NUMBER(adhesion_ratio),
                                     PULVIS_LAW_NUMBER(plasticity_depth),
                                     PULVIS_LAW_NUMBER(unloading_ratio),
                                     PULVIS_LAW_NUMBER(constant_pull),
                                     PULVIS_LAW_NUMBER(cohesion_energy_density),
                                     PULVIS_LAW_NUMBER(surface_tension),
                                     PULVIS_LAW_NUMBER(contact_angle),
                                     PULVIS_LAW_NUMBER(liquid_content),
                                     PULVIS_LAW_NUMBER(liquid_viscosity),
                                     PULVIS_LAW_NUMBER(shortest_bridge_gap),
                                     PULVIS_LAW_NUMBER(hamaker_constant),
                                     PULVIS_LAW_NUMBER(shortest_gap),
                                     PULVIS_LAW_NUMBER(longest_gap)};
#undef PULVIS_LAW_NUMBER

void add_law_numbers(const ContactChoice& all, const PairOverride* own, laws::MaterialPair& pair) {
  for (const LawNumber& number : law_numbers) pair.*number.of_pair = all.*number.of_all;
  if (own != nullptr) {
    for (const auto& [name, value] : own->numbers)
      if (name == "characteristic_speed")
        pair.normal_stiffness = 0.0;  // that of all pairs would go before it
    for (const auto& [name, value] : own->numbers)
      for (const LawNumber& number : law_numbers)
        if (name == number.name) pair.*number.of_pair = value;
  }
  pair.constant_pull = -pair.constant_pull;  // positive in a case
}

laws::MaterialPair real_pair(const Case& c, const Species& a, const Species& b) {
  const Material &ma = c.materials[a.material], &mb = c.materials[b.material];
  laws::MaterialPair pair;
  pair.effective_modulus =
      laws::effective_modulus(a.real_modulus, ma.poisson_ratio, b.real_modulus, mb.poisson_ratio);
  pair.effective_shear_modulus =
      laws::effective_shear_modulus(a.real_modulus, ma.poisson_ratio, b.real_modulus, mb.poisson_ratio);
  pair.restitution = mix(c.mixing, ma.restitution, mb.restitution);
  pair.friction = mix(c.mixing, ma.friction, mb.friction);
  pair.rolling_friction = mix(c.mixing, ma.rolling_friction, mb.rolling_friction);
  pair.work_of_adhesion = 2.0 * root(ma.surface_energy * mb.surface_energy);
  const PairOverride* own = find_override(c, a.material, b.material);
  add_law_numbers(c.contact, own, pair);
  if (own != nullptr) {
    pair.restitution = own->restitution.value_or(pair.restitution);
    pair.friction = own->friction.value_or(pair.friction);
    pair.rolling_friction = own->rolling_friction.value_or(pair.rolling_friction);
    pair.work_of_adhesion = own->work_of_adhesion.value_or(pair.work_of_adhesion);
  }
  return pair;
}

laws::MaterialPair simulated_pair(const Case& c, const Species& a, const Species& b,
                                  laws::MaterialPair pair) {
  const double real_modulus = pair.effective_modulus;
  const double nu_a = c.materials[a.material].poisson_ratio, nu_b = c.materials[b.material].poisson_ratio;
  pair.effective_modulus = laws::effective_modulus(a.modulus, nu_a, b.modulus, nu_b);
  pair.effective_shear_modulus = laws::effective_shear_modulus(a.modulus, nu_a, b.modulus, nu_b);
  // What is kept is the softened powder's choice, whichever of the two stands first.
  const Species& softened = a.is_softened() ? a : b;
  if (pair.work_of_adhesion > 0.0 && softened.is_softened() &&
      c.powders[softened.powder].keep == Powder::Keep::sticking_speed)
    pair.work_of_adhesion *= power(pair.effective_modulus / real_modulus, 0.4);
  return named_law(c.contact).for_parcels(pair, a.is_powder ? a.coarse_graining : b.coarse_graining,
                                          similarity(c.contact));
}

}  // namespace

double law_number(const laws::MaterialPair& pair, std::string_view name) {
  for (const LawNumber& number : law_numbers)
    if (name == number.name) return pair.*number.of_pair;
  throw std::invalid_argument("no number of the contact law is called " + std::string(name));
}

const PairOverride* find_override(const Case& c, std::size_t a, std::size_t b) {
  for (const auto& pair : c.pairs)
    if ((pair.first == a && pair.second == b) || (pair.first == b && pair.second == a)) return &pair;
  return nullptr;
}

SizeLaw grain_sizes(const Powder& powder) {
  const SizeDistribution& s = powder.size;
  SizeLaw law;
  switch (s.kind) {
    case SizeDistribution::Kind::single:
      law.kind = SizeKind::single;
      break;
    case SizeDistribution::Kind::uniform:
      law.kind = SizeKind::uniform;
      break;
    case SizeDistribution::Kind::normal:
      law.kind = SizeKind::normal;
      break;
    case SizeDistribution::Kind::lognormal:
      law.kind = SizeKind::lognormal;
      break;
    case SizeDistribution::Kind::table:
      law.kind = SizeKind::table;
      break;
  }
  law.diameter = s.diameter;
  law.standard_deviation = s.standard_deviation;
  law.geometric_deviation = s.geometric_deviation;
  law.smallest = s.smallest;
  law.largest = s.largest;
  law.by_mass = s.by_mass;
  law.diameters = s.diameters;
  law.shares = s.shares;
  return law;
}

SizeLaw parcel_sizes(const Powder& powder) {
  SizeLaw law = grain_sizes(powder);
  const double alpha = powder.coarse_graining;
  law.diameter *= alpha;
  law.standard_deviation *= alpha;
  law.smallest *= alpha;
  law.largest *= alpha;
  for (double& d : law.diameters) d *= alpha;
  return law;
}

std::vector<Species> species_of(const Case& c) {
  std::vector<Species> list;
  for (std::size_t p = 0; p < c.powders.size(); ++p) {
    const Powder& powder = c.powders[p];
    const double real = c.materials[powder.material].young_modulus;
    list.push_back({powder.name, powder.material, true, p, powder.simulated_modulus.value_or(real), real,
                    powder.coarse_graining});
  }
  for (const Wall& wall : c.walls) {
    const bool known = std::any_of(list.begin(), list.end(), [&](const Species& s) {
      return !s.is_powder && s.material == wall.material;
    });
    const double modulus = c.materials[wall.material].young_modulus;
    if (!known)
      list.push_back(
          {"wall of " + c.materials[wall.material].name, wall.material, false, 0, modulus, modulus, 1.0});
  }
  return list;
}

std::size_t species_of_powder(std::size_t powder) { return powder; }

std::size_t species_of_material(const std::vector<Species>& species, std::size_t material) {
  for (std::size_t k = 0; k < species.size(); ++k)
    if (!species[k].is_powder && species[k].material == material) return k;
  return 0;
}

std::vector<PairProperties> mix_pairs(const Case& c, const std::vector<Species>& species) {
  std::vector<PairProperties> pairs;
  for (std::size_t a = 0; a < species.size(); ++a)
    for (std::size_t b = a; b < species.size(); ++b) {
      if (!species[a].is_powder) continue;  // walls do not touch walls; powders come first
      PairProperties p;
      p.first = a;
      p.second = b;
      p.real = real_pair(c, species[a], species[b]);
      p.simulated = simulated_pair(c, species[a], species[b], p.real);
      pairs.push_back(p);
    }
  return pairs;
}

}  // namespace pulvis
