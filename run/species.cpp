// SPDX-License-Identifier: Apache-2.0
#include "run/species.hpp"

#include <algorithm>

#include "engine/laws/estimates.hpp"

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

const PairOverride* find_override(const Case& c, std::size_t a, std::size_t b) {
  for (const auto& pair : c.pairs)
    if ((pair.first == a && pair.second == b) || (pair.first == b && pair.second == a)) return &pair;
  return nullptr;
}

void add_law_numbers(const ContactChoice& c, laws::MaterialPair& pair) {
  pair.rolling_viscosity = c.rolling_viscosity;
  pair.twisting_friction = c.twisting_friction;
  pair.normal_stiffness = c.normal_stiffness;
  pair.characteristic_speed = c.characteristic_speed;
  pair.tangential_ratio = c.tangential_ratio;
  pair.plastic_ratio = c.plastic_ratio;
  pair.adhesion_ratio = c.adhesion_ratio;
  pair.plasticity_depth = c.plasticity_depth;
  pair.unloading_ratio = c.unloading_ratio;
  pair.constant_pull = -c.constant_pull;
  pair.cohesion_energy_density = c.cohesion_energy_density;
  pair.surface_tension = c.surface_tension;
  pair.contact_angle = c.contact_angle;
  pair.liquid_content = c.liquid_content;
  pair.liquid_viscosity = c.liquid_viscosity;
  pair.shortest_bridge_gap = c.shortest_bridge_gap;
  pair.hamaker_constant = c.hamaker_constant;
  pair.shortest_gap = c.shortest_gap;
  pair.longest_gap = c.longest_gap;
}

/// Stress similarity: at the same overlap or gap over the radius, forces grow with alpha^2.
void scale_to_parcels(double alpha, laws::MaterialPair& pair) {
  pair.work_of_adhesion *= alpha;
  pair.normal_stiffness *= alpha;
  pair.constant_pull *= alpha * alpha;
  pair.surface_tension *= alpha;
  pair.liquid_viscosity *= alpha;
  pair.hamaker_constant *= alpha * alpha * alpha;
  pair.shortest_gap *= alpha;
  pair.longest_gap *= alpha;
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
  add_law_numbers(c.contact, pair);
  if (const PairOverride* own = find_override(c, a.material, b.material)) {
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
  scale_to_parcels(a.is_powder ? a.coarse_graining : b.coarse_graining, pair);
  return pair;
}

}  // namespace

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
