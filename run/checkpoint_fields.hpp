// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/simulation/state_fields.hpp"
#include "run/checkpoint.hpp"

// What of a run goes into a checkpoint besides the state of the engine: change it, and Checkpoint::version must
// change too.
namespace pulvis {

template <class Archive>
void fields(Archive& archive, CaseKey& k) {
  archive(k.key, k.value, k.meaning);
}
template <class Archive>
void fields(Archive& archive, WallLoad& load) {
  archive(load.force, load.torque);
}
template <class Archive>
void fields(Archive& archive, TileLoad& load) {
  archive(load.normal, load.shear);
}
template <class Archive>
void fields(Archive& archive, WallWindow& w) {
  archive(w.start, w.end, w.samples, w.walls, w.bodies, w.tiles, w.facets);
}
template <class Archive>
void fields(Archive& archive, WallRecord& r) {
  archive(r.steps_per_window, r.steps_in_window, r.cycles, r.current, r.last);
}
template <class Archive>
void fields(Archive& archive, measures::Flow& f) {
  archive(f.forward_mass, f.backward_mass, f.forward_count, f.backward_count);
}
template <class Archive>
void fields(Archive& archive, measures::FlowMeter::State& s) {
  archive(s.flow, s.ids, s.places);
}
template <class Archive>
void fields(Archive& archive, FlowRecord& r) {
  archive(r.meter, r.phase_mass, r.line_mass, r.phase_count, r.phase_start, r.line_start);
}
template <class Archive>
void fields(Archive& archive, Measure& m) {
  archive(m.name, m.value, m.unit, m.window);
}
template <class Archive>
void fields(Archive& archive, WallForce& w) {
  archive(w.name, w.load, w.window);
}
template <class Archive>
void fields(Archive& archive, PhaseRecord& p) {
  archive(p.name, p.start, p.end, p.ended_by, p.measures, p.walls);
}
template <class Archive>
void fields(Archive& archive, RunSummary& s) {
  archive(s.resumes, s.particle_steps, s.phases, s.notes, s.warnings);
}
template <class Archive>
void fields(Archive& archive, TaskSeconds& t) {
  for (double& seconds : t.of) archive(seconds);
}
template <class Archive>
void fields(Archive& archive, VtkSeries::Frame& f) {
  archive(f.time, f.file);
}
template <class Archive>
void fields(Archive& archive, WrittenFrames& f) {
  archive(f.parcels, f.walls, f.porosity, f.fields, f.count, f.last);
}
template <class Archive>
void fields(Archive& archive, WrittenResults& r) {
  archive(r.log, r.wall_log, r.measures, r.frames, r.files, r.largest_overlap);
}

}  // namespace pulvis
