// SPDX-License-Identifier: Apache-2.0
// What stops a run that leads nowhere, with what a person needs to know about it.
#include <fmt/format.h>

#include <cmath>

#include "engine/base/failure.hpp"
#include "engine/simulation/simulation.hpp"

namespace pulvis {
namespace {

bool is_finite(const Vec3& v) { return std::isfinite(dot(v, v)); }

/// "jkr with capillary_willett"
std::string name_of(const laws::Law& law) {
  const std::string normal(law.normal->name), cohesion(law.cohesion->name);
  return cohesion == "none" ? normal : normal + " with " + cohesion;
}

}  // namespace

std::string Simulation::surroundings_of(std::size_t parcel) const {
  const Parcel& p = state_.parcels.body[parcel];
  std::string partners, law;
  constexpr int most = 4;  // more say no more
  int named = 0;
  const auto add = [&](const std::string& partner, std::uint32_t species) {
    if (named++ >= most) return;
    partners += (partners.empty() ? "" : ", ") + partner;
    law = name_of(model_.classes.all()[model_.classes.index(p.species, species)].law);
  };
  // After a rebuild that failed half-way the lists may be of another store.
  if (pairs_.begin.size() == state_.parcels.size() + 1)
    for (std::uint32_t k = pairs_.begin[parcel]; k < pairs_.begin[parcel + 1]; ++k) {
      const std::uint32_t slot = pairs_.entry[k] >> 1;
      if (!pairs_.touching[slot]) continue;
      const Parcel& q = state_.parcels.body[pairs_.partner(pairs_.entry[k])];
      add(fmt::format("parcel {}", q.id), q.species);
    }
  if (walls_.begin.size() == state_.parcels.size() + 1)
    for (std::uint32_t slot = walls_.begin[parcel]; slot < walls_.begin[parcel + 1]; ++slot) {
      const Surface& surface = model_.walls.surfaces[walls_.surface[slot]];
      if (walls_.touching[slot]) add(surface.name, surface.species);
    }
  if (named == 0) return "it touches nothing";
  return fmt::format("it touches {}{}; law {}", partners,
                     named > most ? fmt::format(" and {} more", named - most) : "", law);
}

void Simulation::fail_at(const char* what, const char* remedy, const Parcel& p) const {
  const auto index = static_cast<std::size_t>(&p - state_.parcels.body.data());
  throw Failure(
      Exit::physics,
      fmt::format("{}: parcel {} at t = {:.6g} s, position ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.6g}, "
                  "{:.6g}, {:.6g}) m/s, radius {:.4g} m; {}\n  {}",
                  what, p.id, time(), p.position.x, p.position.y, p.position.z, p.velocity.x, p.velocity.y,
                  p.velocity.z, p.radius, surroundings_of(index), remedy));
}

void Simulation::require_sound() const {
  require_finite();
  require_shallow();
}

void Simulation::require_finite() const {
  const Parcel* bad = nullptr;
  for (const Parcel& p : state_.parcels.body)
    if (!(is_finite(p.position) && is_finite(p.velocity) && is_finite(p.spin)) && (!bad || p.id < bad->id))
      bad = &p;
  if (bad)
    fail_at("position, velocity or spin is not a finite number",
            "the time step may be too large (lower time.fraction) or a material constant out of range", *bad);
}

void Simulation::require_shallow() const {
  double deepest = model_.largest_overlap;
  const Parcel* worst = nullptr;
  for (std::size_t s = 0; s < pairs_.slots(); ++s) {
    if (!pairs_.touching[s]) continue;
    const Parcel &p = state_.parcels.body[pairs_.first[s]], &q = state_.parcels.body[pairs_.second[s]];
    const double overlap = p.radius + q.radius - norm(images_(q.position - p.position));
    const double share = overlap / least(p.radius, q.radius);
    // Ids decide between equals, so that the message does not depend on how the store is sorted.
    if (share < deepest || (share == deepest && (!worst || p.id > worst->id))) continue;
    deepest = share;
    worst = &p;
  }
  if (worst)
    fail_at(fmt::format("parcels overlap by {:.0f} % of a radius", 100.0 * deepest).c_str(),
            "the powder is too soft for what presses it, or something squeezes it: raise simulated_modulus, "
            "or look at "
            "what moves there",
            *worst);
}

void Simulation::require_slow_walls() const {
  for (std::size_t b = 0; b < poses_.size(); ++b)
    for (const Vec3& corner : body_corners_[b]) {
      const double way = norm(poses_[b].now(corner) - poses_[b].before(corner));
      if (way <= 0.5 * model_.smallest_radius) continue;
      throw Failure(
          Exit::physics,
          fmt::format(
              "the body {} moves {:.4g} m in the time step at t = {:.6g} s, more than half the smallest "
              "radius ({:.4g} m): powder would pass through it\n  lower the speed of its motions, or "
              "time.fraction",
              model_.walls.bodies[b].name, way, time(), model_.smallest_radius));
    }
}

}  // namespace pulvis
