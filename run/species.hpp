// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "engine/laws/parts.hpp"
#include "engine/parcels/size_sampler.hpp"

namespace pulvis {

/// What the engine tells apart: each powder, and each material that a wall is made of.
struct Species {
  std::string name;
  std::size_t material = 0;
  bool is_powder = false;
  std::size_t powder = 0;        ///< if is_powder
  double modulus = 0.0;          ///< simulated Young's modulus, Pa
  double real_modulus = 0.0;     ///< Pa
  double coarse_graining = 1.0;  ///< alpha; 1 for walls

  bool is_softened() const { return modulus != real_modulus; }  ///< powders only; walls stay as they are
};

/// Parcels' sizes of a powder: the grains' law times alpha.
SizeLaw parcel_sizes(const Powder& powder);
/// Grains' sizes of a powder.
SizeLaw grain_sizes(const Powder& powder);

/// One pair of species, as it is and as it is simulated.
struct PairProperties {
  std::size_t first = 0, second = 0;  ///< species
  laws::MaterialPair real;            ///< grains, real modulus, real adhesion
  laws::MaterialPair simulated;       ///< parcels, simulated modulus, scaled adhesion
};

std::vector<Species> species_of(const Case& c);
/// Index of the species of a powder or of a wall's material.
std::size_t species_of_powder(std::size_t powder);
std::size_t species_of_material(const std::vector<Species>& species, std::size_t material);

/// What the case states for a pair of materials by itself, or nullptr.
const PairOverride* find_override(const Case& c, std::size_t first_material, std::size_t second_material);

/// A number of the contact law by its name (see law_numbers in species.cpp). Throws std::invalid_argument if there is
/// none of that name.
double law_number(const laws::MaterialPair& pair, std::string_view name);

/// Mixes every pair of species of which at least one is a powder. The simulated pair follows from the real
/// one in two steps, both stated in NOTATION:
///   softening        keep = pull_off: W stays; keep = sticking_speed: W (E*_sim/E*_real)^(2/5)
///   coarse graining  each number of the law by its rule under the case's similarity (engine/laws/similarity.hpp)
/// `keep` is that of the softened powder; two softened powders that adhere must agree in it (see assemble).
/// Of two materials W = 2 sqrt(gamma_1 gamma_2): Dupre's gamma_1 + gamma_2 - gamma_12 with
/// gamma_12 = (sqrt(gamma_1) - sqrt(gamma_2))^2, J. N. Israelachvili, Intermolecular and Surface Forces, 3rd ed.
/// (2011), chapter 13, doi:10.1016/B978-0-12-391927-4.10013-1.
/// The 2/5 is from v_s ~ (W^5/E*^2)^(1/6), jkr_sticking_speed.
std::vector<PairProperties> mix_pairs(const Case& c, const std::vector<Species>& species);

}  // namespace pulvis
