// SPDX-License-Identifier: Apache-2.0
#include "engine/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "engine/base/failure.hpp"
#include "engine/contacts/wall_sight.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t steps_between_guards = 64;  // they cost a tenth of a step

}  // namespace

std::vector<std::uint32_t> Simulation::same_order(std::size_t count) {
  std::vector<std::uint32_t> index(count);
  std::iota(index.begin(), index.end(), 0u);
  return index;
}

State Simulation::initial_state(const Model& model) {
  State state;
  state.motions.resize(model.motions.size());
  state.body_absent.assign(model.walls.bodies.size(), 0);
  state.sources.resize(model.sources.size());
  state.pairs.memory.used = state.walls.memory.used = model.classes.remember();
  return state;
}

Simulation::Simulation(Model model, State state, int threads, const TimeSheet& times)
    : model_(std::move(model)),
      state_(std::move(state)),
      most_threads_(std::max(threads, 1)),
      times_(times),
      images_(Images::of(model_.domain, static_cast<double>(state_.step) * model_.dt)),
      reach_(model_.classes.longest_reach(model_.largest_radius)),
      poses_(model_.walls.bodies.size()),
      evaluator_(most_threads_, model_.classes.all().size(),
                 model_.classes.longest_approach(model_.largest_radius)) {
  pairs_.pasts.remembers = walls_.memory.used = model_.classes.remember();
  find_body_corners();
  has_bounded_walls_ = std::any_of(model_.walls.surfaces.begin(), model_.walls.surfaces.end(),
                                   [](const Surface& s) { return s.kind != Surface::Kind::plane; });
  for (std::size_t b = 0; b < poses_.size(); ++b) {
    const Rigid at = placement(b, state_.step);
    poses_[b] = Pose::of_step(at, at, model_.dt);
    poses_[b].absent = state_.body_absent[b] != 0;
  }
  const TouchingList pairs = std::move(state_.pairs), walls = std::move(state_.walls);
  state_.pairs = state_.walls = {};
  times_.book(Task::preparation);
  rebuild(pairs, walls, same_order(state_.parcels.size()));
  if (!model_.energy_ledger) {
    state_.energy = {};  // what was added up before says nothing of what comes
    return;
  }
  energy_.emplace(model_, most_threads_);
  next_poses_ = poses_;
  energy_->begin(state_.energy, view(), field());
}

int Simulation::threads() const {
  const std::size_t worth = std::max<std::size_t>(1, state_.parcels.size() / model_.parcels_per_thread);
  return static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(most_threads_), worth));
}

void Simulation::step(Then then) {
  if (!ahead_) {
    insert_due_parcels();
    const StepBeginning first = beginning();
    notice_ = begin_step(state_.parcels, first, leeway(), threads());
    drift_ = first.drift;
    times_.book(Task::pairs);
  }
  ahead_ = false;
  images_.slide = slide_at(state_.step + 1);
  const std::size_t escaped_before = state_.escapes.size();
  move_bodies_to(state_.step + 1);
  require_slow_walls();
  if (notice_.outside || notice_.too_fast) take_out_escaped(notice_);
  // Walls have no periodic images: what wrapped must look anew for those at the other end.
  walls_may_be_left_ = notice_.wrapped && has_bounded_walls_;
  const bool all_are_stale = walls_may_be_left_ || crowds_have_parted() || a_body_left_its_margin();
  times_.book(Task::bodies);
  if (all_are_stale || (notice_.any_left() && !relist_those_that_left())) rebuild();
  walls_may_be_left_ = false;
  if (energy_) before_contacts();
  evaluator_.walls(walls_, state_.parcels, model_.walls, poses_, model_.classes, model_.dt, threads(),
                   crossings_);
  times_.book(Task::walls);
  ++state_.step;
  const StepBeginning next = beginning();
  const bool guarded = state_.step % steps_between_guards == 0;
  ahead_ = then == Then::go_on && !energy_ && !guarded && crossings_.empty() &&
           state_.escapes.size() == escaped_before && !a_source_is_due();
  if (!ahead_) pairs_.settle_late(state_.parcels);
  pairs_.keep_forces(then == Then::look);
  if (energy_) energy_->before_kick(state_.parcels);
  notice_ = sweep({state_.parcels, pairs_, walls_, evaluator_, model_.classes, images_, leeway()},
                  {field_towards(-0.5), model_.dt}, ahead_ ? &next : nullptr);
  if (ahead_) drift_ = next.drift;
  times_.book(Task::pairs);
  if (energy_) account_energy();
  if (!crossings_.empty()) take_out_crossed();
  if (!guarded) return;
  require_sound();
  times_.book(Task::guards);
}

ShearedStep Simulation::shear_to_next_step() const {
  if (!model_.domain.shear.any()) return {};
  const auto steps = static_cast<double>(state_.step + 1 - rebuilt_at_);
  return {slide_at(state_.step + 1), model_.domain.shear.rate * steps * model_.dt, reach_};
}

