// SPDX-License-Identifier: Apache-2.0
// A box sheared by Lees-Edwards boundaries: what crosses its moving faces must not notice them, and nothing but the
// model and the start may matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "tests/engine/sticky_scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using pulvis::validation::Draw;

namespace {

constexpr double width = 0.008;
constexpr std::uint64_t steps = 3400;

struct Choice {
  const char *normal, *sliding, *cohesion;
  int flow, gradient;
};

/// A fully periodic box of 8 mm, sheared at 60 per second: faces pass each other at 0.48 m/s.
Model sheared_model(const Choice& choice, double skin = 1.0) {
  laws::MaterialPair pair = remembering_pair();
  pair.normal_stiffness = 300.0;
  pair.tangential_ratio = 2.0 / 7.0;
  LawParts parts;
  parts.normal = choice.normal;
  parts.sliding = choice.sliding;
  parts.cohesion = choice.cohesion;
  Model m = one_pair(pair, parts, {-0.001, 0.002, 0.0}, {width - 0.001, width + 0.002, width}, 1e-5, 0.3e-3,
                     0.5e-3);
  m.body_force.gravity = {};
  for (bool& periodic : m.domain.periodic) periodic = true;
  m.domain.shear = {choice.flow, choice.gradient, 60.0, 0.0031};
  m.skin = skin;
  return m;
}

constexpr Choice jkr{"jkr", "total_spring", "none", 0, 1};

std::vector<Parcel> sheared_parcels(const Model& m) {
  std::vector<Parcel> list;
  for (std::uint32_t k = 0; k < 512; ++k) {
    Draw draw(k, 51);
    const Vec3 at = m.domain.min + Vec3{0.5 + (k % 8), 0.5 + (k / 8 % 8), 0.5 + (k / 64)} * (width / 8);
    list.push_back(parcel(k, at, draw.between(0.3e-3, 0.5e-3), 2500.0,
                          m.domain.flow_velocity(at) + draw.vector(0.4), draw.vector(100.0)));
  }
  return list;
}

Simulation sheared_start(const Choice& choice, int threads, double skin = 1.0) {
  const Model m = sheared_model(choice, skin);
  return Simulation(m, state_of(m, sheared_parcels(m)), threads);
}

std::string hash_after(Simulation s, std::uint64_t count = steps) {
  go(s, count);
  return state_hash(s.snapshot());
}

/// Follows parcels across the faces: how often each crossed, from one step to the next.
class Crossings {
 public:
  explicit Crossings(const Simulation& s) { look(s, false); }
  void look(const Simulation& s, bool count = true) {
    const Shear& shear = s.model().domain.shear;
    const double height = s.images().slide.height;
    for (const Parcel& p : s.state().parcels.body) {
      const double at = p.position[shear.gradient];
      if (count) net_[p.id] -= static_cast<int>(Slide::crossed(at - last_[p.id], height));
      last_[p.id] = at;
    }
  }
  int net(std::uint32_t id) const { return net_.at(id); }
  std::size_t moved() const {
    return static_cast<std::size_t>(
        std::count_if(net_.begin(), net_.end(), [](const auto& n) { return n.second != 0; }));
  }

