// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/laws/cohesion/capillary_rabinovich.hpp"
#include "engine/laws/cohesion/capillary_soulie.hpp"
#include "engine/laws/cohesion/capillary_willett.hpp"
#include "engine/laws/cohesion/capillary_willett_closed.hpp"
#include "engine/laws/cohesion/dmt.hpp"
#include "engine/laws/cohesion/hamaker.hpp"
#include "engine/laws/cohesion/none.hpp"
#include "engine/laws/cohesion/sjkr.hpp"
#include "engine/laws/cohesion/sjkr2.hpp"
#include "engine/laws/contact_law.hpp"
#include "engine/laws/damping/restitution.hpp"
#include "engine/laws/normal/edinburgh.hpp"
#include "engine/laws/normal/hertz.hpp"
#include "engine/laws/normal/hooke.hpp"
#include "engine/laws/normal/jkr.hpp"
#include "engine/laws/normal/luding.hpp"
#include "engine/laws/rolling/constant_torque.hpp"
#include "engine/laws/rolling/elastic_plastic.hpp"
#include "engine/laws/rolling/elastic_plastic_viscous.hpp"
#include "engine/laws/sliding/incremental_spring.hpp"
#include "engine/laws/sliding/rescaled_spring.hpp"
#include "engine/laws/sliding/total_spring.hpp"
#include "engine/laws/sliding/viscous.hpp"
#include "engine/laws/twisting/elastic_plastic.hpp"

// The catalogue: every part of a contact law that exists. A law is a choice of one part from each list.
// To add a part: write its file, include it above, name it in its list.
namespace pulvis::laws {

template <class... Parts>
struct PartList {
  static constexpr std::size_t size = sizeof...(Parts);
};

using NormalParts = PartList<normal::Hertz, normal::Jkr, normal::Hooke, normal::Luding, normal::Edinburgh>;
using CohesionParts =
    PartList<cohesion::None, cohesion::Dmt, cohesion::Sjkr, cohesion::Sjkr2ReducedRadius,
             cohesion::Sjkr2TwiceReducedRadius, cohesion::CapillaryWillett, cohesion::CapillaryWillettClosed,
             cohesion::CapillaryRabinovich, cohesion::CapillarySoulie, cohesion::Hamaker>;
using DampingParts = PartList<damping::Restitution, damping::None>;
using SlidingParts = PartList<sliding::TotalSpring, sliding::IncrementalSpring, sliding::RescaledSpring,
                              sliding::Viscous, sliding::None>;
using RollingParts =
    PartList<rolling::ElasticPlastic, rolling::ElasticPlasticViscous, rolling::ConstantTorque, rolling::None>;
using TwistingParts = PartList<twisting::None, twisting::ElasticPlastic>;

/// Where the constants of each part stand in those of the whole law.
enum class Place { whole, normal, cohesion, damping, sliding, rolling, twisting, count };

/// Constants of a law for one pair of species: what the `Pair` of each part holds, as plain doubles.
inline constexpr std::size_t constants_per_part = 24;
using PairConstants = std::array<double, constants_per_part* static_cast<std::size_t>(Place::count)>;

/// Puts the constants of one part into those of its law.
template <class Pair>
void pack(const Pair& pair, Place place, PairConstants& constants) {
  static_assert(sizeof(Pair) <= constants_per_part * sizeof(double));
  std::memcpy(constants.data() + constants_per_part * static_cast<std::size_t>(place), &pair, sizeof pair);
}

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
  std::span<const Parameter> parameters;
};
struct NormalEntry : PartEntry {
  bool adhesive;   ///< has cohesion of its own
  bool remembers;  ///< uses the numbers of the history that are the normal law's
  void (*mix)(const MaterialPair&, const Choices&, PairConstants&);
  Stiffness (*stiffness)(const MaterialPair&, const Choices&);
  double (*separation_gap)(double radius, const PairConstants&);
  Normal (*normal)(const Touch&, const PairConstants&, double& plastic, double& adhesion);
};
struct CohesionEntry : PartEntry {
  bool acts, reaches, needs_sizes, is_viscous, has_pull_off;
  CohesionLimit standard_limit;
  void (*mix)(const MaterialPair&, const Choices&, PairConstants&);
  double (*longest_gap)(double radius, const PairConstants&);
  bool (*acts_on_approach)(const PairConstants&);
  double (*separation_gap)(const Touch&, const PairConstants&);
  double (*formation_gap)(const Touch&, const PairConstants&);
  Attraction (*attraction)(const Touch&, const PairConstants&);
};
struct FollowingEntry : PartEntry {
  void (*mix)(const MaterialPair&, const Choices&, const Stiffness&, PairConstants&);
};
struct DampingEntry : FollowingEntry {
  Dashpots (*coefficients)(const Normal&, double mass, const PairConstants&);
};
struct SlidingEntry : FollowingEntry {
  bool remembers_grip;
  Vec3 (*slide)(const Touch&, const Vec3& slip_velocity, double contact_size, double limiting_force,
                double dashpot, const PairConstants&, Vec3& spring, double& grip);
};
struct RollingEntry : FollowingEntry {
  bool needs_sizes;
  Vec3 (*roll)(const Touch&, double contact_size, double limiting_force, const PairConstants&, Vec3& spring);
};
struct TwistingEntry : FollowingEntry {
  bool acts;
  double (*twist)(const Touch&, double contact_size, double limiting_force, double dashpot,
                  const PairConstants&, double& spring);
};

