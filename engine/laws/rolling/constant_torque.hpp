// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::rolling {

/// Constant directional torque against rolling ("CDT").
///
///   T = -mu_r R* N omega_r/|omega_r|    [N m]
///
/// omega_r is the relative spin without its part along the normal.
///
/// Source     Y. C. Zhou et al., Physica A 269 (1999) 536-553, doi:10.1016/S0378-4371(99)00183-1 (with a length
///            in the place of mu_r R*);
///            J. Ai et al., Powder Technol. 206 (2011) 269-282, doi:10.1016/j.powtec.2010.09.030 (type A).
/// Symbols    N the limiting normal force (see ContactLaw); with the default limit the elastic force, as in the
///            LIGGGHTS family (there k_n delta).
/// Valid      steady rolling. At rest the direction flips from step to step: kinetic energy never dies out.
/// Touch      no memory, nothing to forget at separation. Without spin the torque is zero.
/// Energy     dissipative but for the flipping.
/// Tests      tests/laws/rolling_test.cpp, validation/rolling.cpp.
struct ConstantTorque {
  static constexpr const char* name = "constant_torque";
  static constexpr SpringKind spring = SpringKind::none;
  static constexpr bool needs_sizes = false;
  struct Pair {
    double friction;  ///< mu_r, -
  };
  static constexpr std::array parameters{needs::rolling_friction};

  static Pair mix(const MaterialPair& pair, const Choices&, const Stiffness&) {
    return {pair.rolling_friction};
  }

  PULVIS_INLINE static Vec3 roll(const Touch& touch, double /*contact_size*/, double limiting_force,
                                 const Pair& pair, Vec3& spring) {
    const Vec3 spin = in_plane(in_plane(touch.spin, touch.half_normal), touch.normal);
    const double size = norm(spin);
    spring = {};
    return -(pair.friction * touch.radius * limiting_force / greatest(size, 1e-300)) * spin;
  }
};

}  // namespace pulvis::laws::rolling
