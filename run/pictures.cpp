// SPDX-License-Identifier: Apache-2.0
#include "run/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/units.hpp"
#include "output/picture.hpp"
#include "run/body_pull.hpp"
#include "run/measuring.hpp"
#include "run/wall_mesh.hpp"

namespace pulvis {
namespace {

Vec3 middle_of(const measures::Container& die) {
  const bool box = die.shape == measures::Container::Shape::box;
  return box ? 0.5 * (die.min + die.max) : die.base + (0.5 * die.height) * die.axis;
}

/// Upright through the middle of the die, square to y where that is level and else to x.
CutPlane cut_through(const Vec3& middle, const Vec3& up) {
  // A slight tilt must not turn the picture, hence the tolerance.
  const bool along_y = std::abs(up.y) < std::abs(up.x) + 0.1;
  const Vec3 wish = along_y ? Vec3{0, -1, 0} : Vec3{1, 0, 0};
  return {middle, wish - dot(wish, up) * up};
}

/// What the colour of a parcel says: a value each, and the ends of its scale.
struct Colouring {
  std::vector<double> values;
  ColourBar bar;
};

Colouring by_contacts(const Sight& sight) {
  Colouring c{{}, {"contacts per parcel", 0.0, 8.0}};
  for (const std::int32_t contacts : contacts_of(sight)) c.values.push_back(contacts);
  return c;
}

/// The scale ends where 99 % of the parcels are slower, so that one stray does not darken the rest.
Colouring by_speed(const Sight& sight) {
  Colouring c{{}, {"speed (mm/s)", 0.0, 1.0}};
  for (const measures::Body& body : sight.bodies) c.values.push_back(1e3 * norm(body.velocity));
  if (c.values.empty()) return c;
  std::vector<double> sorted = c.values;
  const auto most =
      sorted.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), most, sorted.end());
  c.bar.maximum = std::max(*most, 1e-3);
  return c;
}

Colouring by_size(const Sight& sight) {
  Colouring c{{}, {"diameter (mm)", 0.0, 1.0}};
  for (const measures::Sphere& sphere : sight.spheres) c.values.push_back(2e3 * sphere.radius);
  if (c.values.empty()) return c;
  const auto [least, most] = std::minmax_element(c.values.begin(), c.values.end());
  // All the same size is one colour, not noise of the last digit.
  c.bar.minimum = *least * (*most > 1.001 * *least ? 1.0 : 0.5);
  c.bar.maximum = *most;
  return c;
}

}  // namespace

Photographer::Photographer(const Case& c, const Simulation& simulation, const std::string& phase)
    : sight_(look_at(simulation)) {
  base_.walls = mesh_of_walls(simulation.model().walls, simulation.model().domain,
                              [&](std::uint32_t body) -> const Pose& { return simulation.pose(body); })
                    .mesh;
  base_.up = up_at(c, simulation.time());
  if (const auto die = measured_container(c, simulation))
    cut_ = cut_through(placement_of_container(c, simulation)(middle_of(*die)), base_.up);
  base_.title = c.title.empty() ? c.file : c.title;
  base_.caption =
      fmt::format("after phase \"{}\", t = {}", phase, format_quantity(simulation.time(), dimension::time));
  base_.threads = simulation.most_threads();
}

void Photographer::write(const std::string& path, View view) const {
  const Colouring colouring = view == View::speed  ? by_speed(sight_)
                              : view == View::size ? by_size(sight_)
                                                   : by_contacts(sight_);
  const double low = colouring.bar.minimum, high = colouring.bar.maximum;
  PictureRequest request = base_;
  for (std::size_t k = 0; k < sight_.spheres.size(); ++k)
    request.spheres.push_back(
        {sight_.spheres[k].centre, sight_.spheres[k].radius,
         static_cast<float>(std::clamp((colouring.values[k] - low) / (high - low), 0.0, 1.0))});
  request.colour_bar = colouring.bar;
  if (view != View::whole) request.cut = cut_;
  write_picture(path, request);
}

}  // namespace pulvis
