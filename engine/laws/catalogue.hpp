// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstring>
#include <string_view>
#include <vector>

#include "engine/laws/contact_law.hpp"
#include "engine/laws/damping/restitution.hpp"
#include "engine/laws/normal/hertz.hpp"
#include "engine/laws/normal/jkr.hpp"
#include "engine/laws/rolling/elastic_plastic.hpp"
#include "engine/laws/sliding/total_spring.hpp"

// The catalogue: every part of a contact law that exists. A law is a choice of one part from each list.
// To add a part: write its file, include it above, name it in its list.
namespace pulvis::laws {

template <class... Parts>
struct PartList {
  static constexpr std::size_t size = sizeof...(Parts);
};

using NormalParts = PartList<normal::Hertz, normal::Jkr>;
using DampingParts = PartList<damping::Restitution, damping::None>;
using SlidingParts = PartList<sliding::TotalSpring, sliding::None>;
using RollingParts = PartList<rolling::ElasticPlastic, rolling::None>;

/// Where the constants of each part stand in those of the whole law.
enum class Place { whole, normal, damping, sliding, rolling, count };

/// Constants of a law for one pair of species: what the `Pair` of each part holds, as plain doubles.
inline constexpr std::size_t constants_per_part = 24;
using PairConstants = std::array<double, constants_per_part* static_cast<std::size_t>(Place::count)>;

/// The constants of one part out of those of its law.
template <class Pair>
Pair unpack(const double* constants, Place place) {
  static_assert(sizeof(Pair) <= constants_per_part * sizeof(double));
  Pair pair;
  std::memcpy(static_cast<void*>(&pair), constants + constants_per_part * static_cast<std::size_t>(place),
              sizeof pair);
  return pair;
}

// The parts as the rest of the program sees them: by name, without their types. Constants are those of the
// whole law.

struct PartEntry {
  std::string_view name;
  std::size_t index;  ///< in the list of its kind
};
struct NormalEntry : PartEntry {
  void (*mix)(const MaterialPair&, const Choices&, PairConstants&);
  Stiffness (*stiffness)(const MaterialPair&);
  double (*separation_gap)(double radius, const PairConstants&);
  Normal (*normal)(double overlap, double radius, const PairConstants&);
};
struct FollowingEntry : PartEntry {
  void (*mix)(const MaterialPair&, const Choices&, const Stiffness&, PairConstants&);
};
struct DampingEntry : FollowingEntry {
  Dashpots (*coefficients)(const Normal&, double mass, const PairConstants&);
};
struct SlidingEntry : FollowingEntry {
  Vec3 (*slide)(const Touch&, const Vec3& slip_velocity, double contact_size, double limiting_force,
                double dashpot, const PairConstants&, Vec3& xi);
};
struct RollingEntry : FollowingEntry {
  Vec3 (*roll)(const Touch&, double contact_size, double limiting_force, const Vec3& old_torque,
               const PairConstants&);
};

/// All parts, in the order of the lists above, which is also that of the kernels.
struct Catalogue {
  std::vector<NormalEntry> normal;
  std::vector<DampingEntry> damping;
  std::vector<SlidingEntry> sliding;
  std::vector<RollingEntry> rolling;
};
const Catalogue& catalogue();

/// A contact law: one part of each kind.
struct Law {
  const NormalEntry* normal = nullptr;
  const DampingEntry* damping = nullptr;
  const SlidingEntry* sliding = nullptr;
  const RollingEntry* rolling = nullptr;

  PairConstants mix(const MaterialPair& material, const Choices& choices) const;
  /// Gap up to which an existing contact lasts, m.
  double separation_gap(double radius, const PairConstants&) const;
  Normal normal_force(double overlap, double radius, const PairConstants&) const;
  /// The law for one contact, part after part: what the kernels do for many at once, to the same bits.
  Response evaluate(const Touch& touch, const History& old, const PairConstants& constants) const;
};

/// The law with these parts. Throws std::invalid_argument if there is none.
Law find_law(std::string_view normal, std::string_view damping, std::string_view sliding,
             std::string_view rolling);

}  // namespace pulvis::laws
