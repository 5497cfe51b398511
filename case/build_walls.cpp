// SPDX-License-Identifier: Apache-2.0
#include "case/build_walls.hpp"

#include <filesystem>
#include <map>

namespace pulvis::case_file {
namespace {

const std::map<std::string, Wall::Shape> wall_shapes{
    {"plane", Wall::Shape::plane},       {"rectangle", Wall::Shape::rectangle},
    {"disc", Wall::Shape::disc},         {"box", Wall::Shape::box},
    {"cylinder", Wall::Shape::cylinder}, {"cone", Wall::Shape::cone},
    {"sphere", Wall::Shape::sphere},     {"mesh", Wall::Shape::mesh}};

const std::map<std::string, double> metres_per_unit{
    {"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"inch", 0.0254}};

void build_shape(const Section& section, const std::string& folder, Wall& wall) {
  switch (wall.shape) {
    case Wall::Shape::plane:
      wall.point = section.vector("point");
      wall.normal = section.unit_vector("normal");
      break;
    case Wall::Shape::rectangle:
      wall.point = section.vector("corner");
      wall.along = section.vector("along");
      wall.across = section.vector("across");
      break;
    case Wall::Shape::disc:
      wall.point = section.vector("centre");
      wall.normal = section.unit_vector("normal");
      wall.radius = section.number("radius");
      wall.other_radius = section.number("hole_radius");
      break;
    case Wall::Shape::box:
    case Wall::Shape::cylinder:
      wall.region = build_region(section);
      wall.open = section.texts("open");
      break;
    case Wall::Shape::cone:
      wall.point = section.vector("base");
      wall.normal = section.unit_vector("axis");
      wall.radius = section.number("radius");
      wall.other_radius = section.number("top_radius");
      wall.height = section.number("height");
      wall.open = section.texts("open");
      break;
    case Wall::Shape::sphere:
      wall.point = section.vector("centre");
      wall.radius = section.number("radius");
      break;
    case Wall::Shape::mesh:
      wall.path = (std::filesystem::path(folder) / section.text("path")).lexically_normal().string();
      wall.unit = metres_per_unit.at(section.text("unit"));
      wall.offset = section.vector("offset");
      wall.feature_angle = 2.0 * pi * section.number("feature_angle");  // given in turns
      break;
  }
}

motions::Wave wave(const Section& section, const std::string& amplitude) {
  return {section.number(amplitude), section.number("frequency"), section.number("phase")};
}

motions::Sine sine(const Section& section) {
  const double frequency = section.number("frequency"), angular = 2.0 * pi * frequency;
  const auto acceleration = section.optional_number("peak_acceleration");
  const double amplitude = acceleration ? *acceleration / (angular * angular) : section.number("amplitude");
  return {{amplitude, frequency, section.number("phase")}, section.unit_vector("direction")};
}

motions::SquareWave modulated_square(const Section& section) {
  motions::SquareWave result;
  result.frequency = section.number("frequency");
  result.direction = section.unit_vector("direction");
  result.rise_time = section.optional_number("rise_time");
  result.modulation_period = section.optional_number("modulation_period");
  const auto acceleration = section.optional_number("peak_acceleration");
  result.amplitude = 1.0;  // the acceleration is proportional to it
  result.amplitude = acceleration ? *acceleration / result.peaks().acceleration : section.number("amplitude");
  return result;
}

motions::Sines sines(const Section& section) {
  motions::Sines result;
  result.direction = section.unit_vector("direction");
  const auto& amplitudes = section.numbers("amplitudes");
  const auto& frequencies = section.numbers("frequencies");
  const Setting* phases = section.find("phases");
  for (std::size_t k = 0; k < amplitudes.size(); ++k)
    result.waves.push_back({amplitudes[k], frequencies[k], phases != nullptr ? phases->numbers[k] : 0.0});
  return result;
}

motions::Path path(const Section& section) {
  motions::Path result;
  result.times = section.numbers("times");
  result.positions.resize(result.times.size());
  for (int axis = 0; axis < 3; ++axis)
    if (const Setting* list = section.find(std::string(1, "xyz"[axis])))
      for (std::size_t k = 0; k < list->numbers.size(); ++k) result.positions[k][axis] = list->numbers[k];
  result.between =
      section.text("between") == "line" ? motions::Path::Between::linear : motions::Path::Between::cubic;
  return result;
}

motions::Kind kind_of(const Section& section) {
  const std::string& kind = section.text("kind");
  if (kind == "translation") return motions::Translation{section.vector("velocity")};
  if (kind == "rotation")
    return motions::Rotation{section.vector("point"), section.unit_vector("axis"), section.number("rate"),
                             section.number("ramp")};
  if (kind == "sine") return sine(section);
  if (kind == "swing")
    return motions::Swing{wave(section, "angle"), section.vector("point"), section.unit_vector("axis")};
  if (kind == "sines") return sines(section);
  if (kind == "modulated_square") return modulated_square(section);
  if (kind == "path") return path(section);
  return motions::Stroke{section.number("distance"),
                         section.unit_vector("direction"),
                         section.number("speed"),
                         section.number("acceleration"),
                         static_cast<int>(section.integer("passes")),
                         section.number("pause")};
}

}  // namespace

Region build_region(const Section& section) {
  Region result;
  result.shape = section.text("shape") == "box" ? Region::Shape::box : Region::Shape::cylinder;
  if (result.shape == Region::Shape::box) {
    result.min = section.vector("min");
    result.max = section.vector("max");
  } else {
    result.base = section.vector("base");
    result.axis = section.unit_vector("axis");
    result.radius = section.number("radius");
    result.height = section.number("height");
  }
  return result;
}

Wall build_wall(const Section& section, const std::string& folder) {
  Wall result;
  result.name = section.name;
  result.shape = wall_shapes.at(section.text("shape"));
  const std::string* body = section.optional_text("body");
  result.body = body != nullptr ? *body : section.name;
  build_shape(section, folder, result);
  return result;
}

Motion build_motion(const Section& section) {
  Motion result;
  result.name = section.name;
  result.motion.kind = kind_of(section);
  result.motion.start = section.number("start");
  result.motion.end = section.optional_number("end").value_or(result.motion.end);
  return result;
}

}  // namespace pulvis::case_file
