// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/evaluate.hpp"

#include <algorithm>
#include <atomic>

#include "engine/base/parallel.hpp"

namespace pulvis {
namespace {

using kernels::ContactBlock;
using kernels::load;
using kernels::store;

void stage_history(ContactBlock& b, int k, std::uint32_t slot, const NearWalls& near) {
  b.slot[k] = slot;
  b.touching[k] = near.touching[slot] ? 1.0 : 0.0;
  kernels::put_past(*b.springs, b.memory, k, past_at(near.history, near.memory, slot));
}
void keep_history(const ContactBlock& b, int k, std::uint32_t slot, NearWalls& near) {
  near.touching[slot] = b.touching[k] > 0.5;
  put_past_at(near.history, near.memory, slot, kernels::past_of(*b.springs, b.memory, k));
}

/// Evaluates `count` slots from `begin` on, which are one block of near pairs, where they stand. Pairs that do not
/// touch are carried along: to tell them apart would cost more.
void evaluate_block(ContactBlock& b, std::size_t begin, int count, NearPairs& near, const StepOfPairs& step,
                    double approach) {
  const kernels::ContactKernel& kernel = step.contact.kernel;
  const double* constants = step.contact.constants.data();
  const std::size_t block = begin / kernels::block_size;
  b.springs = &near.pasts.springs[block];
  if (begin + kernels::block_size < near.first_apart()) kernels::ask_for(near.pasts.springs[block + 1]);
  if (near.pasts.remembers) b.memory = &near.pasts.memory[block];
  kernel.gather(b, step.parcels.body.data(), near.some(begin, count));
  if (b.slide.any()) kernel.images(b, constants, step.dt);
  kernel.geometry(b, constants, step.dt);
  if (!kernel.any_in_reach(b, approach)) {
    // Another contact's load may lie in their places.
    for (std::size_t slot = begin; slot < begin + static_cast<std::size_t>(count); ++slot)
      near.load_on_first(slot) = near.load_on_second(slot) = {};
    return;
  }
  kernel.evaluate(b, constants, step.dt);
  kernel.scatter(b, &near.places[begin], near.load.data(), &near.touching[begin],
                 near.force.empty() ? nullptr : &near.force[begin]);
}

void stage_pair(Meeting& meeting, std::uint32_t slot, const NearPairs& near) {
  ContactBlock& b = meeting.block;
  const int k = b.count++;
  meeting.first[k] = near.first[slot];
  meeting.second[k] = near.second[slot];
  b.slot[k] = slot;
  meeting.touching[k] = near.touching[slot];
  kernels::put_past(*b.springs, b.memory, k, near.pasts.of(slot));
}

/// Sums of parcels leave out pairs apart unless told of a contact. Of a divided parcel several threads may tell at the same
/// time; all say the same, and nobody asks before all are done.
void note_meeting(NearPairs& near, std::uint32_t parcel) {
  std::atomic_ref(near.meets[parcel]).store(1, std::memory_order_relaxed);
}

void finish_pairs(Meeting& meeting, NearPairs& near, const StepOfPairs& step) {
  ContactBlock& b = meeting.block;
  const kernels::ContactKernel& kernel = step.contact.kernel;
  const double* constants = step.contact.constants.data();
  kernel.gather(b, step.parcels.body.data(), {b.count, meeting.first, meeting.second, meeting.touching, 0});
  if (b.slide.any()) kernel.images(b, constants, step.dt);
  kernel.parcels(b, constants, step.dt);
  for (int k = 0; k < b.count; ++k) {
    const std::size_t slot = b.slot[k], pair = slot - near.first_apart();
    near.touching[slot] = b.touching[k] > 0.5;
    if (!near.touching[slot]) {
      near.pasts.met.forget(pair, step.part);
      continue;
    }
    near.pasts.met.put(pair,
                       {kernels::past_of(*b.springs, b.memory, k),
                        {load(b.force, k), load(b.torque_first, k), load(b.torque_second, k)}},
                       step.part);
    note_meeting(near, meeting.first[k]);
    note_meeting(near, meeting.second[k]);
  }
  b.count = 0;
}

void finish_walls(ContactBlock& b, const ContactClass& contact, NearWalls& near, double dt) {
  contact.kernel.walls(b, contact.constants.data(), dt);
  for (int k = 0; k < b.count; ++k) {
    const std::uint32_t slot = b.slot[k];
    keep_history(b, k, slot, near);
    near.load[slot] = {load(b.force, k), load(b.torque_first, k)};
  }
  b.count = 0;
}

/// Slot of the surface a contact on an edge belongs to: of the surfaces of the same body that share the edge
/// the nearest, else one that is touched on its face, else the one named first. So an edge shared by two
/// faces is one contact, and none while the parcel rests on a face itself.
std::uint32_t owner_of_edge(const NearWalls& near, std::uint32_t begin, std::span<const WallSight> sights,
                            std::uint32_t own, double radius, const Walls& walls) {
  const double same = 1e-9 * radius;
  const Vec3 edge_point = sights[own].nearest.point;
  const std::uint32_t body = walls.surfaces[near.surface[begin + own]].body;
  std::uint32_t best = own;
  for (std::uint32_t other = 0; other < sights.size(); ++other) {
    if (other == own || walls.surfaces[near.surface[begin + other]].body != body) continue;
    if (look(walls, near, begin + other, edge_point).distance > same) continue;
    const WallSight &a = sights[other], &b = sights[best];
    const bool as_near = magnitude(a.distance - b.distance) <= same;
    if (as_near ? (a.nearest.in_face != b.nearest.in_face ? a.nearest.in_face : other < best)
                : a.distance < b.distance)
      best = other;
  }
  return best;
}

void stage_wall(ContactBlock& b, std::uint32_t slot, const Parcel& p, const Walls& walls, const Pose& pose,
                const WallSight& sight, const Vec3& before_at, const Vec3& at, NearWalls& near, double dt) {
  const int k = b.count++;
  stage_history(b, k, slot, near);
  near.touched_facet[slot] = sight.facet;
  const Vec3 normal = pose.now.turn(sight.offset / sight.distance);
  const WallSight half = look(walls, near, slot, 0.5 * (before_at + at));
  store(b.normal, k, normal);
  store(b.half_normal, k, normal_in_the_middle(walls, near, slot, sight, half, pose));
  store(b.velocity, k, p.velocity - pose.velocity(half.nearest.point, dt));
  store(b.spin_first, k, p.spin);
  store(b.spin_second, k, pose.spin);
  b.overlap[k] = p.radius - sight.distance;
  b.radius[k] = p.radius;  // a wall counts as flat: R* = R
  b.mass[k] = p.mass;
  b.arm_first[k] = sight.distance;
  b.arm_second[k] = 0.0;  // the wall's velocity above is that of the point of contact itself
  b.half_arm_first[k] = half.distance;
  b.half_arm_second[k] = 0.0;
}

}  // namespace

ContactEvaluator::ContactEvaluator(int most_threads, std::size_t classes, double approach)
    : parcel_kernel_(kernels::parcel_kernel(kernels::instruction_set())), approach_(approach) {
  scratch_.resize(static_cast<std::size_t>(std::max(most_threads, 1)));
  for (auto& s : scratch_) s.block.resize(classes), s.cursors.resize(2 * classes);
}

Load ContactEvaluator::sum_all(NearPairs& near, const Parcels& parcels, std::uint32_t parcel) {
  Load sum;
  const auto add = [&](std::uint32_t entry) {
    const std::size_t slot = entry >> 1;
    if (!near.touching[slot]) return;
    const bool is_second = entry & 1u;
    if (slot < near.first_apart()) {
      const Load& load = is_second ? near.load_on_second(slot) : near.load_on_first(slot);
      sum.force += load.force, sum.torque += load.torque;
    } else {
      const PairLoad& load = near.pasts.met_at(slot)->load;
      sum.force += is_second ? -load.force : load.force;
      sum.torque += is_second ? load.torque_second : load.torque_first;
    }
  };
  auto late = near.waiting_of(parcel);
  for (std::uint32_t k = near.begin[parcel]; k < near.begin[parcel + 1]; ++k) {
    const std::uint32_t id = parcels.body[near.partner(near.entry[k])].id;
    for (; !late.empty() && late.front().partner_id < id; late = late.subspan(1)) add(late.front().entry);
    add(near.entry[k]);
  }
  for (const auto& waiting : late) add(waiting.entry);
  return sum;
}

void ContactEvaluator::pairs_close(NearPairs& near, std::size_t from, std::size_t to,
                                   const StepOfPairs& step) {
  ContactBlock& b = scratch_[static_cast<std::size_t>(step.part)].pairs;
  b.period = step.images.periods.length;
  b.slide = step.images.slide;
  for (std::size_t begin = from; begin < to; begin += kernels::block_size) {
    const int count = static_cast<int>(std::min<std::size_t>(kernels::block_size, to - begin));
    evaluate_block(b, begin, count, near, step, approach_);
  }
}

Meeting& ContactEvaluator::meeting(const StepOfPairs& step) {
  Meeting& meeting = scratch_[static_cast<std::size_t>(step.part)].meeting;
  meeting.block.period = step.images.periods.length;
  meeting.block.slide = step.images.slide;
  return meeting;
}

/// Calls found(slot) for those of the slots [begin, begin + count), up to a block, that touch or may.
template <class Found>
void ContactEvaluator::glance(const NearPairs& near, std::size_t begin, int count, const StepOfPairs& step,
                              Found&& found) const {
  std::uint8_t met[kernels::block_size];
  const int n = step.contact.kernel.glance(near.some(begin, count), step.parcels.body.data(), step.images,
                                           approach_, met);
  for (int k = 0; k < n; ++k) found(static_cast<std::uint32_t>(begin + met[k]));
}

void ContactEvaluator::pairs_apart(NearPairs& near, std::size_t from, std::size_t to,
                                   const StepOfPairs& step) {
  Meeting& together = meeting(step);
  for (std::size_t begin = from; begin < to; begin += kernels::block_size) {
    const int count = static_cast<int>(std::min<std::size_t>(kernels::block_size, to - begin));
    glance(near, begin, count, step, [&](std::uint32_t slot) {
      stage_pair(together, slot, near);
      if (together.block.count == kernels::block_size) finish_pairs(together, near, step);
    });
  }
  if (together.block.count > 0) finish_pairs(together, near, step);
}

void ContactEvaluator::pairs_late(NearPairs& near, const ContactClasses& classes, const StepOfPairs& step) {
  Meeting& together = meeting(step);
  const ContactClass* contact = &step.contact;
  const auto finish = [&] {
    if (together.block.count > 0)
      finish_pairs(together, near, {step.parcels, *contact, step.images, step.dt, step.part});
  };
  for (std::size_t begin = near.first_late(); begin < near.slots(); begin += kernels::block_size) {
    if (near.part_of(begin) != step.part) continue;
    const int count = static_cast<int>(std::min<std::size_t>(kernels::block_size, near.slots() - begin));
    glance(near, begin, count, step, [&](std::uint32_t slot) {
      const ContactClass* own = &classes.all()[classes.index(step.parcels.body[near.first[slot]].species,
                                                             step.parcels.body[near.second[slot]].species)];
      if (own != contact || together.block.count == kernels::block_size) finish();
      contact = own;
      stage_pair(together, slot, near);
    });
  }
  finish();
}

/// Looks at every surface near parcel `i` and gives each contact on a shared edge to one of them. A contact
/// that changes surfaces there takes its memory along: it ends by its law only. Returns through `owner` the
/// slot, from the parcel's first, that each contact now belongs to.
void ContactEvaluator::settle_edges(NearWalls& near, std::uint32_t i, const Parcel& p, const Walls& walls,
                                    std::span<const Pose> poses, Scratch& scratch) const {
  const std::uint32_t begin = near.begin[i], count = near.begin[i + 1] - begin;
  scratch.sights.resize(count);
  scratch.owner.resize(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Surface& surface = walls.surfaces[near.surface[begin + k]];
    scratch.sights[k] = look(walls, near, begin + k, poses[surface.body].now.back(p.position));
    scratch.owner[k] = k;
  }
  bool any = false;
  const double same = 1e-9 * p.radius;
  for (std::uint32_t k = 1; k < count; ++k)  // exactly on the seam of two faces it lies in both
    for (std::uint32_t other = 0; other < k && scratch.owner[k] == k; ++other) {
      const WallSight &a = scratch.sights[k], &b = scratch.sights[other];
      if (!a.nearest.in_face || !b.nearest.in_face || a.distance >= p.radius) continue;
      const Surface &own = walls.surfaces[near.surface[begin + k]],
                    &its = walls.surfaces[near.surface[begin + other]];
      if (own.body != its.body || norm(a.offset - b.offset) > same) continue;
      scratch.owner[k] = scratch.owner[other];
      any = true;
    }
  for (std::uint32_t k = 0; k < count; ++k) {
    const WallSight& sight = scratch.sights[k];
    if (sight.nearest.in_face || !(near.touching[begin + k] || sight.distance < p.radius + approach_))
      continue;
    scratch.owner[k] = owner_of_edge(near, begin, scratch.sights, k, p.radius, walls);
    any |= scratch.owner[k] != k;
  }
  if (!any) return;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (scratch.owner[k] == k || !near.touching[begin + k]) continue;
    std::uint32_t heir = scratch.owner[k];
    for (std::uint32_t hop = 0; hop < count && scratch.owner[heir] != heir; ++hop) heir = scratch.owner[heir];
    if (near.touching[begin + heir]) continue;
    near.touching[begin + heir] = 1;
    near.history[begin + heir] = near.history[begin + k];
    near.memory.copy(begin + heir, near.memory, begin + k);
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    if (scratch.owner[k] == k) continue;
    near.touching[begin + k] = 0;
    near.history[begin + k] = {};
    near.memory.forget(begin + k);
    near.load[begin + k] = {};
  }
}