// --- energy ----------------------------------------------------------------------------------------------

ContactView Simulation::view() const {
  return {pairs_,      walls_,         state_.parcels,  model_.walls, poses_,
          next_poses_, model_.classes, images_.periods, model_.dt,    threads()};
}

void Simulation::before_contacts() {
  energy_->before_contacts(pairs_, walls_);
  times_.book(Task::energy_ledger);
}

void Simulation::account_energy() {
  for (std::size_t b = 0; b < poses_.size(); ++b)
    next_poses_[b] = Pose::of_step(poses_[b].now, placement(b, state_.step + 1), model_.dt);
  energy_->after_step(state_.energy, view(), field());
  times_.book(Task::energy_ledger);
}

void Simulation::account_leaving(const Parcel& parcel, const Load& load, Velocities velocities) {
  if (!energy_) return;
  Parcel p = parcel;  // as it is in the middle of a step
  const double half = 0.5 * model_.dt;
  if (velocities == Velocities::of_end) {
    p.velocity += (half / p.mass) * load.force;
    p.spin += (half / inertia(p)) * load.torque;
  }
  const double to_middle = velocities == Velocities::of_end ? half : -half;
  energy_->remove(state_.energy, p, p.position + to_middle * p.velocity);
}

std::optional<EnergyBalance> Simulation::energy() const {
  if (!energy_) return std::nullopt;
  return energy_->balance(state_.energy, state_.parcels);
}

// --- sources and motions ---------------------------------------------------------------------------------

void Simulation::open_source(std::size_t source) {
  require_whole_step();
  SourceState& s = state_.sources[source];
  s.open = true;
  s.opened = state_.step;
  s.mass_at_opening = s.mass;
}

void Simulation::close_source(std::size_t source) { state_.sources[source].open = false; }

bool Simulation::a_source_is_due() const {
  for (std::size_t k = 0; k < model_.sources.size(); ++k)
    if (is_due(model_.sources[k], state_.sources[k], state_.step, model_.dt)) return true;
  return false;
}

void Simulation::insert_due_parcels() {
  const std::size_t before = state_.parcels.size();
  for (std::size_t k = 0; k < model_.sources.size(); ++k) {
    SourceState& source = state_.sources[k];
    if (!is_due(model_.sources[k], source, state_.step, model_.dt)) continue;
    // Each source sees what the ones before it gave in this step.
    for (Parcel& p : draw_parcels(
             model_.sources[k], source, model_.seed, static_cast<std::uint32_t>(k), state_.step, model_.dt,
             state_.parcels, model_.domain, [this](const Vec3&x, double r) { return clear_of_walls(x, r); },
             most_threads_)) {
      p.id = state_.next_id++;
      // What a source gives moves with the flow; a list says how each of its parcels moves.
      if (model_.sources[k].kind != SourceModel::Kind::list)
        p.velocity += model_.domain.flow_velocity(p.position);
      state_.parcels.body.push_back(p);
      state_.parcels.load.push_back({p.mass * field().at(p.position), {}});
      ++state_.ledger.inserted;
      state_.ledger.inserted_mass += p.mass;
      if (energy_) energy_->insert(state_.energy, p, field());
    }
    if (source.done) std::vector<Parcel>().swap(model_.sources[k].list);  // a bed is given once
  }
  times_.book(Task::insertion);
  if (state_.parcels.size() == before) return;
  const TouchingList old_pairs = pairs_.pack(state_.parcels, threads()), old_walls = walls_.pack();
  auto old_index = same_order(before);
  old_index.resize(state_.parcels.size(), NearPairs::no_parcel);
  rebuild(old_pairs, old_walls, std::move(old_index));
}

bool Simulation::clear_of_walls(const Vec3& centre, double radius) const {
  for (const Surface& s : model_.walls.surfaces) {
    if (s.kind == Surface::Kind::patch || poses_[s.body].absent) continue;
    const Vec3 at = poses_[s.body].now.back(centre);
    if (norm(nearest_point(s, at).point - at) < radius) return false;
  }
  for (const FacetedWall& mesh : model_.walls.meshes) {
    const Pose& pose = poses_[model_.walls.surfaces[mesh.first_surface].body];
    if (pose.absent) continue;
    const Vec3 at = pose.now.back(centre);
    bool clear = true;
    mesh.for_near(at, radius, [&](std::uint32_t triangle) {
      clear = clear && norm(mesh.nearest(triangle, at).point - at) >= radius;
    });
    if (!clear) return false;
  }
  return true;
}

void Simulation::start_motion(std::size_t motion) {
  require_whole_step();
  state_.motions[motion].running = true;
  state_.motions[motion].start = state_.step;
}

