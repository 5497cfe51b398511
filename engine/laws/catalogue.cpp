// SPDX-License-Identifier: Apache-2.0
#include "engine/laws/catalogue.hpp"

#include <stdexcept>
#include <string>

namespace pulvis::laws {
namespace {

template <NamedPart Part>
PartEntry part_entry(std::size_t index) {
  return {Part::name, index, Part::parameters};
}

template <NormalPart Part>
NormalEntry normal_entry(std::size_t index) {
  using Pair = typename Part::Pair;
  return {part_entry<Part>(index),
          Part::adhesive,
          Part::remembers,
          [](const MaterialPair& material, const Choices& choices, PairConstants& constants) {
            pack(Part::mix(material, choices), Place::normal, constants);
          },
          Part::stiffness,
          [](double radius, const PairConstants& c) {
            return Part::separation_gap(radius, unpack<Pair>(c.data(), Place::normal));
          },
          [](const Touch& touch, const PairConstants& c, double& plastic, double& adhesion) {
            return Part::normal(touch, unpack<Pair>(c.data(), Place::normal), plastic, adhesion);
          }};
}

template <CohesionPart Part>
CohesionEntry cohesion_entry(std::size_t index) {
  using Pair = typename Part::Pair;
  return {
      part_entry<Part>(index),
      Part::acts,
      Part::reaches,
      Part::needs_sizes,
      Part::is_viscous,
      Part::has_pull_off,
      Part::standard_limit,
      [](const MaterialPair& material, const Choices& choices, PairConstants& constants) {
        pack(Part::mix(material, choices), Place::cohesion, constants);
      },
      [](double radius, const PairConstants& c) {
        return Part::longest_gap(radius, unpack<Pair>(c.data(), Place::cohesion));
      },
      [](const PairConstants& c) { return Part::acts_on_approach(unpack<Pair>(c.data(), Place::cohesion)); },
      [](const Touch& touch, const PairConstants& c) {
        return Part::separation_gap(touch, unpack<Pair>(c.data(), Place::cohesion));
      },
      [](const Touch& touch, const PairConstants& c) {
        return Part::formation_gap(touch, unpack<Pair>(c.data(), Place::cohesion));
      },
      [](const Touch& touch, const PairConstants& c) {
        return Part::attraction(touch, unpack<Pair>(c.data(), Place::cohesion));
      }};
}

template <FollowingPart Part, Place place>
FollowingEntry following_entry(std::size_t index) {
  return {part_entry<Part>(index),
          [](const MaterialPair& material, const Choices& choices, const Stiffness& stiffness,
             PairConstants& constants) { pack(Part::mix(material, choices, stiffness), place, constants); }};
}

template <FollowingPart Part>
DampingEntry damping_entry(std::size_t index) {
  return {following_entry<Part, Place::damping>(index),
          [](const Normal& normal, double mass, const PairConstants& c) {
            return Part::coefficients(normal, mass, unpack<typename Part::Pair>(c.data(), Place::damping));
          }};
}

template <FollowingPart Part>
SlidingEntry sliding_entry(std::size_t index) {
  return {following_entry<Part, Place::sliding>(index), Part::remembers_grip,
          [](const Touch& touch, const Vec3& slip, double size, double limit, double dashpot,
             const PairConstants& c, Vec3& spring, double& grip) {
            return Part::slide(touch, slip, size, limit, dashpot,
                               unpack<typename Part::Pair>(c.data(), Place::sliding), spring, grip);
          }};
}

template <FollowingPart Part>
RollingEntry rolling_entry(std::size_t index) {
  return {following_entry<Part, Place::rolling>(index), Part::needs_sizes,
          [](const Touch& touch, double size, double limit, const PairConstants& c, Vec3& spring) {
            return Part::roll(touch, size, limit, unpack<typename Part::Pair>(c.data(), Place::rolling),
                              spring);
          }};
}

template <FollowingPart Part>
TwistingEntry twisting_entry(std::size_t index) {
  return {following_entry<Part, Place::twisting>(index), Part::acts,
          [](const Touch& touch, double size, double limit, double dashpot, const PairConstants& c,
             double& spring) {
            return Part::twist(touch, size, limit, dashpot,
                               unpack<typename Part::Pair>(c.data(), Place::twisting), spring);
          }};
}

/// Fills a list of entries from a list of parts.
template <class... Parts, class Entry, class Make>
void fill(PartList<Parts...>, std::vector<Entry>& list, Make make) {
  (list.push_back(make.template operator()<Parts>(list.size())), ...);
}

template <class Entry>
const Entry* find_part(const std::vector<Entry>& list, const char* kind, std::string_view name) {
  for (const Entry& entry : list)
    if (entry.name == name) return &entry;
  throw std::invalid_argument("no contact law with the " + std::string(kind) + " part " + std::string(name));
}

}  // namespace

const Catalogue& catalogue() {
  static const Catalogue all = [] {
    Catalogue c;
    fill(NormalParts{}, c.normal, []<class P>(std::size_t k) { return normal_entry<P>(k); });
    fill(CohesionParts{}, c.cohesion, []<class P>(std::size_t k) { return cohesion_entry<P>(k); });
    fill(DampingParts{}, c.damping, []<class P>(std::size_t k) { return damping_entry<P>(k); });
    fill(SlidingParts{}, c.sliding, []<class P>(std::size_t k) { return sliding_entry<P>(k); });
    fill(RollingParts{}, c.rolling, []<class P>(std::size_t k) { return rolling_entry<P>(k); });
    fill(TwistingParts{}, c.twisting, []<class P>(std::size_t k) { return twisting_entry<P>(k); });
    return c;
  }();
  return all;
}

Law find_law(const LawNames& names) {
  const Catalogue& all = catalogue();
  return {
      find_part(all.normal, "normal", names.normal),    find_part(all.cohesion, "cohesion", names.cohesion),
      find_part(all.damping, "damping", names.damping), find_part(all.sliding, "sliding", names.sliding),
      find_part(all.rolling, "rolling", names.rolling), find_part(all.twisting, "twisting", names.twisting)};
}

}  // namespace pulvis::laws
