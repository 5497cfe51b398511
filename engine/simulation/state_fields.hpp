// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/base/archive.hpp"
#include "engine/simulation/state.hpp"

// What of a state goes into saved bytes, and in which order: change it, and the version of checkpoint files
// (run/checkpoint.hpp) must change too.
namespace pulvis {

template <class Archive>
void fields(Archive& archive, Vec3& v) {
  archive(v.x, v.y, v.z);
}
template <class Archive>
void fields(Archive& archive, Rigid& r) {
  archive(r.row[0], r.row[1], r.row[2], r.shift);
}
template <class Archive>
void fields(Archive& archive, Parcel& p) {
  archive(p.position, p.radius, p.velocity, p.mass, p.spin, p.id, p.species);
}
template <class Archive>
void fields(Archive& archive, Load& load) {
  archive(load.force, load.torque);
}
template <class Archive>
void fields(Archive& archive, laws::History& history) {
  archive(history.slide, history.roll);
}
template <class Archive>
void fields(Archive& archive, laws::Memory& memory) {
  archive(memory.plastic, memory.adhesion, memory.grip);
}
template <class Archive>
void fields(Archive& archive, TouchingList& list) {
  archive(list.begin, list.partner, list.history, list.memory.used, list.memory.list);
}
template <class Archive>
void fields(Archive& archive, MotionState& m) {
  archive(m.running, m.start, m.left);
}
template <class Archive>
void fields(Archive& archive, SourceState& s) {
  archive(s.open, s.done, s.opened, s.mass_at_opening, s.count, s.mass);
}
template <class Archive>
void fields(Archive& archive, Ledger& l) {
  archive(l.inserted, l.removed, l.escaped, l.inserted_mass, l.removed_mass, l.escaped_mass);
}
template <class Archive>
void fields(Archive& archive, EnergyAccount::Total& t) {
  archive(t.low, t.high);
}
template <class Archive>
void fields(Archive& archive, EnergyAccount& e) {
  archive(e.begun, e.terms, e.last_terms, e.body_forces, e.last_body_forces, e.start, e.inserted, e.removed);
}
template <class Archive>
void fields(Archive& archive, Escape& e) {
  archive(e.id, e.time, e.position, e.velocity, e.through);
}
template <class Archive>
void fields(Archive& archive, PhaseProgress& p) {
  archive(p.phase, p.phase_start);
}
template <class Archive>
void fields(Archive& archive, State& s) {
  archive(s.step, s.parcels.body, s.parcels.load, s.pairs, s.walls, s.motions, s.body_absent, s.sources,
          s.next_id, s.ledger, s.energy, s.escapes, s.progress);
}

}  // namespace pulvis
