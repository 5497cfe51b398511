// SPDX-License-Identifier: Apache-2.0
#include "measures/layers.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "measures/grid.hpp"
#include "measures/sphere_box.hpp"

namespace pulvis::measures {
namespace {

constexpr std::size_t outside = std::numeric_limits<std::size_t>::max();
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

Box slab(const Division& division, std::size_t layer, const DieFrame& frame, int axis) {
  Box box{{}, frame.size()};
  box.min[axis] = division.edge(layer);
  box.max[axis] = division.edge(layer + 1);
  return box;
}

/// Mass of a parcel to the layers it reaches into; what sticks out of the die belongs to the end layers.
void add_mass(std::vector<double>& mass, const Particle& parcel, double along, const Division& division) {
  const double r = parcel.radius;
  const std::size_t first = division.at(along - r), last = division.at(along + r);
  if (first == last || !(r > 0.0)) {
    mass[first] += parcel.mass;
    return;
  }
  for (std::size_t layer = first; layer <= last; ++layer) {
    Box box{{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}};
    if (layer > first) box.min.x = division.edge(layer);
    if (layer < last) box.max.x = division.edge(layer + 1);
    mass[layer] += parcel.mass * sphere_box_volume({{along, 0, 0}, r}, box) / sphere_volume(r);
  }
}

Layers empty_layers(const Division& division, const DieFrame& frame, int axis) {
  Layers result;
  for (std::size_t layer = 0; layer < division.count(); ++layer) {
    const Box box = slab(division, layer, frame, axis);
    result.position.push_back(0.5 * (box.min[axis] + box.max[axis]));
    result.volume.push_back(frame.volume_inside(box));
  }
  const std::size_t count = division.count();
  result.density.assign(count, 0.0);
  result.count.assign(count, 0);
  result.velocity.assign(count, {});
  for (auto* values : {&result.speed_rms, &result.temperature, &result.mean_diameter, &result.coordination})
    values->assign(count, 0.0);
  result.contact_stress.assign(count, {});
  result.kinetic_stress.assign(count, {});
  return result;
}

/// Sums over parcels become means; of the layer's mass by centres, `mass`.
void add_motion(Layers& result, std::span<const Particle> parcels, std::span<const std::size_t> layer_of) {
  std::vector<double> mass(result.count.size(), 0.0);
  for (std::size_t i = 0; i < parcels.size(); ++i) {
    const std::size_t layer = layer_of[i];
    if (layer == outside) continue;
    const Particle& p = parcels[i];
    ++result.count[layer];
    mass[layer] += p.mass;
    result.velocity[layer] += p.mass * p.velocity;
    result.speed_rms[layer] += p.mass * dot(p.velocity, p.velocity);
    result.mean_diameter[layer] += 2.0 * p.radius;
  }
  for (std::size_t layer = 0; layer < mass.size(); ++layer) {
    const bool any = result.count[layer] > 0;
    result.velocity[layer] = any ? result.velocity[layer] / mass[layer] : Vec3{no_value, no_value, no_value};
    result.speed_rms[layer] = any ? std::sqrt(result.speed_rms[layer] / mass[layer]) : no_value;
    result.mean_diameter[layer] =
        any ? result.mean_diameter[layer] / static_cast<double>(result.count[layer]) : no_value;
  }
  for (std::size_t i = 0; i < parcels.size(); ++i) {
    const std::size_t layer = layer_of[i];
    if (layer == outside) continue;
    const Vec3 about = parcels[i].velocity - result.velocity[layer];
    result.kinetic_stress[layer] += parcels[i].mass * outer(about, about);
  }
  for (std::size_t layer = 0; layer < mass.size(); ++layer)
    result.temperature[layer] =
        result.count[layer] > 0 ? result.kinetic_stress[layer].trace() / (3.0 * mass[layer]) : no_value;
}

void add_contacts(Layers& result, std::span<const PairForce> pairs, std::span<const WallForce> walls,
                  std::span<const std::size_t> layer_of) {
  for (const PairForce& pair : pairs)
    for (const std::uint32_t parcel : {pair.first, pair.second})
      if (const std::size_t layer = layer_of[parcel]; layer != outside) {
        result.coordination[layer] += 1.0;
        result.contact_stress[layer] += 0.5 * outer(pair.force, pair.branch);
      }
  for (const WallForce& wall : walls)
    if (const std::size_t layer = layer_of[wall.parcel]; layer != outside)
      result.contact_stress[layer] += outer(wall.force, wall.branch);
  for (std::size_t layer = 0; layer < result.count.size(); ++layer)
    result.coordination[layer] = result.count[layer] > 0
                                     ? result.coordination[layer] / static_cast<double>(result.count[layer])
                                     : no_value;
}

}  // namespace

Layers layers(std::span<const Particle> parcels, std::span<const PairForce> pairs,
              std::span<const WallForce> walls, const Container& container, int axis, double thickness) {
  if (axis < 0 || axis > 2) throw std::invalid_argument("layers: the axis must be 0, 1 or 2");
  check_forces(pairs, walls, parcels.size());
  const DieFrame frame(container);
  const Division division(frame.size()[axis], thickness);
  Layers result = empty_layers(division, frame, axis);

  std::vector<std::size_t> layer_of(parcels.size(), outside);
  for (std::size_t i = 0; i < parcels.size(); ++i) {
    if (!is_inside(container, parcels[i].position)) continue;
    const double along = frame.to_local(parcels[i].position)[axis];
    layer_of[i] = division.at(along);
    add_mass(result.density, parcels[i], along, division);
  }
  add_motion(result, parcels, layer_of);
  add_contacts(result, pairs, walls, layer_of);
  for (std::size_t layer = 0; layer < result.volume.size(); ++layer) {
    result.density[layer] = result.density[layer] / result.volume[layer];
    result.contact_stress[layer] = (1.0 / result.volume[layer]) * result.contact_stress[layer];
    result.kinetic_stress[layer] = (1.0 / result.volume[layer]) * result.kinetic_stress[layer];
  }
  return result;
}

}  // namespace pulvis::measures
