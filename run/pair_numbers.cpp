// SPDX-License-Identifier: Apache-2.0
#include "run/pair_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "engine/parcels/parcels.hpp"
#include "run/body_pull.hpp"
#include "run/pair_law.hpp"

namespace pulvis {
namespace {

/// The d50 sphere of a powder, or a wall.
void add_body(const Case& c, const Species& s, Scale scale, double& radius, double& mass) {
  if (!s.is_powder) return;
  const Powder& p = c.powders[s.powder];
  radius = 0.5 * SizeSampler(scale == Scale::parcel ? parcel_sizes(p) : grain_sizes(p)).median_by_mass();
  mass = c.materials[s.material].density * sphere_volume(radius);
}

}  // namespace

PairNumbers pair_numbers(const Case& c, const std::vector<Species>& species, const PairProperties& pair,
                         Scale scale, double bed_stress, double speed) {
  single_contact::Bodies bodies;
  add_body(c, species[pair.first], scale, bodies.radius_first, bodies.mass_first);
  add_body(c, species[pair.second], scale, bodies.radius_second, bodies.mass_second);
  const laws::MaterialPair& material = scale == Scale::parcel ? pair.simulated : pair.real;
  PairNumbers n({pair_law(c.contact, material), material, law_choices(c.contact), bodies});
  n.radius = bodies.radius_first;
  n.weight = bodies.mass_first * norm(strongest_pull(c));
  n.load = std::max(bed_stress * square(2.0 * n.radius), n.weight);
  const bool remembers = n.contact.remembers();
  n.adhesion = single_contact::adhesion(n.contact, remembers ? n.load : 0.0);
  if (c.contact.damping == "restitution") n.restitution = material.restitution;
  n.speed_scale = remembers ? speed : std::sqrt(2.0 * n.adhesion.separation_work / n.contact.mass());
  n.undamped_sticking = single_contact::sticking_speeds(n.contact.undamped(), n.speed_scale);
  return n;
}

}  // namespace pulvis