 private:
  std::map<std::uint32_t, double> last_;
  std::map<std::uint32_t, int> net_;
};

/// Momentum as if no parcel had been brought back, and the sum of its magnitudes.
std::pair<Vec3, double> unwrapped_momentum(const Simulation& s, const Crossings* crossings) {
  Vec3 sum;
  double scale = 0.0;
  for (const Parcel& p : s.state().parcels.body) {
    Vec3 velocity = p.velocity;
    if (crossings) velocity[s.images().slide.flow] += crossings->net(p.id) * s.images().slide.jump;
    sum += p.mass * velocity;
    scale += p.mass * norm(velocity);
  }
  return {sum, scale};
}

TEST(ShearedBox, SceneIsWorthTheTrouble) {
  Simulation s = sheared_start(jkr, 1);
  Crossings crossings(s);
  std::size_t across = 0;
  for (std::uint64_t k = 0; k < steps; ++k) {
    s.step();
    crossings.look(s);
    for (std::size_t slot = 0; slot < s.pairs().slots(); ++slot) {
      if (!s.pairs().touching[slot]) continue;
      const auto& body = s.state().parcels.body;
      across += std::abs(body[s.pairs().first[slot]].position.y - body[s.pairs().second[slot]].position.y) >
                0.5 * width;
    }
  }
  EXPECT_GT(across, 20 * steps) << "contacts live across the moving faces";
  EXPECT_GT(crossings.moved(), 30u);
  EXPECT_GT(s.rebuilds(), 50u);
  EXPECT_GT(s.pairs().pack(s.state().parcels, 1).size(), 500u);
}

TEST(ShearedBox, HashIsTheSameForAnyThreadsSkinAndOrderOfTheStore) {
  const std::string plain = hash_after(sheared_start(jkr, 1));
  for (const int threads : {2, 3}) EXPECT_EQ(hash_after(sheared_start(jkr, threads)), plain);
  EXPECT_EQ(hash_after(sheared_start(jkr, 1, 0.4)), plain);
  EXPECT_EQ(hash_after(sheared_start(jkr, 1, 2.0)), plain);
  const Model m = sheared_model(jkr);
  auto parcels = sheared_parcels(m);
  std::reverse(parcels.begin(), parcels.end());
  EXPECT_EQ(hash_after(Simulation(m, state_of(m, parcels), 2)), plain);
}

TEST(ShearedBox, HashIsTheSameForEveryInstructionSetAlongAllAxes) {
  for (const Choice& choice : {Choice{"hooke", "total_spring", "none", 0, 1},
                               {"hertz", "total_spring", "none", 1, 0},
                               {"hertz", "total_spring", "capillary_willett", 0, 2},
                               {"edinburgh", "rescaled_spring", "none", 2, 0},
                               {"jkr", "incremental_spring", "none", 1, 2},
                               {"hertz", "rescaled_spring", "none", 2, 1}}) {
    const std::string plain = hash_after(sheared_start(choice, 1), 1000);
    for (const char* set : {"baseline", "avx2", "avx512"}) {
      setenv("PULVIS_INSTRUCTION_SET", set, 1);
      EXPECT_EQ(hash_after(sheared_start(choice, 2, 0.5), 1000), plain) << choice.normal << ' ' << set;
    }
    unsetenv("PULVIS_INSTRUCTION_SET");
  }
}

TEST(ShearedBox, HashIsTheSameAfterSavingAndLoadingOnTheWay) {
  const std::string plain = hash_after(sheared_start(jkr, 1));
  for (const std::uint64_t moment : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1777}, steps - 1}) {
    Simulation first = sheared_start(jkr, 1);
    go(first, moment);
    const auto bytes = save_state(first.snapshot());
    Simulation second(sheared_model(jkr, 0.7), load_state(bytes), 2);
    EXPECT_EQ(hash_after(std::move(second), steps - moment), plain) << "saved at step " << moment;
  }
}

TEST(ShearedBox, KeepsTheMomentumOfUnwrappedVelocities) {
  for (const char* normal : {"hooke", "hertz", "jkr"}) {
    Simulation s = sheared_start({normal, "total_spring", "none", 0, 1}, 1);
    Crossings crossings(s);
    const Vec3 start = unwrapped_momentum(s, nullptr).first;
    for (std::uint64_t k = 0; k < steps; ++k) s.step(), crossings.look(s);
    const auto [momentum, scale] = unwrapped_momentum(s, &crossings);
    ASSERT_GT(crossings.moved(), 30u);
    EXPECT_LT(norm(momentum - start), 1e-12 * scale) << normal;
    RecordProperty(std::string(normal) + "_e15", std::to_string(norm(momentum - start) / scale * 1e15));
  }
}

/// Without contacts every parcel goes straight on; back again with velocities and shear reversed, it is where it was.
TEST(ShearedBox, FreeFlightReturnsWhenVelocitiesAndShearAreReversed) {
  Model m = sheared_model({"hertz", "total_spring", "none", 2, 0});
  std::vector<Parcel> parcels = sheared_parcels(m);
  parcels.resize(64);
  for (Parcel& p : parcels) p.radius *= 2e-3;
  m.smallest_radius *= 2e-3;
  m.largest_radius *= 2e-3;
  m.dt = 5e-7;
  Simulation there(m, state_of(m, parcels), 1);
  Crossings crossings(there);
  for (int k = 0; k < 40000; ++k) there.step(), crossings.look(there);
  ASSERT_GT(crossings.moved(), 10u);

  Model back = m;
  back.domain.shear.rate = -m.domain.shear.rate;
  back.domain.shear.shift_at_start = there.images().slide.shift;
  State turned = there.snapshot();
  ASSERT_EQ(turned.pairs.size(), 0u);
  turned.step = 0;
  for (Parcel& p : turned.parcels.body) p.velocity = -1.0 * p.velocity;
  Simulation home(back, turned, 1);
  for (int k = 0; k < 40000; ++k) home.step();
  double farthest = 0.0, fastest = 0.0;
  for (const Parcel& p : home.state().parcels.body) {
    farthest = std::max(farthest, norm(home.images()(p.position - parcels[p.id].position)));
    fastest = std::max(fastest, norm(p.velocity + parcels[p.id].velocity));
  }
  EXPECT_LT(farthest, 1e-10 * width);
  EXPECT_LT(fastest, 1e-12);
  RecordProperty("farthest_over_width_e15", std::to_string(farthest / width * 1e15));
}

