// SPDX-License-Identifier: Apache-2.0
#include "engine/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t rebuilds_between_sorts = 32;
constexpr double steps_between_rebuilds = 25.0;  // what the margins of moving parcels aim at

std::vector<std::uint32_t> same_order(std::size_t count) {
  std::vector<std::uint32_t> index(count);
  std::iota(index.begin(), index.end(), 0u);
  return index;
}

}  // namespace

State Simulation::initial_state(const Model& model) {
  State state;
  state.motions.resize(model.motions.size());
  state.body_offset.resize(model.bodies.size());
  state.sources.resize(model.sources.size());
  state.pairs.begin = state.walls.begin = {0};
  return state;
}

Simulation::Simulation(Model model, State state, int threads)
    : model_(std::move(model)),
      state_(std::move(state)),
      most_threads_(std::max(threads, 1)),
      nearest_(NearestImage::of(model_.domain)),
      reach_(model_.classes.longest_reach(model_.largest_radius)),
      poses_(model_.bodies.size()),
      evaluator_(most_threads_, model_.classes.all().size()) {
  for (std::size_t b = 0; b < poses_.size(); ++b) {
    const Vec3 at = displacement_at(b, state_.step);
    poses_[b] = {at, at};
  }
  const TouchingList pairs = std::move(state_.pairs), walls = std::move(state_.walls);
  state_.pairs = state_.walls = {};
  rebuild(pairs, walls, same_order(state_.parcels.size()));
}

int Simulation::threads() const {
  const std::size_t worth = std::max<std::size_t>(1, state_.parcels.size() / model_.parcels_per_thread);
  return static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(most_threads_), worth));
}

void Simulation::step() {
  insert_due_parcels();
  const StepNotice notice =
      begin_step(state_.parcels, model_.domain, model_.dt, reference_, margin_, threads());
  move_bodies_to(state_.step + 1);
  if (notice.outside || notice.too_fast) take_out_escaped(notice);
  if (notice.stale || a_body_left_its_margin()) rebuild();
  evaluator_.pairs(pairs_, state_.parcels, model_.classes, nearest_, model_.dt, threads());
  evaluator_.walls(walls_, state_.parcels, model_.surfaces, model_.bodies, poses_, model_.classes, model_.dt,
                   threads(), crossings_);
  end_step(state_.parcels, pairs_, walls_, model_.gravity, model_.dt, threads());
  ++state_.step;
  if (!crossings_.empty()) take_out_crossed();
}

// --- sources and motions ---------------------------------------------------------------------------------

void Simulation::open_source(std::size_t source) {
  SourceState& s = state_.sources[source];
  s.open = true;
  s.opened = state_.step;
  s.mass_at_opening = s.mass;
}

void Simulation::close_source(std::size_t source) { state_.sources[source].open = false; }

void Simulation::insert_due_parcels() {
  const std::size_t before = state_.parcels.size();
  for (std::size_t k = 0; k < model_.sources.size(); ++k) {
    SourceState& source = state_.sources[k];
    if (!source.open || source.done) continue;
    // Each source sees what the ones before it gave in this step.
    for (Parcel& p : draw_parcels(
             model_.sources[k], source, model_.seed, static_cast<std::uint32_t>(k), state_.step, model_.dt,
             state_.parcels, model_.domain, [this](const Vec3&x, double r) { return clear_of_walls(x, r); },
             most_threads_)) {
      p.id = state_.next_id++;
      state_.parcels.body.push_back(p);
      state_.parcels.load.push_back({p.mass * model_.gravity, {}});
      ++state_.ledger.inserted;
      state_.ledger.inserted_mass += p.mass;
    }
    if (source.done) model_.sources[k].list = {};  // a bed is given once
  }
  if (state_.parcels.size() == before) return;
  const TouchingList old_pairs = pairs_.pack(state_.parcels, threads()), old_walls = walls_.pack();
  auto old_index = same_order(before);
  old_index.resize(state_.parcels.size(), NearPairs::no_parcel);
  rebuild(old_pairs, old_walls, std::move(old_index));
}

bool Simulation::clear_of_walls(const Vec3& centre, double radius) const {
  for (const Surface& s : model_.surfaces) {
    const Vec3 at = centre - poses_[s.body].now;
    if (norm(nearest_point(s, at).point - at) < radius) return false;
  }
  return true;
}

void Simulation::start_motion(std::size_t motion) { state_.motions[motion] = {true, state_.step}; }

void Simulation::stop_motion(std::size_t motion) {
  if (!state_.motions[motion].running) return;
  for (std::size_t b = 0; b < model_.bodies.size(); ++b)
    if (model_.bodies[b].motion == motion) state_.body_offset[b] = displacement_at(b, state_.step);
  state_.motions[motion] = {};
}

