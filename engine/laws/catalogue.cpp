// SPDX-License-Identifier: Apache-2.0
#include "engine/laws/catalogue.hpp"

#include <stdexcept>
#include <string>

namespace pulvis::laws {
namespace {

template <class Pair>
void pack(const Pair& pair, Place place, PairConstants& constants) {
  static_assert(sizeof(Pair) <= constants_per_part * sizeof(double));
  std::memcpy(constants.data() + constants_per_part * static_cast<std::size_t>(place), &pair, sizeof pair);
}

template <NormalPart Part>
NormalEntry normal_entry(std::size_t index) {
  using Pair = typename Part::Pair;
  return {{Part::name, index},
          [](const MaterialPair& material, const Choices& choices, PairConstants& constants) {
            pack(Part::mix(material, choices), Place::normal, constants);
          },
          Part::stiffness,
          [](double radius, const PairConstants& c) {
            return Part::separation_gap(radius, unpack<Pair>(c.data(), Place::normal));
          },
          [](double overlap, double radius, const PairConstants& c) {
            return Part::normal(overlap, radius, unpack<Pair>(c.data(), Place::normal));
          }};
}

template <FollowingPart Part, Place place>
FollowingEntry following_entry(std::size_t index) {
  return {{Part::name, index},
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
  return {following_entry<Part, Place::sliding>(index),
          [](const Touch& touch, const Vec3& slip, double size, double limit, double dashpot,
             const PairConstants& c, Vec3& xi) {
            return Part::slide(touch, slip, size, limit, dashpot,
                               unpack<typename Part::Pair>(c.data(), Place::sliding), xi);
          }};
}

template <FollowingPart Part>
RollingEntry rolling_entry(std::size_t index) {
  return {following_entry<Part, Place::rolling>(index),
          [](const Touch& touch, double size, double limit, const Vec3& old, const PairConstants& c) {
            return Part::roll(touch, size, limit, old, unpack<typename Part::Pair>(c.data(), Place::rolling));
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
    fill(DampingParts{}, c.damping, []<class P>(std::size_t k) { return damping_entry<P>(k); });
    fill(SlidingParts{}, c.sliding, []<class P>(std::size_t k) { return sliding_entry<P>(k); });
    fill(RollingParts{}, c.rolling, []<class P>(std::size_t k) { return rolling_entry<P>(k); });
    return c;
  }();
  return all;
}

Law find_law(std::string_view normal, std::string_view damping, std::string_view sliding,
             std::string_view rolling) {
  const Catalogue& all = catalogue();
  return {find_part(all.normal, "normal", normal), find_part(all.damping, "damping", damping),
          find_part(all.sliding, "sliding", sliding), find_part(all.rolling, "rolling", rolling)};
}

PairConstants Law::mix(const MaterialPair& material, const Choices& choices) const {
  PairConstants constants{};
  pack(Whole{choices.limit_includes_dashpot ? 1.0 : 0.0}, Place::whole, constants);
  normal->mix(material, choices, constants);
  const Stiffness stiffness = normal->stiffness(material);
  damping->mix(material, choices, stiffness, constants);
  sliding->mix(material, choices, stiffness, constants);
  rolling->mix(material, choices, stiffness, constants);
  return constants;
}

double Law::separation_gap(double radius, const PairConstants& constants) const {
  return normal->separation_gap(radius, constants);
}

Normal Law::normal_force(double overlap, double radius, const PairConstants& constants) const {
  return normal->normal(overlap, radius, constants);
}

Response Law::evaluate(const Touch& touch, const History& old, const PairConstants& constants) const {
  const Whole whole = unpack<Whole>(constants.data(), Place::whole);
  const double touching = touches(touch.overlap, touch.was_touching, separation_gap(touch.radius, constants));
  const Normal n = normal->normal(touch.overlap, touch.radius, constants);

  const Dashpots c = damping->coefficients(n, touch.mass, constants);
  const double closing = closing_speed(touch);
  const Vec3 slip = slip_velocity(touch, closing);
  const double dashpot = c.normal * closing;
  const double limit = limiting_force(n, dashpot, whole);

  Vec3 spring = old.slide;
  const Vec3 tangential = sliding->slide(touch, slip, n.contact_size, limit, c.tangential, constants, spring);
  const Vec3 torque = rolling->roll(touch, n.contact_size, limit, old.roll, constants);

  return {touching,
          touching * (tangential - (n.elastic + dashpot) * touch.normal),
          touching * tangential,
          touching * torque,
          {touching * spring, touching * torque}};
}

}  // namespace pulvis::laws
