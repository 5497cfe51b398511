// SPDX-License-Identifier: Apache-2.0
#include "run/measures_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace pulvis {
namespace {

using Json = nlohmann::ordered_json;
using measures::Tensor;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(); }
Json number(std::size_t value) { return value; }
Json number(const Vec3& v) { return Json{number(v.x), number(v.y), number(v.z)}; }
Json number(const Tensor& t) { return Json{number(t.rows[0]), number(t.rows[1]), number(t.rows[2])}; }

template <class Value>
Json list(const std::vector<Value>& values) {
  Json json = Json::array();
  for (const Value& value : values) json.push_back(number(value));
  return json;
}

/// In coordinates of the die.
std::vector<Vec3> seen_from(const measures::DieFrame& frame, const std::vector<Vec3>& vectors) {
  std::vector<Vec3> seen;
  for (const Vec3& v : vectors)
    seen.push_back({dot(frame.axes()[0], v), dot(frame.axes()[1], v), dot(frame.axes()[2], v)});
  return seen;
}

Json die_json(const measures::Container& die, const measures::DieFrame& frame) {
  return {{"shape", die.shape == measures::Container::Shape::box ? "box" : "cylinder"},
          {"size_m", number(frame.size())},
          {"volume_m3", measures::volume(die)}};
}

Json porosity_json(const measures::PorosityField& field) {
  return {{"cells", {field.cells[0], field.cells[1], field.cells[2]}},
          {"spacing_m", number(field.spacing)},
          {"values", list(field.values)},
          {"volume_m3", list(field.counted_volume)}};
}

Json profiles_json(const std::array<measures::PorosityProfile, 3>& profiles) {
  constexpr const char* names[3] = {"first", "second", "third"};
  Json json = Json::array();
  for (std::size_t axis = 0; axis < 3; ++axis)
    json.push_back({{"axis", names[axis]},
                    {"position_m", list(profiles[axis].position)},
                    {"porosity", list(profiles[axis].porosity)},
                    {"volume_m3", list(profiles[axis].volume)}});
  return json;
}

Json parts_json(const std::vector<PartSurvey>& parts) {
  Json json = Json::array();
  for (const PartSurvey& p : parts)
    json.push_back({{"name", p.part.name},
                    {"min_m", number(p.part.box.min)},
                    {"max_m", number(p.part.box.max)},
                    {"porosity", number(p.porosity.porosity)},
                    {"porosity_std", number(p.porosity.standard_deviation)},
                    {"volume_m3", number(p.porosity.volume)},
                    {"mass_kg", number(p.porosity.mass)},
                    {"apparent_density_kg_m3", number(p.porosity.density)},
                    {"coordination", number(p.coordination)}});
  return json;
}

Json surface_json(const measures::FreeSurface& s) {
  return {{"columns", {s.along_first.count(), s.along_second.count()}},
          {"spacing_m", {s.along_first.part(), s.along_second.part()}},
          {"heights_m", list(s.heights)},
          {"areas_m2", list(s.areas)},
          {"mean_m", s.mean},
          {"roughness_m", s.roughness},
          {"slope_first", s.slope_first},
          {"slope_second", s.slope_second},
          {"tilt_rad", s.tilt}};
}

Json forces_json(const measures::ContactForces& f) {
  return {{"mean_N", number(f.mean)},
          {"edges", list(f.edges)},
          {"density", list(f.density)},
          {"pulling_share", number(f.pulling_share)}};
}

Json stress_json(const measures::Stress& s, const measures::DieFrame& frame) {
  return {{"tensor_Pa", number(measures::along_axes(s.total(), frame.axes()))},
          {"pressure_Pa", s.pressure()},
          {"kinetic_pressure_Pa", s.kinetic_pressure()}};
}

Json flow_json(const std::vector<FlowSince>& flow) {
  Json json = Json::array();
  for (const FlowSince& f : flow)
    json.push_back({{"surface", f.surface}, {"mass_kg", f.mass}, {"count", f.count}, {"rate_kg_s", f.rate}});
  return json;
}

Json layers_json(const measures::Layers& l, const measures::DieFrame& frame) {
  std::vector<Tensor> stress;
  for (std::size_t k = 0; k < l.contact_stress.size(); ++k)
    stress.push_back(measures::along_axes(l.contact_stress[k] + l.kinetic_stress[k], frame.axes()));
  return {{"height_m", list(l.position)},
          {"density_kg_m3", list(l.density)},
          {"velocity_m_s", list(seen_from(frame, l.velocity))},
          {"speed_rms_m_s", list(l.speed_rms)},
          {"granular_temperature_m2_s2", list(l.temperature)},
          {"stress_Pa", list(stress)},
          {"mean_diameter_m", list(l.mean_diameter)},
          {"coordination", list(l.coordination)}};
}

}  // namespace

Json scalars_json(const std::vector<Measure>& measures) {
  Json json = Json::object();
  for (const Measure& m : measures)
    json[m.name] = {{"value", m.value ? Json(*m.value) : Json()}, {"unit", m.unit}, {"window", m.window}};
  return json;
}

Json measures_json(double time, const std::string& phase, const std::vector<Measure>& measures,
                   const std::optional<DieSurvey>& die, const std::vector<FlowSince>& flow) {
  Json json = {{"format", "pulvis measures"}, {"version", 1}, {"phase", phase}, {"time_s", time}};
  json["scalars"] = scalars_json(measures);
  if (!flow.empty()) json["flow"] = flow_json(flow);
  if (!die) return json;
  const measures::DieFrame frame(die->container);
  json["die"] = die_json(die->container, frame);
  json["porosity"] = porosity_json(die->porosity);
  json["porosity_profiles"] = profiles_json(die->profiles);
  if (!die->histogram.share.empty())
    json["porosity_histogram"] = {{"edges", list(die->histogram.edges)},
                                  {"share", list(die->histogram.share)}};
  json["parts"] = parts_json(die->parts);
  json["surface"] = surface_json(die->surface);
  json["coordination"] = {{"count", list(die->coordination.histogram)}};
  if (die->forces.mean) json["contact_forces"] = forces_json(die->forces);
  if (die->stress) json["stress"] = stress_json(*die->stress, frame);
  json["layers"] = layers_json(die->layers, frame);
  json["segregation"] = {{"mean_diameter_m", number(die->segregation.mean_diameter)},
                         {"index", number(die->segregation.index)},
                         {"intensity", number(die->segregation.intensity)}};
  return json;
}

}  // namespace pulvis
