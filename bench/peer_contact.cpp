// SPDX-License-Identifier: Apache-2.0
// One contact of two spheres that are held where they are, for bench/peers: what the law says after so many steps
// at constant velocities. Reads lines of numbers from standard input,
//   law radius1 radius2 overlap vx vy vz w1x w1y w1z w2x w2y w2z dt steps
// (SI; the first sphere lies at smaller x and has the velocity, the second rests; both spin), and prints force and
// torque of the first, and the torque of the second:
//   fx fy fz  t1x t1y t1z  t2x t2y t2z
#include <fmt/format.h>

#include <iostream>
#include <sstream>

#include "bench/peer_laws.hpp"

namespace {

using namespace pulvis;

struct Question {
  std::string law;
  double radius[2], overlap;
  Vec3 velocity, spin[2];
  double dt;
  int steps;
};

std::istream& operator>>(std::istream& in, Vec3& v) { return in >> v.x >> v.y >> v.z; }

bool read(const std::string& line, Question& q) {
  std::istringstream words(line);
  return static_cast<bool>(words >> q.law >> q.radius[0] >> q.radius[1] >> q.overlap >> q.velocity >>
                           q.spin[0] >> q.spin[1] >> q.dt >> q.steps);
}

laws::Touch touch_of(const Question& q, double density) {
  const double mass[2] = {density * sphere_volume(q.radius[0]), density * sphere_volume(q.radius[1])};
  const double arm[2] = {q.radius[0] - 0.5 * q.overlap, q.radius[1] - 0.5 * q.overlap};
  laws::Touch touch{};
  touch.overlap = q.overlap;
  touch.radius = q.radius[0] * q.radius[1] / (q.radius[0] + q.radius[1]);
  touch.mass = mass[0] * mass[1] / (mass[0] + mass[1]);
  touch.normal = touch.half_normal = {1, 0, 0};
  touch.velocity = q.velocity + cross(arm[0] * q.spin[0] + arm[1] * q.spin[1], touch.normal);
  touch.spin = q.spin[0] - q.spin[1];
  touch.shared_spin = 0.5 * dot(q.spin[0] + q.spin[1], touch.normal);
  touch.dt = q.dt;
  for (int k = 0; k < 2; ++k) {
    (k == 0 ? touch.radius_first : touch.radius_second) = q.radius[k];
    (k == 0 ? touch.mass_first : touch.mass_second) = mass[k];
  }
  return touch;
}

void answer(const Question& q, const peers::PeerLaw& peer) {
  const laws::Law law = scenes::law_of(peer.parts);
  const laws::PairConstants constants =
      law.mix(scenes::material_pair(peer.stuff, peer.stuff), peer.parts.choices);
  laws::Touch touch = touch_of(q, peer.stuff.density);
  laws::Response r{};
  for (int k = 0; k < q.steps; ++k) {
    r = law.evaluate(touch, r.history, constants);
    touch.was_touching = 1.0;
  }
  // The force acts on the first at arm * n, the opposite on the second at -arm * n.
  const double arm[2] = {q.radius[0] - 0.5 * q.overlap, q.radius[1] - 0.5 * q.overlap};
  const Vec3 first = cross(arm[0] * touch.normal, r.force) + r.roll_torque;
  const Vec3 second = cross(arm[1] * touch.normal, r.force) - r.roll_torque;
  fmt::print("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", r.force.x,
             r.force.y, r.force.z, first.x, first.y, first.z, second.x, second.y, second.z);
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    Question question{};
    const bool whole = read(line, question);
    const auto law = whole ? peers::peer_law(question.law) : std::nullopt;
    if (!law) {
      fmt::print(stderr, "peer_contact: \"{}\" is not a law and its numbers (see bench/peer_contact.cpp)\n",
                 line);
      return 2;
    }
    answer(question, *law);
  }
  return 0;
}
