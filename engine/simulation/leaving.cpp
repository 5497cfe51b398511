// SPDX-License-Identifier: Apache-2.0
// Parcels that leave: out of the domain, or through a wall.
#include <algorithm>

#include "engine/simulation/simulation.hpp"

namespace pulvis {

void Simulation::take_out_escaped(const StepNotice& notice) {
  pairs_.settle_late(state_.parcels);
  require_finite();
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < state_.parcels.size(); ++i) {
    const Parcel& p = state_.parcels.body[i];
    const Vec3 &x = p.position, &low = model_.domain.min, &high = model_.domain.max;
    if (notice.too_fast && norm(p.velocity - model_.domain.flow_velocity(x)) * model_.dt > 0.5 * p.radius)
      fail_at("a parcel moved more than half its radius in one time step",
              "lower time.fraction, or raise the modulus if parcels overlap deeply; see `pulvis check`", p);
    if (x.x < low.x || x.x > high.x || x.y < low.y || x.y > high.y || x.z < low.z || x.z > high.z)
      out.push_back(static_cast<std::uint32_t>(i));
  }
  for (const std::uint32_t i : out) {
    const Parcel& p = state_.parcels.body[i];
    state_.escapes.push_back({p.id, time() + model_.dt, p.position, p.velocity, "domain"});
  }
  remove(out, Velocities::of_middle);
}

void Simulation::take_out_crossed() {
  std::vector<std::uint32_t> out;
  for (const Crossing& c : crossings_) {
    if (!out.empty() && out.back() == c.parcel) continue;
    const Parcel& p = state_.parcels.body[c.parcel];
    state_.escapes.push_back({p.id, time(), p.position, p.velocity, model_.walls.surfaces[c.surface].name});
    out.push_back(c.parcel);
  }
  crossings_.clear();
  remove(out, Velocities::of_end);
}

void Simulation::remove(std::vector<std::uint32_t>& indices, Velocities velocities) {
  if (indices.empty()) return;
  const double stored_before = energy_ ? energy_->stored(view()) : 0.0;
  // In order of ids, so that the sum of masses does not depend on how the store is sorted.
  std::sort(indices.begin(), indices.end(), [&](std::uint32_t a, std::uint32_t b) {
    return state_.parcels.body[a].id < state_.parcels.body[b].id;
  });
  std::sort(state_.escapes.end() - static_cast<std::ptrdiff_t>(indices.size()), state_.escapes.end(),
            [](const Escape& a, const Escape& b) { return a.id < b.id; });
  std::vector<bool> gone(state_.parcels.size(), false);
  for (const std::uint32_t i : indices) {
    gone[i] = true;
    ++state_.ledger.escaped;
    state_.ledger.escaped_mass += state_.parcels.body[i].mass;
    account_leaving(state_.parcels.body[i], state_.parcels.load[i], velocities);
  }
  const TouchingList old_pairs = pairs_.pack(state_.parcels, threads()), old_walls = walls_.pack();
  std::vector<std::uint32_t> old_index;
  Parcels kept;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) continue;
    kept.body.push_back(state_.parcels.body[i]);
    kept.load.push_back(state_.parcels.load[i]);
    old_index.push_back(static_cast<std::uint32_t>(i));
  }
  state_.parcels = std::move(kept);
  const NearPairs pairs_before = pairs_;
  const NearWalls walls_before = walls_;
  times_.book(Task::leaving);
  const auto stood_at = rebuild(old_pairs, old_walls, std::move(old_index));
  pairs_.take_over_forces(pairs_before, stood_at);
  walls_.take_over_loads(walls_before, stood_at);
  if (energy_) state_.energy.removed += stored_before - energy_->stored(view());
  times_.book(Task::leaving);
}

}  // namespace pulvis