/// Two parcels that meet obliquely, in the middle of the box or across its upper face: seen from their common frame
/// the same. Returns both after the contact, brought back to where they began.
struct Meeting {
  Vec3 position[2], velocity[2], spin[2];
  std::uint64_t touched = 0;
};
Meeting meet(const Choice& choice, double height_above_middle) {
  Model m = sheared_model(choice);
  m.dt = 2e-6;
  const Shear& shear = m.domain.shear;
  const Vec3 middle = 0.5 * (m.domain.min + m.domain.max);
  Vec3 up, jump;
  up[shear.gradient] = height_above_middle;
  jump[shear.flow] = shear.rate * height_above_middle;
  Vec3 apart{0.3e-3, 0.35e-3, 0.65e-3}, closing{-0.5, -0.3, -0.6};
  std::vector<Parcel> parcels{
      parcel(0, middle + up - 0.5 * apart, 0.4e-3, 2500.0, jump - 0.5 * closing, {200, -300, 100}),
      parcel(1, middle + up + 0.5 * apart, 0.4e-3, 2500.0, jump + 0.5 * closing, {-100, 50, 400})};
  const Slide at_start = Slide::of(m.domain, 0.0);
  for (Parcel& p : parcels) {  // into the box, as the images they are
    const double out = p.position[shear.gradient] >= m.domain.max[shear.gradient] ? 1.0 : 0.0;
    p.position[shear.gradient] -= out * at_start.height;
    p.position[shear.flow] -= out * at_start.shift;
    p.velocity[shear.flow] -= out * at_start.jump;
    const double length = m.domain.extent()[shear.flow];
    if (p.position[shear.flow] < m.domain.min[shear.flow]) p.position[shear.flow] += length;
  }
  Simulation s(m, state_of(m, parcels), 1);
  Meeting result;
  for (int k = 0; k < 1200; ++k) s.step(), result.touched += touching(s.pairs());
  for (const Parcel& p : s.state().parcels.body) {
    Vec3 from_middle = p.position - middle, velocity = p.velocity;
    if (from_middle[shear.gradient] < 0.0 && height_above_middle > 0.0) {
      from_middle[shear.gradient] += s.images().slide.height;
      from_middle[shear.flow] += s.images().slide.shift;
      velocity[shear.flow] += s.images().slide.jump;
    }
    // The pair as a whole moves with the flow.
    const Vec3 moved = from_middle - up - s.time() * jump;
    result.position[p.id] = s.images().periods(moved);
    result.velocity[p.id] = velocity - jump;
    result.spin[p.id] = p.spin;
  }
  return result;
}

TEST(ShearedBox, AContactAcrossTheMovingFaceIsThatInsideTheBox) {
  for (const Choice& choice : {Choice{"hooke", "total_spring", "none", 0, 1},
                               {"hertz", "rescaled_spring", "none", 1, 2},
                               {"hertz", "incremental_spring", "capillary_willett", 2, 1},
                               {"edinburgh", "rescaled_spring", "none", 2, 0},
                               {"jkr", "total_spring", "none", 1, 0}}) {
    const Meeting inside = meet(choice, 0.0), across = meet(choice, 0.5 * width);
    EXPECT_GT(inside.touched, 20u) << choice.normal;
    EXPECT_EQ(inside.touched, across.touched) << choice.normal;
    for (int k = 0; k < 2; ++k) {
      EXPECT_LT(norm(inside.position[k] - across.position[k]), 1e-9 * 0.4e-3) << choice.normal;
      EXPECT_LT(norm(inside.velocity[k] - across.velocity[k]), 1e-9) << choice.normal;
      EXPECT_LT(norm(inside.spin[k] - across.spin[k]), 1e-6) << choice.normal;
      EXPECT_GT(norm(inside.spin[k] - Vec3{200, -300, 100}), 1.0) << "friction acts";
    }
  }
}

TEST(ShearedBox, GivesWhatASourceGivesTheVelocityOfTheFlow) {
  Model m = sheared_model(jkr);
  SourceModel pack;
  pack.name = "pack";
  pack.density = 2500.0;
  SizeLaw single;
  single.diameter = single.smallest = single.largest = 0.8e-3;
  pack.sizes = SizeSampler(single);
  pack.region.min = m.domain.min;
  pack.region.max = m.domain.max;
  pack.velocity = {0, 0.25, 0};
  pack.target_count = 100;
  m.sources = {pack};
  Simulation s(m, Simulation::initial_state(m), 1);
  s.open_source(0);
  s.step();
  ASSERT_EQ(s.state().parcels.size(), 100u);
  for (const Parcel& p : s.state().parcels.body)
    EXPECT_LT(norm(p.velocity - m.domain.flow_velocity(p.position - m.dt * p.velocity) - pack.velocity),
              1e-12);
}

}  // namespace