void Simulation::stop_motion(std::size_t motion) {
  require_whole_step();
  MotionState& m = state_.motions[motion];
  if (!m.running) return;
  const double since = static_cast<double>(state_.step - m.start) * model_.dt;
  m.left = displacement(model_.motions[motion], since) * m.left;
  m.running = false;
}

Rigid Simulation::placement(std::size_t body, std::uint64_t step) const {
  Rigid at;
  for (const std::size_t motion : model_.walls.bodies[body].motions) {
    const MotionState& m = state_.motions[motion];
    Rigid moved = m.left;
    if (m.running)
      moved = displacement(model_.motions[motion], static_cast<double>(step - m.start) * model_.dt) * moved;
    at = moved * at;
  }
  return at;
}

void Simulation::move_bodies_to(std::uint64_t step) {
  for (std::size_t b = 0; b < poses_.size(); ++b) {
    const bool absent = poses_[b].absent;
    poses_[b] = Pose::of_step(poses_[b].now, placement(b, step), model_.dt);
    poses_[b].absent = absent;
  }
}

void Simulation::set_absent(std::size_t body, bool absent) {
  require_whole_step();
  if (poses_[body].absent == absent) return;
  const double stored_before = energy_ ? energy_->stored(view()) : 0.0;
  state_.body_absent[body] = absent ? 1 : 0;
  poses_[body].absent = absent;
  TouchingList kept = walls_.pack();
  if (absent) kept = without_body(kept, body);
  rebuild(pairs_.pack(state_.parcels, threads()), kept, same_order(state_.parcels.size()));
  if (energy_) state_.energy.removed += stored_before - energy_->stored(view());
  if (!absent) require_nothing_inside(body);
}

TouchingList Simulation::without_body(const TouchingList& list, std::size_t body) const {
  TouchingList kept;
  kept.memory.used = list.memory.used;
  for (std::size_t i = 0; i + 1 < list.begin.size(); ++i) {
    for (std::uint32_t k = list.begin[i]; k < list.begin[i + 1]; ++k) {
      if (model_.walls.surfaces[list.partner[k]].body == body) continue;
      kept.partner.push_back(list.partner[k]);
      kept.history.push_back(list.history[k]);
      kept.memory.append(list.memory, k);
    }
    kept.begin.push_back(static_cast<std::uint32_t>(kept.partner.size()));
  }
  return kept;
}

void Simulation::require_nothing_inside(std::size_t body) const {
  constexpr double deepest = 0.95;  // radii between centre and wall: a parcel may touch it, no more
  for (std::size_t i = 0; i < state_.parcels.size(); ++i)
    for (std::uint32_t slot = walls_.begin[i]; slot < walls_.begin[i + 1]; ++slot) {
      const Parcel& p = state_.parcels.body[i];
      if (model_.walls.surfaces[walls_.surface[slot]].body != body) continue;
      if (look(model_.walls, walls_, slot, poses_[body].now.back(p.position)).distance >= deepest * p.radius)
        continue;
      fail_at(fmt::format("{} appears where powder is", model_.walls.bodies[body].name).c_str(),
              "let it appear in a phase in which its place is free", p);
    }
}

// --- what others may ask ---------------------------------------------------------------------------------

void Simulation::require_whole_step() const {
  if (ahead_)
    throw Failure(Exit::internal_check, "something other than a step was asked for in the middle of one");
}

State Simulation::snapshot() const {
  require_whole_step();
  State copy = state_;
  copy.pairs = pairs_.pack(state_.parcels, threads());
  copy.walls = walls_.pack();
  return copy;
}

std::string Simulation::hash() const {
  require_whole_step();
  return state_hash(state_.parcels, pairs_.pack(state_.parcels, threads()), walls_.pack());
}

Vec3 Simulation::force_on_surface(std::size_t surface) const {
  Vec3 sum;
  for (const std::uint32_t slot : wall_slots_by_id_)
    if (walls_.surface[slot] == surface && walls_.touching[slot]) sum -= walls_.load[slot].force;
  return sum;
}

std::size_t Simulation::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof v[0]; };
  return bytes(state_.parcels.body) + bytes(state_.parcels.load) + bytes(reference_) + bytes(margin_) +
         bytes(crowd_) + bytes(pairs_.first) + bytes(pairs_.second) + bytes(pairs_.touching) +
         bytes(pairs_.pasts.springs) + bytes(pairs_.pasts.memory) + pairs_.pasts.met.bytes() +
         bytes(pairs_.load) + bytes(pairs_.places) + bytes(pairs_.runs) + bytes(pairs_.force) +
         bytes(pairs_.begin) + bytes(pairs_.entry) + bytes(pairs_.meets) + bytes(walls_.begin) +
         bytes(walls_.parcel) + bytes(walls_.surface) + bytes(walls_.history) + bytes(walls_.load);
}

}  // namespace pulvis
