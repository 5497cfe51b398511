// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/energy_works.hpp"

#include <algorithm>

#include "engine/base/parallel.hpp"
#include "engine/contacts/wall_sight.hpp"

namespace pulvis {
namespace {

using kernels::EnergyBlock;
using kernels::EnergyTerm;
using kernels::load;
using kernels::store;

}  // namespace

EnergyWorks::EnergyWorks(const ContactClasses& classes, int most_threads, SumGrid grid) : grid_(grid) {
  for (const ContactClass& c : classes.all())
    kernel_.push_back(kernels::energy_kernel(c.law, kernels::instruction_set()));
  scratch_.resize(static_cast<std::size_t>(std::max(most_threads, 1)));
  for (Scratch& s : scratch_) s.block.resize(kernel_.size());
}

bool EnergyWorks::splits_contacts() const {
  return std::all_of(kernel_.begin(), kernel_.end(),
                     [](const kernels::EnergyKernel& k) { return k.splits_contacts(); });
}

void EnergyWorks::before_contacts(const NearPairs& pairs, const NearWalls& walls) {
  pasts_ = pairs.pasts;
  touching_ = pairs.touching;
  wall_touching_ = walls.touching;
  wall_history_ = walls.history;
  wall_memory_ = walls.memory;
}

void EnergyWorks::stage_pair(const ContactView& view, std::size_t slot, EnergyBlock& b) const {
  const int k = b.count++;
  const std::uint32_t i = view.near_pairs.first[slot], j = view.near_pairs.second[slot];
  const Parcel &p = middle_[i], &q = middle_[j], &p_end = view.parcels.body[i], &q_end = view.parcels.body[j];
  store(b.offset, k, q.position - p.position);
  store(b.linear, k, p.velocity - q.velocity);
  store(b.end_linear, k, p_end.velocity - q_end.velocity);
  store(b.spin_first, k, p.spin);
  store(b.spin_second, k, q.spin);
  store(b.end_spin_first, k, p_end.spin);
  store(b.end_spin_second, k, q_end.spin);
  b.radius_first[k] = p.radius;
  b.radius_second[k] = q.radius;
  b.mass_first[k] = p.mass;
  b.mass_second[k] = q.mass;
  b.touching_before[k] = touching_[slot] ? 1.0 : 0.0;
  b.touching[k] = view.near_pairs.touching[slot] && !ends_all_ ? 1.0 : 0.0;
  kernels::put_past(b.before, pasts_.remembers ? &b.memory_before : nullptr, k, pasts_.of(slot));
}

void EnergyWorks::pairs(const ContactView& view, std::size_t from, std::size_t to, Scratch& scratch) const {
  const NearPairs& near = view.near_pairs;
  const auto stage = [&](std::size_t slot, std::size_t c) {
    if (!touching_[slot] && !near.touching[slot]) return;
    stage_pair(view, slot, scratch.block[c]);
    if (scratch.block[c].count == kernels::block_size) flush(view, c, false, scratch);
  };
  for (std::size_t group = 0; group < near.group_begin.size(); ++group) {
    const std::size_t c = near.class_of(group);
    for (std::size_t slot = std::max(from, near.group_begin[group]);
         slot < std::min(to, near.group_end[group]); ++slot)
      stage(slot, c);
  }
  for (std::size_t slot = std::max(from, near.first_late()); slot < to; ++slot)
    stage(slot, view.classes.index(view.parcels.body[near.first[slot]].species,
                                   view.parcels.body[near.second[slot]].species));
  for (std::size_t c = 0; c < scratch.block.size(); ++c) flush(view, c, false, scratch);
}

/// A contact on an edge may be handed over to the next surface of the same body, with what it remembers: finds, for
/// each slot of a parcel from `begin` on, the slot where that stood.
void EnergyWorks::find_sources(const ContactView& view, std::uint32_t begin, std::uint32_t end,
                               Scratch& scratch) const {
  const NearWalls& near = view.near_walls;
  scratch.source.resize(end - begin);
  for (std::uint32_t slot = begin; slot < end; ++slot) scratch.source[slot - begin] = slot;
  if (ends_all_) return;
  const auto body = [&](std::uint32_t slot) { return view.walls.surfaces[near.surface[slot]].body; };
  for (std::uint32_t slot = begin; slot < end; ++slot) {
    if (wall_touching_[slot] || !near.touching[slot]) continue;
    for (std::uint32_t other = begin; other < end; ++other)
      if (wall_touching_[other] && !near.touching[other] && body(other) == body(slot) &&
          scratch.source[other - begin] == other) {
        std::swap(scratch.source[slot - begin], scratch.source[other - begin]);
        break;
      }
  }
}

void EnergyWorks::stage_wall(const ContactView& view, std::uint32_t slot, std::uint32_t source,
                             EnergyBlock& b) const {
  const NearWalls& near = view.near_walls;
  const std::uint32_t i = near.parcel[slot];
  const Parcel &p = middle_[i], &p_end = view.parcels.body[i];
  const std::size_t body = view.walls.surfaces[near.surface[slot]].body;
  const Pose &pose = view.poses[body], &next = view.next_poses[body];
  const Vec3 at = pose.now.back(p.position), before_at = pose.before.back(p.position - view.dt * p.velocity);
  const WallSight sight = look(view.walls, near, slot, at);
  if (sight.distance == 0.0) return;
  const WallSight half = look(view.walls, near, slot, 0.5 * (before_at + at));
  const int k = b.count++;
  const Vec3 normal = pose.now.turn(sight.offset / sight.distance);
  const Vec3 half_normal = normal_in_the_middle(view.walls, near, slot, sight, half, pose);
  const Vec3 wall_end =
      0.5 * (pose.velocity(half.nearest.point, view.dt) + next.velocity(sight.nearest.point, view.dt));
  const Vec3 wall_spin_end = 0.5 * (pose.spin + next.spin);
  store(b.normal, k, normal);
  store(b.half_normal, k, half_normal);
  store(b.velocity, k,
        p.velocity - pose.velocity(half.nearest.point, view.dt) + cross(half.distance * p.spin, half_normal));
  store(b.end_velocity, k, p_end.velocity - wall_end + cross(sight.distance * p_end.spin, normal));
  store(b.spin, k, p.spin - pose.spin);
  store(b.end_spin, k, p_end.spin - wall_spin_end);
  b.overlap[k] = p.radius - sight.distance;
  b.overlap_before[k] = p.radius - look(view.walls, near, slot, before_at).distance;
  b.radius[k] = b.radius_first[k] = p.radius;
  b.mass[k] = b.mass_first[k] = p.mass;
  b.radius_second[k] = b.mass_second[k] = 0.0;
  b.shared_spin[k] = 0.5 * dot(p.spin + pose.spin, half_normal);
  b.touching_before[k] = wall_touching_[source] ? 1.0 : 0.0;
  b.touching[k] = near.touching[slot] && !ends_all_ ? 1.0 : 0.0;
  kernels::put_past(b.before, wall_memory_.used ? &b.memory_before : nullptr, k,
                    past_at(wall_history_, wall_memory_, source));
  const Load& load = near.load[slot];
  const Vec3 rolling = load.torque - sight.distance * cross(normal, load.force);
  b.term[static_cast<std::size_t>(EnergyTerm::walls)][k] =
      b.touching[k] * (dot(load.force, wall_end) + dot(rolling, wall_spin_end)) * view.dt;
}

void EnergyWorks::walls(const ContactView& view, std::uint32_t parcel, Scratch& scratch) const {
  const NearWalls& near = view.near_walls;
  const std::uint32_t begin = near.begin[parcel], end = near.begin[parcel + 1];
  if (begin == end) return;
  find_sources(view, begin, end, scratch);
  for (std::uint32_t slot = begin; slot < end; ++slot) {
    const std::uint32_t source = scratch.source[slot - begin];
    if (!wall_touching_[source] && !near.touching[slot]) continue;
    const std::uint32_t c = view.classes.index(view.parcels.body[parcel].species,
                                               view.walls.surfaces[near.surface[slot]].species);
    stage_wall(view, slot, source, scratch.block[c]);
    if (scratch.block[c].count == kernels::block_size) flush(view, c, true, scratch);
  }
}

void EnergyWorks::flush(const ContactView& view, std::size_t c, bool walls, Scratch& scratch) const {
  EnergyBlock& b = scratch.block[c];
  if (b.count == 0) return;
  b.period = view.nearest.length;
  const double* constants = view.classes.all()[c].constants.data();
  if (walls)
    kernel_[c].walls(b, constants, view.dt, grid_, scratch.sums);
  else
    kernel_[c].pairs(b, constants, view.dt, grid_, scratch.sums);
  b.count = 0;
}

kernels::EnergySums EnergyWorks::after_step(const ContactView& view) {
  for (Scratch& s : scratch_) s.sums = {};
  parallel_shares(view.near_pairs.slots(), view.threads, [&](std::size_t from, std::size_t to, int thread) {
    pairs(view, from, to, scratch_[static_cast<std::size_t>(thread)]);
  });
  parallel_shares(view.parcels.size(), view.threads, [&](std::size_t from, std::size_t to, int thread) {
    Scratch& scratch = scratch_[static_cast<std::size_t>(thread)];
    for (std::size_t i = from; i < to; ++i) walls(view, static_cast<std::uint32_t>(i), scratch);
    for (std::size_t c = 0; c < scratch.block.size(); ++c) flush(view, c, true, scratch);
  });
  kernels::EnergySums all;
  for (const Scratch& s : scratch_) all.add(s.sums);
  return all;
}

/// As if all contacts ended now otherwise than by their laws, in a step in which nothing moves.
double EnergyWorks::stored(const ContactView& view) {
  before_contacts(view.near_pairs, view.near_walls);
  before_kick(view.parcels);
  for (Parcel& p : middle_) p.velocity = p.spin = {};
  ends_all_ = true;
  ContactView now{view};
  std::vector<Pose> resting(view.poses.begin(), view.poses.end());
  for (Pose& pose : resting) pose.before = pose.now, pose.spin = {}, pose.turns = false;
  now.poses = now.next_poses = resting;
  const kernels::EnergySums sums = after_step(now);
  ends_all_ = false;
  const auto value = [&](EnergyTerm t) { return grid_.value(sums.of[static_cast<std::size_t>(t)]); };
  return value(EnergyTerm::forgotten_springs) + value(EnergyTerm::separation) -
         value(EnergyTerm::changed_contacts);
}

}  // namespace pulvis
