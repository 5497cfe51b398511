// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/contacts/touching.hpp"
#include "engine/insertion/source.hpp"
#include "engine/math/rigid.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

struct Model;

/// Counts and masses: inserted = present + removed + escaped, always.
struct Ledger {
  std::uint64_t inserted = 0, removed = 0, escaped = 0;
  double inserted_mass = 0.0, removed_mass = 0.0, escaped_mass = 0.0;  ///< kg
};

/// What the ledger of energy has added up: exact sums in quanta (engine/math/exact_sum.hpp) and, of parcels that came
/// and went, sums in order of ids, J.
struct EnergyAccount {
  struct Total {
    std::uint64_t low = 0;  ///< of the whole in 128 bits
    std::int64_t high = 0;
  };

  bool begun = false;
  std::vector<Total> terms;       ///< as in kernels::EnergyTerm; those stored are of the last step
  std::vector<Total> last_terms;  ///< those of the last step
  Total body_forces, last_body_forces;
  double start = 0.0;  ///< kinetic, potential and stored when it began
  double inserted = 0.0, removed = 0.0;
};

/// A parcel that left the domain or passed through a wall.
struct Escape {
  std::uint32_t id = 0;
  double time = 0.0;  ///< s
  Vec3 position, velocity;
  std::string through;  ///< name of the surface, or "domain"
};

struct MotionState {
  bool running = false;
  std::uint64_t start = 0;  ///< step at which it began
  Rigid left;               ///< what it left behind when it stopped before
};

/// Where the procedure is: which phase, since when.
struct PhaseProgress {
  std::uint32_t phase = 0;
  std::uint64_t phase_start = 0;  ///< step
};

/// The whole state of a run at the end of a step: what is needed to go on bit for bit, and nothing that can
/// be derived. Forces belong to it, since dashpots saw mid-step velocities that are gone.
struct State {
  std::uint64_t step = 0;
  Parcels parcels;
  TouchingList pairs, walls;
  std::vector<MotionState> motions;
  std::vector<std::uint8_t> body_absent;  ///< 1: not there now
  std::vector<SourceState> sources;
  std::uint32_t next_id = 0;
  Ledger ledger;
  EnergyAccount energy;
  std::vector<Escape> escapes;
  PhaseProgress progress;
};

/// Bytes of a state; equal states have equal bytes. Whether bytes are intact is the business of the file they
/// stand in (output/chunk_file.hpp).
std::vector<std::byte> save_state(const State& state);
/// Throws Failure(bad_input) if the bytes are no state.
State load_state(std::span<const std::byte> bytes);
/// Throws Failure(bad_input) if the state cannot be one of this model: an index out of range, a number that is
/// not finite, a parcel outside the domain. A state that passes can be stepped, whatever bytes it came from.
void require_fit(const State& state, const Model& model);

/// XXH3 128-bit hash (32 hexadecimal digits) of positions, velocities, spins and contact history, parcels in
/// order of their ids: equal states have equal hashes however the store is sorted.
std::string state_hash(const Parcels& parcels, const TouchingList& pairs, const TouchingList& walls);
inline std::string state_hash(const State& state) {
  return state_hash(state.parcels, state.pairs, state.walls);
}

}  // namespace pulvis
