// SPDX-License-Identifier: Apache-2.0
#include "engine/simulation/energy_ledger.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.hpp"

namespace pulvis {
namespace {

using kernels::EnergyTerm;

/// No term of a parcel exceeds this: it cannot go farther than half its radius in a step. Density generously.
double largest_energy(const Model& model) {
  constexpr double heaviest = 1e6;  // kg/m^3
  return heaviest * sphere_volume(model.largest_radius) * square(model.largest_radius / model.dt);
}

bool has_potential(const Model& model) {
  const Vec3& g = model.body_force.gravity;
  for (int axis = 0; axis < 3; ++axis)
    if (model.domain.periodic[axis] && g[axis] != 0.0) return false;
  return model.body_force.table.empty() && !model.body_force.rotates();
}

Quanta quanta(const EnergyAccount::Total& t) {
  return (static_cast<Quanta>(t.high) << 64) + static_cast<Quanta>(t.low);
}
EnergyAccount::Total total(Quanta q) {
  return {static_cast<std::uint64_t>(q), static_cast<std::int64_t>(q >> 64)};
}

bool is_stored(std::size_t term) { return term <= static_cast<std::size_t>(EnergyTerm::twisting_spring); }
/// Of terms that add the work of a whole kick, half of the last belongs to the step that comes.
bool is_of_kick(std::size_t term) {
  return !is_stored(term) && term <= static_cast<std::size_t>(EnergyTerm::walls);
}

/// W; without the Coriolis force, which does no work.
double power_of_body_forces(const Parcel& p, const ForceField& field) {
  if (!field.rotating) return p.mass * dot(field.at(p.position), p.velocity);
  const Vec3 acceleration = field.at(p.position) - cross(field.spin_rate, p.position - field.point);
  return p.mass * dot(acceleration, p.velocity) - inertia(p) * dot(field.spin_rate, p.spin);
}

double kinetic(const Parcel& p) {
  return 0.5 * p.mass * dot(p.velocity, p.velocity) + 0.5 * inertia(p) * dot(p.spin, p.spin);
}

}  // namespace

double EnergyBalance::put_through() const {
  double all = kinetic();
  for (std::size_t t = 0; t < of.size(); ++t)
    if (t != static_cast<std::size_t>(Term::walls)) all += std::abs(of[t]);
  return all;
}

double EnergyBalance::closing_share() const {
  const double through = put_through();
  return through > 0.0 ? closing_error() / through : 0.0;
}

EnergyLedger::EnergyLedger(const Model& model, int most_threads)
    : gravity_(model.body_force.gravity),
      dt_(model.dt),
      has_potential_(has_potential(model)),
      grid_(SumGrid::for_terms_up_to(largest_energy(model))),
      works_(model.classes, most_threads, grid_),
      shares_(static_cast<std::size_t>(std::max(most_threads, 1))) {}

double EnergyLedger::potential(const Parcel& p, const Vec3& place) const {
  return has_potential_ ? -p.mass * dot(gravity_, place) : 0.0;
}

void EnergyLedger::begin(EnergyAccount& account, const ContactView& view, const ForceField& field) {
  if (account.begun) return;
  account = {};
  account.begun = true;
  account.terms.resize(kernels::energy_terms);
  account.last_terms.resize(kernels::energy_terms);
  // Half of the first kick belongs to the step that comes.
  const Quanta first = work_of_body_forces(view, field);
  account.body_forces = total(first / 2);
  account.last_body_forces = total(first);
  Quanta sum = grid_.count(works_.stored(view));
  for (const Parcel& p : view.parcels.body)
    sum += grid_.count(kinetic(p)) + grid_.count(potential(p, p.position));
  account.start = grid_.value(sum);
}

/// Work of body forces on all parcels over the kick at the end of the step.
Quanta EnergyLedger::work_of_body_forces(const ContactView& view, const ForceField& field) {
  if (has_potential_) return 0;
  std::fill(shares_.begin(), shares_.end(), Quanta{0});
  parallel_shares(view.parcels.size(), view.threads, [&](std::size_t from, std::size_t to, int thread) {
    Quanta sum = 0;
    for (std::size_t i = from; i < to; ++i) {
      sum += grid_.count(power_of_body_forces(view.parcels.body[i], field) * dt_);
    }
    shares_[static_cast<std::size_t>(thread)] = sum;
  });
  Quanta all = 0;
  for (const Quanta share : shares_) all += share;
  return all;
}

void EnergyLedger::after_step(EnergyAccount& account, const ContactView& view, const ForceField& field) {
  const kernels::EnergySums sums = works_.after_step(view);
  for (std::size_t t = 0; t < kernels::energy_terms; ++t) {
    account.last_terms[t] = total(sums.of[t]);
    account.terms[t] = is_stored(t) ? account.last_terms[t] : total(quanta(account.terms[t]) + sums.of[t]);
  }
  const Quanta body = work_of_body_forces(view, field);
  account.last_body_forces = total(body);
  account.body_forces = total(quanta(account.body_forces) + body);
}

void EnergyLedger::insert(EnergyAccount& account, const Parcel& p, const ForceField& field) const {
  account.inserted += kinetic(p) + potential(p, p.position);
  // It gets the second half of this moment's kick, which was reckoned without it.
  if (!has_potential_)
    account.body_forces =
        total(quanta(account.body_forces) + grid_.count(0.5 * dt_ * power_of_body_forces(p, field)));
}

void EnergyLedger::remove(EnergyAccount& account, const Parcel& p, const Vec3& place) const {
  account.removed += kinetic(p) + potential(p, place);
}

EnergyBalance EnergyLedger::balance(const EnergyAccount& account, const Parcels& parcels) const {
  EnergyBalance b;
  Quanta translational = 0, rotational = 0, height = 0;
  for (const Parcel& p : parcels.body) {
    translational += grid_.count(0.5 * p.mass * dot(p.velocity, p.velocity));
    rotational += grid_.count(0.5 * inertia(p) * dot(p.spin, p.spin));
    height += grid_.count(potential(p, p.position));
  }
  b.translational = grid_.value(translational);
  b.rotational = grid_.value(rotational);
  b.potential = grid_.value(height);
  for (std::size_t t = 0; t < account.terms.size(); ++t) {
    b.of[t] = grid_.value(quanta(account.terms[t]));
    if (is_of_kick(t)) b.of[t] -= 0.5 * grid_.value(quanta(account.last_terms[t]));
  }
  b.body_forces =
      grid_.value(quanta(account.body_forces)) - 0.5 * grid_.value(quanta(account.last_body_forces));
  b.start = account.start;
  b.inserted = account.inserted;
  b.removed = account.removed;
  b.has_potential = has_potential_;
  b.splits_contacts = works_.splits_contacts();
  return b;
}

}  // namespace pulvis
