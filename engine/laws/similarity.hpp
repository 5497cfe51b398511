// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
#include <string_view>

// How the numbers of a law follow the size of the spheres it acts between, when parcels alpha times larger stand for
// grains of the same density.
//
// Stress similarity: stresses, densities and speeds of the grains are kept. Then lengths and times grow with alpha,
// masses with alpha^3, and so a number whose unit is kg^a m^b s^c with alpha^(3a + b + c): forces with alpha^2, moduli
// not at all. The rule follows from the unit, for every law there is. (C. Bierwisch et al., J. Mech. Phys. Solids 57
// (2009) 10-31, doi:10.1016/j.jmps.2008.10.006; Y. T. Feng, D. R. J. Owen, Int. J. Numer. Methods Eng. 99 (2014)
// 797-821, doi:10.1002/nme.4704.)
//
// Bond similarity: the same, except for the numbers that cohesion grows with. They are rescaled further, so that the
// pull-off force grows with alpha^3 as the weight does. Where F_po ~ value^p R^q, all else as under stress
// similarity, that is value ~ alpha^((3 - q)/p).
namespace pulvis::laws {

enum class Similarity {
  stress,  ///< stresses, speeds, overlaps over radii
  bond,    ///< the same but for cohesion, of which pull-off force over weight is kept
  none     ///< each number stays as it is for a grain
};

/// By the name it has in a case: "stress", "bond", "none".
constexpr Similarity similarity_named(std::string_view name) {
  return name == "bond" ? Similarity::bond : name == "none" ? Similarity::none : Similarity::stress;
}

/// Power of alpha by which a number of this unit grows under stress similarity. A unit that is not known here does
/// not compile where a part of a law states its parameters.
constexpr double size_power(std::string_view unit) {
  struct Unit {
    std::string_view name;
    int kilogram, metre, second;
  };
  constexpr Unit units[] = {{"-", 0, 0, 0},      {"rad", 0, 0, 0},  {"m", 0, 1, 0},     {"m/s", 0, 1, -1},
                            {"N", 1, 1, -2},     {"J", 1, 2, -2},   {"Pa", 1, -1, -2},  {"J/m^3", 1, -1, -2},
                            {"J/m^2", 1, 0, -2}, {"N/m", 1, 0, -2}, {"Pa s", 1, -1, -1}};
  for (const Unit& u : units)
    if (u.name == unit) return 3.0 * u.kilogram + u.metre + u.second;
  throw std::invalid_argument("a unit without powers");
}

/// What a number of a law has to do with the pull-off force. Each part says it of each of its parameters.
class PullOff {
 public:
  /// It is no measure of cohesion: bond similarity leaves it as stress similarity has it.
  static constexpr PullOff apart() { return {false, 0.0, 0.0}; }
  /// F_po ~ value^own R^size, all else as under stress similarity.
  static constexpr PullOff grows_with(double own, double size) { return {true, own, size}; }
  /// The pull-off force depends on it otherwise: the part knows no bond similarity.
  static constexpr PullOff otherwise() { return {true, 0.0, 0.0}; }

  constexpr bool has_rule() const { return !cohesive_ || own_ != 0.0; }
  /// Power of alpha under bond similarity; `stress`: that under stress similarity.
  constexpr double bond_power(double stress) const { return cohesive_ ? (3.0 - size_) / own_ : stress; }

 private:
  constexpr PullOff(bool cohesive, double own, double size) : cohesive_(cohesive), own_(own), size_(size) {}
  bool cohesive_;
  double own_, size_;
};

}  // namespace pulvis::laws
