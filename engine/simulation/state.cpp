// SPDX-License-Identifier: Apache-2.0
#include "engine/simulation/state.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "engine/kernels/energy_block.hpp"
#include "engine/simulation/model.hpp"
#include "engine/simulation/state_fields.hpp"

namespace pulvis {
namespace {

bool finite(const Vec3& v) { return std::isfinite(dot(v, v)); }

/// Contacts of `owners` parcels, partners ascending within each and below `partners`.
bool is_sound(const TouchingList& list, std::size_t owners, std::uint32_t partners) {
  const std::size_t count = list.partner.size();
  if (list.begin.size() != owners + 1 || list.begin.front() != 0 || list.begin.back() != count) return false;
  if (list.history.size() != count || list.memory.list.size() != (list.memory.used ? count : 0)) return false;
  for (std::size_t k = 0; k < owners; ++k) {
    if (list.begin[k] > list.begin[k + 1] || list.begin[k + 1] > count) return false;
    for (std::uint32_t at = list.begin[k]; at < list.begin[k + 1]; ++at)
      if (list.partner[at] >= partners || (at > list.begin[k] && list.partner[at] <= list.partner[at - 1]))
        return false;
  }
  const auto finite_history = [](const laws::History& h) { return finite(h.slide) && finite(h.roll); };
  const auto finite_memory = [](const laws::Memory& m) {
    return std::isfinite(m.plastic) && std::isfinite(m.adhesion) && std::isfinite(m.grip);
  };
  return std::all_of(list.history.begin(), list.history.end(), finite_history) &&
         std::all_of(list.memory.list.begin(), list.memory.list.end(), finite_memory);
}

/// Numbers of parcels, each once; of a pair, the owner's below its partner's, which is there.
bool has_sound_ids(const State& state) {
  std::vector<std::uint32_t> ids;
  for (const Parcel& p : state.parcels.body) ids.push_back(p.id);
  std::sort(ids.begin(), ids.end());
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end()) return false;
  if (!ids.empty() && ids.back() >= state.next_id) return false;
  for (std::size_t k = 0; k < state.parcels.size(); ++k)
    for (std::uint32_t at = state.pairs.begin[k]; at < state.pairs.begin[k + 1]; ++at)
      if (state.pairs.partner[at] <= state.parcels.body[k].id ||
          !std::binary_search(ids.begin(), ids.end(), state.pairs.partner[at]))
        return false;
  return true;
}

bool is_sound(const Parcel& p, const Model& model) {
  constexpr double slack = 1e-6;  // roundings of what was drawn or wrapped
  const Vec3 from_low = p.position - model.domain.min, extent = model.domain.extent();
  for (int axis = 0; axis < 3; ++axis)
    if (!(from_low[axis] >= -slack * extent[axis] && from_low[axis] <= (1.0 + slack) * extent[axis]))
      return false;
  return finite(p.velocity) && finite(p.spin) && p.species < model.classes.species() &&
         p.radius >= (1.0 - slack) * model.smallest_radius &&
         p.radius <= (1.0 + slack) * model.largest_radius && p.mass > 0.0 && std::isfinite(p.mass);
}

bool is_sound(const MotionState& m, const State& state) {
  return finite(m.left.row[0]) && finite(m.left.row[1]) && finite(m.left.row[2]) && finite(m.left.shift) &&
         m.start <= state.step;
}

class Hash {
 public:
  Hash() : state_(XXH3_createState()) { XXH3_128bits_reset(state_); }
  ~Hash() { XXH3_freeState(state_); }
  Hash(const Hash&) = delete;
  Hash& operator=(const Hash&) = delete;

  template <class T>
  void add(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, Vec3> ||
                  std::is_same_v<T, double> || std::is_same_v<T, laws::History> ||
                  std::is_same_v<T, laws::Memory>);
    XXH3_128bits_update(state_, &value, sizeof value);
  }
  std::string text() const {
    const auto digest = XXH3_128bits_digest(state_);
    return fmt::format("{:016x}{:016x}", digest.high64, digest.low64);
  }

 private:
  XXH3_state_t* state_;
};

void add_contacts(Hash& hash, const TouchingList& list, std::uint32_t owner) {
  hash.add(list.begin[owner + 1] - list.begin[owner]);
  for (std::uint32_t k = list.begin[owner]; k < list.begin[owner + 1]; ++k) {
    hash.add(list.partner[k]);
    hash.add(list.history[k]);
    if (list.memory.used) hash.add(list.memory.list[k]);
  }
}

}  // namespace

std::vector<std::byte> save_state(const State& state) { return to_bytes(state); }

State load_state(std::span<const std::byte> bytes) {
  State state;
  from_bytes(bytes, state);
  return state;
}

void require_fit(const State& state, const Model& model) {
  const std::size_t count = state.parcels.size();
  const auto any_surface = static_cast<std::uint32_t>(model.walls.surfaces.size());
  ByteReader::require(state.parcels.load.size() == count && is_sound(state.pairs, count, state.next_id) &&
                      is_sound(state.walls, count, any_surface) && has_sound_ids(state));
  constexpr std::uint32_t most_parcels = 1u << 31;  // see Parcel::id
  ByteReader::require(state.next_id <= most_parcels);
  const bool remember = model.classes.remember();
  ByteReader::require(state.pairs.memory.used == remember && state.walls.memory.used == remember);
  for (const Parcel& p : state.parcels.body) ByteReader::require(is_sound(p, model));
  for (const Load& load : state.parcels.load) ByteReader::require(finite(load.force) && finite(load.torque));
  ByteReader::require(state.motions.size() == model.motions.size() &&
                      state.body_absent.size() == model.walls.bodies.size() &&
                      state.sources.size() == model.sources.size());
  for (const MotionState& m : state.motions) ByteReader::require(is_sound(m, state));
  for (const SourceState& s : state.sources)
    ByteReader::require(s.opened <= state.step && s.mass_at_opening >= 0.0 && s.mass_at_opening <= s.mass &&
                        std::isfinite(s.mass));
  ByteReader::require(state.progress.phase_start <= state.step);
  const std::size_t terms = state.energy.begun ? kernels::energy_terms : 0;
  ByteReader::require(state.energy.terms.size() == terms && state.energy.last_terms.size() == terms &&
                      std::isfinite(state.energy.start) && std::isfinite(state.energy.inserted) &&
                      std::isfinite(state.energy.removed));
  const Ledger& ledger = state.ledger;
  ByteReader::require(ledger.inserted == count + ledger.removed + ledger.escaped &&
                      state.escapes.size() == ledger.escaped);
}

std::string state_hash(const Parcels& parcels, const TouchingList& pairs, const TouchingList& walls) {
  const std::size_t count = parcels.size();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return parcels.body[a].id < parcels.body[b].id; });
  Hash hash;
  for (const std::uint32_t k : order) {
    const Parcel& p = parcels.body[k];
    hash.add(p.id);
    hash.add(p.position);
    hash.add(p.velocity);
    hash.add(p.spin);
    add_contacts(hash, pairs, k);
    add_contacts(hash, walls, k);
  }
  return hash.text();
}

}  // namespace pulvis