/// All parts, in the order of the lists above, which is also that of the kernels.
struct Catalogue {
  std::vector<NormalEntry> normal;
  std::vector<CohesionEntry> cohesion;
  std::vector<DampingEntry> damping;
  std::vector<SlidingEntry> sliding;
  std::vector<RollingEntry> rolling;
  std::vector<TwistingEntry> twisting;
};
const Catalogue& catalogue();

/// A contact law: one part of each kind.
struct Law {
  const NormalEntry* normal = nullptr;
  const CohesionEntry* cohesion = nullptr;
  const DampingEntry* damping = nullptr;
  const SlidingEntry* sliding = nullptr;
  const RollingEntry* rolling = nullptr;
  const TwistingEntry* twisting = nullptr;

  std::array<const PartEntry*, 6> parts() const {
    return {normal, cohesion, damping, sliding, rolling, twisting};
  }
  PairConstants mix(const MaterialPair& material, const Choices& choices) const;
  /// Whether a contact has to store a Memory besides its History.
  bool remembers() const { return normal->remembers || sliding->remembers_grip; }
  /// Bound of the gap up to which a contact lasts, m, for parcels and reduced radii up to `radius`.
  double separation_gap(double radius, const PairConstants&) const;
  /// Bound of the gap at which a contact begins on approach, m; 0 for most laws.
  double formation_gap(double radius, const PairConstants&) const;
  /// The normal law alone, without memory and mass: for laws that ask for neither.
  Normal normal_force(double overlap, double radius, const PairConstants&) const;
  /// The law for one contact, part after part: what the kernels do for many at once, to the same bits.
  Response evaluate(const Touch& touch, const Past& old, const PairConstants& constants) const;
  /// The numbers for parcels alpha times larger than the grains. Each parameter follows its rule (similarity.hpp);
  /// whatever else the pair holds stays. Only if why_not() says nothing.
  MaterialPair for_parcels(const MaterialPair& grains, double alpha, Similarity similarity) const;
  /// Why the law knows no such similarity, as part of a sentence; empty if it does.
  std::string why_not(Similarity similarity) const;
  /// What is wrong with a choice of parts and the properties of a pair, one sentence each; empty if nothing is.
  std::vector<std::string> problems(const MaterialPair& material, const Choices& choices) const;
};

/// Names of the parts of a law.
struct LawNames {
  std::string_view normal = "hertz", damping = "restitution", sliding = "total_spring", rolling = "none",
                   cohesion = "none", twisting = "none";
};

/// The law with these parts. Throws std::invalid_argument if there is none.
Law find_law(const LawNames& names);
inline Law find_law(std::string_view normal, std::string_view damping, std::string_view sliding,
                    std::string_view rolling, std::string_view cohesion = "none",
                    std::string_view twisting = "none") {
  return find_law({normal, damping, sliding, rolling, cohesion, twisting});
}

}  // namespace pulvis::laws
