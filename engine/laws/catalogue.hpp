// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "engine/laws/contact_law.hpp"
#include "engine/laws/damping/restitution.hpp"
#include "engine/laws/normal/hertz.hpp"
#include "engine/laws/normal/jkr.hpp"
#include "engine/laws/rolling/elastic_plastic.hpp"
#include "engine/laws/sliding/total_spring.hpp"

// The catalogue: every part of a contact law that exists. A law is any choice of one part from each list;
// all of them are compiled. To add a part: write its file, include it above, name it in its list.
namespace pulvis::laws {

template <class... Parts>
struct PartList {
  static constexpr std::size_t size = sizeof...(Parts);
};

using NormalParts = PartList<normal::Hertz, normal::Jkr>;
using DampingParts = PartList<damping::Restitution, damping::None>;
using SlidingParts = PartList<sliding::TotalSpring, sliding::None>;
using RollingParts = PartList<rolling::ElasticPlastic, rolling::None>;

/// Calls `visit.template operator()<Law>()` for every law, in the catalogue's fixed order.
template <class Visitor>
constexpr void for_each_law(Visitor&& visit) {
  [&]<class... N>(PartList<N...>) {
    (
        [&]<class Norm>() {
          [&]<class... D>(PartList<D...>) {
            (
                [&]<class Damp>() {
                  [&]<class... S>(PartList<S...>) {
                    (
                        [&]<class Slid>() {
                          [&]<class... R>(PartList<R...>) {
                            (visit.template operator()<ContactLaw<Norm, Damp, Slid, R>>(), ...);
                          }(RollingParts{});
                        }.template operator()<S>(),
                        ...);
                  }(SlidingParts{});
                }.template operator()<D>(),
                ...);
          }(DampingParts{});
        }.template operator()<N>(),
        ...);
  }(NormalParts{});
}

inline constexpr std::size_t law_count =
    NormalParts::size * DampingParts::size * SlidingParts::size * RollingParts::size;

/// Constants of a law for one pair of species: what its `Pair` holds, as plain doubles.
inline constexpr std::size_t most_pair_constants = 24;
using PairConstants = std::array<double, most_pair_constants>;

/// One law as the rest of the program sees it: by name, without its type.
struct LawEntry {
  std::string_view normal, damping, sliding, rolling;
  PairConstants (*mix)(const MaterialPair&, const Choices&);
  double (*separation_gap)(double radius, const PairConstants&);
  Response (*evaluate)(const Touch&, const History&, const PairConstants&);
  Normal (*normal_force)(double overlap, double radius, const PairConstants&);
};

/// All laws; the index is the one the kernels use.
const std::vector<LawEntry>& catalogue();

/// Index of the law with these parts. Throws std::invalid_argument if there is none.
std::size_t find_law(std::string_view normal, std::string_view damping, std::string_view sliding,
                     std::string_view rolling);

}  // namespace pulvis::laws
