// SPDX-License-Identifier: Apache-2.0
#include "run/flow_meters.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/base/failure.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t steps_between_looks = 16;  // a parcel moves a small part of its radius meanwhile

double over(double mass, double seconds) { return seconds > 0.0 ? mass / seconds : 0.0; }

/// Places in the store, in the order of ids; what a sort would give, but ids are dense.
std::vector<std::uint32_t> in_order_of_ids(const State& state) {
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> place(state.next_id, none), order;
  for (std::uint32_t k = 0; k < state.parcels.size(); ++k) place[state.parcels.body[k].id] = k;
  std::copy_if(place.begin(), place.end(), std::back_inserter(order),
               [](std::uint32_t k) { return k != none; });
  return order;
}

}  // namespace

FlowMeters::FlowMeters(const Case& c, const Simulation& simulation) : case_(c) {
  const NearestImage periods = NearestImage::of(simulation.model().domain);
  for (const FlowSurface& s : c.measures.surfaces) {
    measures::FlowSurface surface;
    surface.shape = s.radius ? measures::FlowSurface::Shape::disc : measures::FlowSurface::Shape::plane;
    surface.point = s.point;
    surface.normal = s.normal;
    surface.radius = s.radius.value_or(0.0);
    meters_.emplace_back(surface, periods.length);
  }
  records_.resize(meters_.size());
}

void FlowMeters::look(const Simulation& simulation) {
  if (meters_.empty()) return;
  const State& state = simulation.state();
  const std::vector<std::uint32_t> order = in_order_of_ids(state);
  std::vector<std::uint32_t> ids;
  std::vector<Vec3> places;
  std::vector<double> masses;
  for (const std::uint32_t k : order) {
    const Parcel& p = state.parcels.body[k];
    ids.push_back(p.id);
    places.push_back(p.position);
    masses.push_back(p.mass);
  }
  for (measures::FlowMeter& meter : meters_) meter.look(ids, places, masses);
}

bool FlowMeters::look_at(std::uint64_t step) const {
  return !meters_.empty() && step % steps_between_looks == 0;
}

void FlowMeters::after_step(const Simulation& simulation) {
  if (look_at(simulation.state().step)) look(simulation);
}

void FlowMeters::begin_phase(const Simulation& simulation) {
  look(simulation);
  for (std::size_t k = 0; k < meters_.size(); ++k) {
    records_[k].phase_mass = meters_[k].flow().mass();
    records_[k].phase_count = meters_[k].flow().count();
    records_[k].phase_start = simulation.time();
  }
}

std::vector<FlowSince> FlowMeters::in_phase(const Simulation& simulation) const {
  std::vector<FlowSince> list;
  for (std::size_t k = 0; k < meters_.size(); ++k) {
    const double mass = meters_[k].flow().mass() - records_[k].phase_mass;
    list.push_back({case_.measures.surfaces[k].name, mass,
                    meters_[k].flow().count() - records_[k].phase_count,
                    over(mass, simulation.time() - records_[k].phase_start)});
  }
  return list;
}

std::vector<FlowSince> FlowMeters::since_last_line(const Simulation& simulation) {
  look(simulation);
  std::vector<FlowSince> list;
  for (std::size_t k = 0; k < meters_.size(); ++k) {
    const double mass = meters_[k].flow().mass() - records_[k].line_mass;
    list.push_back(
        {case_.measures.surfaces[k].name, mass, 0, over(mass, simulation.time() - records_[k].line_start)});
    records_[k].line_mass = meters_[k].flow().mass();
    records_[k].line_start = simulation.time();
  }
  return list;
}

std::vector<FlowRecord> FlowMeters::record() const {
  std::vector<FlowRecord> record = records_;
  for (std::size_t k = 0; k < meters_.size(); ++k) record[k].meter = meters_[k].state();
  return record;
}

void FlowMeters::go_on_from(std::vector<FlowRecord> record) {
  if (record.size() != meters_.size())
    throw Failure(Exit::bad_input, "the saved flow is through other surfaces than the case has");
  for (std::size_t k = 0; k < meters_.size(); ++k) {
    try {
      meters_[k].restore(std::move(record[k].meter));
    } catch (const std::invalid_argument& error) {
      throw Failure(Exit::bad_input, error.what());
    }
    record[k].meter = {};
  }
  records_ = std::move(record);
}

}  // namespace pulvis
