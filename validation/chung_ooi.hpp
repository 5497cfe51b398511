// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "validation/chapters.hpp"
#include "validation/impacts.hpp"

// What the files of the chapter `chung_ooi` share.
namespace pulvis::validation::chung_ooi_tests {

inline constexpr const char* paper = "Chung, Ooi (2011), doi:10.1007/s10035-011-0277-0";
inline constexpr const char* gross_sliding =
    "closed form: friction impulse mu m* (1 + e) v_n; test of Chung, Ooi (2011), "
    "doi:10.1007/s10035-011-0277-0";
inline constexpr const char* integration =
    "the law integrated apart, 2e5 steps a contact; test of Chung, Ooi (2011), doi:10.1007/s10035-011-0277-0";
inline constexpr const char* digitised =
    "curve of Chung, Ooi (2011), doi:10.1007/s10035-011-0277-0, as digitised in the DEM benchmarks of Kratos";
inline constexpr const char* printed = "the same law integrated by others, to the digits they print";

inline constexpr double of_closed_form = 1e-2, of_integration = 1e-3;
inline constexpr double degree = std::numbers::pi / 180.0;

struct Named {
  const char* name;
  Ball ball;
};

/// Whether slip never stops: v_t/(mu v_n) >= 3.5 (1 + e) - e (2 - nu)/(3 (1 - nu)), for Hertz with k_t = 8 G* a
/// and a spring of the whole displacement, as at the end of a contact the spring unloads as fast as its limit.
inline bool slides_throughout(const Meeting& m) {
  const double nu = m.first.poisson, e = m.restitution;
  return std::fabs(m.slip()) / (m.friction * m.normal_speed) >=
         3.5 * (1.0 + e) - e * (2.0 - nu) / (3.0 * (1.0 - nu));
}

void head_on(Findings&);  // tests 1 to 3
void oblique_4(Findings&);
void oblique_5(Findings&);
void spinning(Findings&);  // tests 6 to 8

}  // namespace pulvis::validation::chung_ooi_tests