Vec3 Simulation::displacement_at(std::size_t body, std::uint64_t step) const {
  const auto motion = model_.bodies[body].motion;
  const Vec3 offset = state_.body_offset[body];
  if (!motion || !state_.motions[*motion].running) return offset;
  const double since = static_cast<double>(step - state_.motions[*motion].start) * model_.dt;
  return offset + model_.motions[*motion].displacement(since);
}

void Simulation::move_bodies_to(std::uint64_t step) {
  for (std::size_t b = 0; b < poses_.size(); ++b) poses_[b] = {poses_[b].now, displacement_at(b, step)};
}

// --- parcels that leave ----------------------------------------------------------------------------------

void Simulation::fail_at(const char* what, const char* remedy, const Parcel& p) const {
  throw Failure(
      Exit::physics,
      fmt::format("{}: parcel {} at t = {:.6g} s, position ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.6g}, "
                  "{:.6g}, {:.6g}) m/s, radius {:.4g} m\n  {}",
                  what, p.id, time(), p.position.x, p.position.y, p.position.z, p.velocity.x, p.velocity.y,
                  p.velocity.z, p.radius, remedy));
}

void Simulation::take_out_escaped(const StepNotice& notice) {
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < state_.parcels.size(); ++i) {
    const Parcel& p = state_.parcels.body[i];
    const Vec3 &x = p.position, &low = model_.domain.min, &high = model_.domain.max;
    if (!(std::isfinite(dot(x, x)) && std::isfinite(dot(p.velocity, p.velocity)) &&
          std::isfinite(dot(p.spin, p.spin))))
      fail_at("position, velocity or spin is not a finite number",
              "the time step may be too large (lower time.fraction) or a material constant out of range", p);
    if (notice.too_fast && dot(p.velocity, p.velocity) * square(model_.dt) > square(0.5 * p.radius))
      fail_at("a parcel moved more than half its radius in one time step",
              "lower time.fraction, or raise the modulus if parcels overlap deeply; see `pulvis check`", p);
    if (x.x < low.x || x.x > high.x || x.y < low.y || x.y > high.y || x.z < low.z || x.z > high.z)
      out.push_back(static_cast<std::uint32_t>(i));
  }
  for (const std::uint32_t i : out) {
    const Parcel& p = state_.parcels.body[i];
    state_.escapes.push_back({p.id, time() + model_.dt, p.position, p.velocity, "domain"});
  }
  remove(out);
}

void Simulation::take_out_crossed() {
  std::vector<std::uint32_t> out;
  for (const Crossing& c : crossings_) {
    if (!out.empty() && out.back() == c.parcel) continue;
    const Parcel& p = state_.parcels.body[c.parcel];
    state_.escapes.push_back({p.id, time(), p.position, p.velocity, model_.surfaces[c.surface].name});
    out.push_back(c.parcel);
  }
  crossings_.clear();
  remove(out);
}

void Simulation::remove(std::vector<std::uint32_t>& indices) {
  if (indices.empty()) return;
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
  const auto stood_at = rebuild(old_pairs, old_walls, std::move(old_index));
  pairs_.take_over_loads(pairs_before, stood_at);
  walls_.take_over_loads(walls_before, stood_at);
}

// --- near lists ------------------------------------------------------------------------------------------

void Simulation::choose_margins() {
  // Fast parcels get wide margins and slow ones narrow ones: in a filling die the dense bed is slow and the
  // fast rain is dilute, so lists stay short where there are many parcels.
  // No margin is less than the way of the next step (up to 0.5 radius): contacts must end by their law only.
  const double least = 0.03 * model_.skin, most = greatest(0.6 * model_.skin, 0.5);
  margin_.resize(state_.parcels.size());
  for (std::size_t i = 0; i < margin_.size(); ++i) {
    const Parcel& p = state_.parcels.body[i];
    const double wish = norm(p.velocity) * model_.dt * steps_between_rebuilds / p.radius;
    margin_[i] = p.radius * std::clamp(1.2 * wish + least, least, most);
  }
  body_margin_.resize(poses_.size());
  for (std::size_t b = 0; b < poses_.size(); ++b) {
    const auto motion = model_.bodies[b].motion;
    const bool moves = motion && state_.motions[*motion].running;
    const double speed = moves ? model_.motions[*motion].peak_speed() : 0.0;
    body_margin_[b] = least * model_.smallest_radius + speed * model_.dt * steps_between_rebuilds;
  }
}

bool Simulation::a_body_left_its_margin() const {
  for (std::size_t b = 0; b < poses_.size(); ++b)
    if (norm(poses_[b].now - body_reference_[b]) > body_margin_[b]) return true;
  return false;
}

