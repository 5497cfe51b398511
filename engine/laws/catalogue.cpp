// SPDX-License-Identifier: Apache-2.0
#include "engine/laws/catalogue.hpp"

#include <cstring>
#include <stdexcept>
#include <string>

namespace pulvis::laws {
namespace {

template <class Law>
typename Law::Pair unpack(const PairConstants& constants) {
  typename Law::Pair pair;
  std::memcpy(static_cast<void*>(&pair), constants.data(), sizeof pair);
  return pair;
}

template <class Law>
LawEntry entry() {
  static_assert(sizeof(typename Law::Pair) <= sizeof(PairConstants));
  return {Law::NormalType::name,
          Law::DampingType::name,
          Law::SlidingType::name,
          Law::RollingType::name,
          [](const MaterialPair& pair, const Choices& choices) {
            PairConstants constants{};
            const auto mixed = Law::mix(pair, choices);
            std::memcpy(constants.data(), &mixed, sizeof mixed);
            return constants;
          },
          [](double radius, const PairConstants& constants) {
            return Law::NormalType::separation_gap(radius, unpack<Law>(constants).normal);
          },
          [](const Touch& touch, const History& history, const PairConstants& constants) {
            return Law::evaluate(touch, history, unpack<Law>(constants));
          },
          [](double overlap, double radius, const PairConstants& constants) {
            return Law::NormalType::normal(overlap, radius, unpack<Law>(constants).normal);
          }};
}

}  // namespace

const std::vector<LawEntry>& catalogue() {
  static const std::vector<LawEntry> entries = [] {
    std::vector<LawEntry> list;
    for_each_law([&]<class Law>() { list.push_back(entry<Law>()); });
    return list;
  }();
  return entries;
}

std::size_t find_law(std::string_view normal, std::string_view damping, std::string_view sliding,
                     std::string_view rolling) {
  const auto& list = catalogue();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto& law = list[k];
    if (law.normal == normal && law.damping == damping && law.sliding == sliding && law.rolling == rolling)
      return k;
  }
  throw std::invalid_argument("no contact law with the parts " + std::string(normal) + ", " +
                              std::string(damping) + ", " + std::string(sliding) + ", " +
                              std::string(rolling));
}

}  // namespace pulvis::laws