void ContactEvaluator::walls(NearWalls& near, const Parcels& parcels, const Walls& walls,
                             std::span<const Pose> poses, const ContactClasses& classes, double dt,
                             int threads, std::vector<Crossing>& crossings) {
  for (auto& s : scratch_) s.crossings.clear();
  parallel_shares(near.slots(), threads, [&](std::size_t from, std::size_t to, int thread) {
    auto& scratch = scratch_[static_cast<std::size_t>(thread)];
    for (std::size_t here = near.first_of_parcel(from), end = 0; here < near.first_of_parcel(to);
         here = end) {
      const std::uint32_t i = near.parcel[here], begin = near.begin[i];
      end = near.begin[i + 1];
      const Parcel& p = parcels.body[i];
      settle_edges(near, i, p, walls, poses, scratch);
      for (std::uint32_t slot = begin; slot < end; ++slot) {
        const Surface& surface = walls.surfaces[near.surface[slot]];
        const Pose& pose = poses[surface.body];
        const WallSight& sight = scratch.sights[slot - begin];
        // In the frame of the body, where the surface stands still.
        const Vec3 at = pose.now.back(p.position), before_at = pose.before.back(p.position - dt * p.velocity);
        if (crossed(walls, near, slot, sight, before_at, at))
          scratch.crossings.push_back({i, near.surface[slot]});
        const bool in_reach = near.touching[slot] || sight.distance < p.radius + approach_;
        if (!in_reach || sight.distance == 0.0 || scratch.owner[slot - begin] != slot - begin) continue;
        const std::uint32_t c = classes.index(p.species, surface.species);
        ContactBlock& b = scratch.block[c];
        stage_wall(b, slot, p, walls, pose, sight, before_at, at, near, dt);
        if (b.count == kernels::block_size) finish_walls(b, classes.all()[c], near, dt);
      }
    }
    for (std::size_t c = 0; c < scratch.block.size(); ++c)
      if (scratch.block[c].count > 0) finish_walls(scratch.block[c], classes.all()[c], near, dt);
  });
  crossings.clear();
  for (const auto& s : scratch_) crossings.insert(crossings.end(), s.crossings.begin(), s.crossings.end());
}

}  // namespace pulvis
