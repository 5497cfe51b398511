// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "measures/container.hpp"
#include "measures/stress.hpp"

namespace pulvis::measures {

/// The die in layers along one of its axes, the lowest first. NaN where a layer without parcels has no value.
struct Layers {
  std::vector<double> position;        ///< m from the die's origin; the layer's middle
  std::vector<double> volume;          ///< m^3; of the layer inside the die
  std::vector<double> density;         ///< kg/m^3; bulk density
  std::vector<std::size_t> count;      ///< parcels whose centre is in the layer
  std::vector<Vec3> velocity;          ///< m/s; mass-weighted mean, in the coordinates of the container
  std::vector<double> speed_rms;       ///< m/s; sqrt(sum m v^2/sum m)
  std::vector<double> temperature;     ///< m^2/s^2; granular temperature, sum m v'^2/(3 sum m)
  std::vector<double> mean_diameter;   ///< m; mean over the parcels' number
  std::vector<double> coordination;    ///< contacts with parcels per parcel
  std::vector<Tensor> contact_stress;  ///< Pa, compressive positive
  std::vector<Tensor> kinetic_stress;  ///< Pa, compressive positive
};

/// Usual thickness of a layer in mean parcel diameters.
constexpr double layer_diameters = 3.0;

/// Layers whose thickness comes as close to `thickness` (m) as a whole number of them along the die's first,
/// second or third axis (0, 1, 2) allows. Counted are the parcels whose centre is in the die, each in the layer
/// with its centre; but in the bulk density each with the exact share of its volume in the layer,
///   density = sum_p m_p (share of p in the layer) / (volume of the layer inside the die),
/// the volume above the free surface included. v' is the velocity less the layer's mean. Stress as in stress():
/// contacts count half for each parcel in the layer, walls' whole; over the layer's volume inside the die.
///
/// Throws Failure for a thickness that divides no die, std::out_of_range for a parcel that does not exist,
/// std::invalid_argument for an axis that is not 0, 1 or 2.
Layers layers(std::span<const Particle> parcels, std::span<const PairForce> pairs,
              std::span<const WallForce> walls, const Container& container, int axis, double thickness);

}  // namespace pulvis::measures
