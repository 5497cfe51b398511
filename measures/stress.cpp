// SPDX-License-Identifier: Apache-2.0
#include "measures/stress.hpp"

#include <stdexcept>

#include "measures/sum.hpp"

namespace pulvis::measures {

void check_forces(std::span<const PairForce> pairs, std::span<const WallForce> walls, std::size_t parcels) {
  for (const PairForce& pair : pairs)
    if (pair.first >= parcels || pair.second >= parcels)
      throw std::out_of_range("a force names a parcel that does not exist");
  for (const WallForce& wall : walls)
    if (wall.parcel >= parcels) throw std::out_of_range("a wall's force names a parcel that does not exist");
}

Stress stress(std::span<const Particle> parcels, std::span<const std::uint8_t> counted,
              std::span<const PairForce> pairs, std::span<const WallForce> walls, double volume) {
  if (counted.size() != parcels.size())
    throw std::invalid_argument("stress: there must be one mark for each parcel");
  if (!(volume > 0.0)) throw std::invalid_argument("stress: the volume must be above zero");
  check_forces(pairs, walls, parcels.size());
  const auto counts = [&](std::uint32_t parcel) { return counted[parcel] != 0 ? 1.0 : 0.0; };

  Stress result;
  result.volume = volume;
  const Tensor of_pairs = pairwise_total<Tensor>(pairs.size(), [&](std::size_t i) {
    const PairForce& c = pairs[i];
    return 0.5 * (counts(c.first) + counts(c.second)) * outer(c.force, c.branch);
  });
  const Tensor of_walls = pairwise_total<Tensor>(walls.size(), [&](std::size_t i) {
    return counts(walls[i].parcel) * outer(walls[i].force, walls[i].branch);
  });
  result.contact = (1.0 / volume) * (of_pairs + of_walls);

  const auto mass_of = [&](std::size_t i) { return counted[i] != 0 ? parcels[i].mass : 0.0; };
  const double mass = pairwise_sum(parcels.size(), mass_of);
  if (!(mass > 0.0)) return result;
  const Vec3 momentum =
      pairwise_total<Vec3>(parcels.size(), [&](std::size_t i) { return mass_of(i) * parcels[i].velocity; });
  result.mean_velocity = momentum / mass;
  const Tensor fluctuations = pairwise_total<Tensor>(parcels.size(), [&](std::size_t i) {
    const Vec3 about = parcels[i].velocity - result.mean_velocity;
    return mass_of(i) * outer(about, about);
  });
  result.kinetic = (1.0 / volume) * fluctuations;
  return result;
}

}  // namespace pulvis::measures