void Simulation::sort_along_space(std::vector<std::uint32_t>& old_index) {
  // Morton order of cells two parcels wide: neighbours in space become neighbours in memory.
  const double edge = 4.0 * model_.largest_radius;
  const auto spread = [](std::uint64_t v) {
    v &= 0x1fffff;
    v = (v | v << 32) & 0x1f00000000ffff;
    v = (v | v << 16) & 0x1f0000ff0000ff;
    v = (v | v << 8) & 0x100f00f00f00f00f;
    v = (v | v << 4) & 0x10c30c30c30c30c3;
    return (v | v << 2) & 0x1249249249249249;
  };
  const std::size_t count = state_.parcels.size();
  std::vector<std::pair<std::uint64_t, std::uint32_t>> key(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 d = (state_.parcels.body[i].position - model_.domain.min) / edge;
    const auto at = [](double x) { return static_cast<std::uint64_t>(std::clamp(x, 0.0, 2e6)); };
    key[i] = {spread(at(d.x)) | spread(at(d.y)) << 1 | spread(at(d.z)) << 2, static_cast<std::uint32_t>(i)};
  }
  std::sort(key.begin(), key.end());
  Parcels sorted;
  sorted.body.resize(count);
  sorted.load.resize(count);
  std::vector<std::uint32_t> index(count);
  for (std::size_t k = 0; k < count; ++k) {
    sorted.body[k] = state_.parcels.body[key[k].second];
    sorted.load[k] = state_.parcels.load[key[k].second];
    index[k] = old_index[key[k].second];
  }
  state_.parcels = std::move(sorted);
  old_index = std::move(index);
}

void Simulation::rebuild() {
  const TouchingList old_pairs = pairs_.pack(state_.parcels, threads()), old_walls = walls_.pack();
  rebuild(old_pairs, old_walls, same_order(state_.parcels.size()));
}

std::vector<std::uint32_t> Simulation::rebuild(const TouchingList& old_pairs, const TouchingList& old_walls,
                                               std::vector<std::uint32_t> old_index) {
  if (rebuilds_++ % rebuilds_between_sorts == 0) sort_along_space(old_index);
  choose_margins();
  const std::size_t count = state_.parcels.size();
  reference_.resize(count);
  for (std::size_t i = 0; i < count; ++i) reference_[i] = state_.parcels.body[i].position;
  body_reference_.resize(poses_.size());
  for (std::size_t b = 0; b < poses_.size(); ++b) body_reference_[b] = poses_[b].now;

  pairs_.rebuild(state_.parcels, margin_, reach_, model_.domain, threads());
  walls_.rebuild(state_.parcels, model_.surfaces, poses_, margin_, body_margin_, reach_, threads());
  const std::size_t found =
      pairs_.restore(old_pairs, old_index, state_.parcels, threads()) + walls_.restore(old_walls, old_index);

  // Contacts may end only by separation or with a parcel that was taken out.
  if (old_pairs.begin.size() == count + 1 && found != old_pairs.size() + old_walls.size())
    throw Failure(Exit::internal_check,
                  fmt::format("a rebuild of the neighbour lists kept {} of {} contacts at t = {:.6g} s",
                              found, old_pairs.size() + old_walls.size(), time()));
  return old_index;
}

// --- what others may ask ---------------------------------------------------------------------------------

State Simulation::snapshot() const {
  State copy = state_;
  copy.pairs = pairs_.pack(state_.parcels, threads());
  copy.walls = walls_.pack();
  return copy;
}

std::string Simulation::hash() const {
  return state_hash(state_.parcels, pairs_.pack(state_.parcels, threads()), walls_.pack());
}

Vec3 Simulation::force_on_surface(std::size_t surface) const {
  std::vector<std::pair<std::uint32_t, Vec3>> forces;
  for (std::size_t slot = 0; slot < walls_.slots(); ++slot)
    if (walls_.surface[slot] == surface && walls_.touching[slot])
      forces.push_back({state_.parcels.body[walls_.parcel[slot]].id, -walls_.load[slot].force});
  std::sort(forces.begin(), forces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Vec3 sum;
  for (const auto& [id, force] : forces) sum += force;
  return sum;
}

std::size_t Simulation::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof v[0]; };
  return bytes(state_.parcels.body) + bytes(state_.parcels.load) + bytes(reference_) + bytes(margin_) +
         bytes(pairs_.first) + bytes(pairs_.second) + bytes(pairs_.touching) + bytes(pairs_.history) +
         bytes(pairs_.load) + bytes(pairs_.begin) + bytes(pairs_.entry) + bytes(walls_.begin) +
         bytes(walls_.parcel) + bytes(walls_.surface) + bytes(walls_.history) + bytes(walls_.load);
}

}  // namespace pulvis
