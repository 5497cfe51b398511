// SPDX-License-Identifier: Apache-2.0
// Rains out of boxes and cylinders, with and without a sieve: where parcels appear, and how many.
#include <gtest/gtest.h>

#include <set>

#include "engine/base/failure.hpp"
#include "tests/engine/sources.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

/// A rain that falls on and on at the speed it appeared with, without forces.
class Falling {
 public:
  Falling(SourceModel model, double dt, int threads = 1)
      : model_(std::move(model)), dt_(dt), threads_(threads) {
    state_.open = true;
  }

  void step() {
    fresh_ = draw_parcels(model_, state_, 1, 0, step_, dt_, parcels_, cube(10.0, false), nothing_in_the_way,
                          threads_);
    parcels_.body.insert(parcels_.body.end(), fresh_.begin(), fresh_.end());
    for (Parcel& p : parcels_.body) p.position += dt_ * p.velocity;
    ++step_;
  }
  /// Turns the store around, as sorting may do.
  void turn_around() { std::reverse(parcels_.body.begin(), parcels_.body.end()); }

  double time() const { return dt_ * static_cast<double>(step_); }
  std::uint64_t step_number() const { return step_; }
  const SourceState& state() const { return state_; }
  const std::vector<Parcel>& fresh() const { return fresh_; }

 private:
  SourceModel model_;
  double dt_;
  int threads_;
  SourceState state_;
  Parcels parcels_;
  std::vector<Parcel> fresh_;
  std::uint64_t step_ = 0;
};

SourceModel rain_of(SizeKind sizes, const Region& region, const Vec3& velocity, double rate) {
  SourceModel m = source(SourceModel::Kind::rain, sizes, region);
  m.velocity = velocity;
  m.rate = rate;
  m.target_mass = 1.0;
  return m;
}

Region upright_cylinder() {
  Region r = tilted_cylinder();
  r.axis = {0, 0, 1};
  return r;
}

double mass_of_mean(const SourceModel& m) { return m.density * sphere_volume(0.5) * m.sizes->mean_cube(); }
double mass_of_largest(const SourceModel& m) { return m.density * sphere_volume(0.5 * m.sizes->largest()); }

TEST(RainRate, HoldsToWithinAParcelForAnyTimeStepAndAnySizes) {
  // From one parcel in a hundred looks to ten in one look.
  for (const SizeKind kind : {SizeKind::single, SizeKind::lognormal, SizeKind::table})
    for (const double per_look : {0.01, 0.3, 10.0})
      for (const double dt : {3.7e-3, 1e-4, 1.3e-5}) {
        SourceModel m = rain_of(kind, box_region({0, 0, 0}, {0.03, 0.03, 0.01}), {0, 0, -0.5}, 0.0);
        const double look = std::max(dt, m.sizes->largest() / 0.5);
        m.rate = per_look * mass_of_mean(m) / look;
        Falling rain(m, dt);
        const auto steps = static_cast<std::uint64_t>(std::fmax(30.0, 20.0 / per_look) * look / dt);
        for (std::uint64_t k = 0; k < steps; ++k) {
          rain.step();
          if (rain.step_number() % rain_interval(m, dt) != 0) continue;
          ASSERT_NEAR(rain.state().mass, m.rate * rain.time(), 0.5 * mass_of_largest(m) * (1 + 1e-9))
              << "sizes " << static_cast<int>(kind) << ", " << per_look << " a look, step " << dt;
          if (kind == SizeKind::single) {
            ASSERT_NEAR(static_cast<double>(rain.state().count), m.rate * rain.time() / mass_of_mean(m),
                        0.5001);
          }
        }
        EXPECT_GT(rain.state().count, 10u);
      }
}

TEST(RainRate, IsKeptNearTheHighestThatTheRegionGivesAndMadeUpForAfterAStop) {
  // At 25 % solids: the region's cross-section times the speed times a quarter of the density.
  const Region region = box_region({0, 0, 0}, {0.015, 0.015, 0.004});
  SourceModel m = rain_of(SizeKind::single, region, {0, 0, -0.5}, 0.24 * 8000.0 * 0.015 * 0.015 * 0.5);
  Falling rain(m, 1e-4);
  double behind = 0.0;
  for (int k = 0; k < 2000; ++k) {
    rain.step();
    behind = m.rate * rain.time() - rain.state().mass;
  }
  EXPECT_LT(behind, 0.02 * rain.state().mass);
}

TEST(RainRate, IsTheSameParcelsForAnyNumberOfThreadsAndAnyOrderOfTheStore) {
  SourceModel m = rain_of(SizeKind::lognormal, upright_cylinder(), {0, 0, -0.5}, 0.03);
  Falling one(m, 1e-4), many(m, 1e-4, 5);
  for (int k = 0; k < 1000; ++k) {
    one.step();
    many.step();
    ASSERT_EQ(one.fresh().size(), many.fresh().size());
    for (std::size_t i = 0; i < one.fresh().size(); ++i)
      ASSERT_EQ(one.fresh()[i].position, many.fresh()[i].position);
    if (k % 7 == 0) many.turn_around();
  }
  EXPECT_GT(one.state().count, 400u);
}

TEST(CylinderRain, FillsItsCrossSectionEvenlyAndKeepsInside) {
  for (const Region& region : {upright_cylinder(), tilted_cylinder()}) {
    SourceModel m = rain_of(SizeKind::uniform, region, {0, 0, -0.5}, 0.02);
    Falling rain(m, 1e-4);
    std::size_t count = 0, inner = 0;
    for (int k = 0; k < 5000; ++k) {
      rain.step();
      for (const Parcel& p : rain.fresh()) {
        Parcel born = p;
        ASSERT_TRUE(inside(born, region));
        const Vec3 d = p.position - region.base;
        const double across = norm(d - dot(d, region.axis) * region.axis) / (region.radius - p.radius);
        ++count;
        inner += across < std::sqrt(0.5);
      }
    }
    ASSERT_GT(count, 800u);
    EXPECT_NEAR(static_cast<double>(inner) / static_cast<double>(count), 0.5, 0.06);
  }
}

/// Distance from the middle of the nearest opening along one direction, and which opening that is.
std::pair<double, long> from_opening(double x, double pitch) {
  const long opening = std::lround(x / pitch);
  return {std::fabs(x - static_cast<double>(opening) * pitch), opening};
}

TEST(Sieve, LetsWholeSpheresAppearOverItsOpeningsOnly) {
  const Region box = box_region({0.01, 0.02, 0.03}, {0.03, 0.035, 0.04});
  struct Shape {
    Region region;
    Vec3 velocity, middle, across[2];
    std::size_t openings, corners;  ///< corners: those that a sphere seldom fits under
  };
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Vec3 middle{0.02, 0.0275, 0.035};
  const Region tilted = tilted_cylinder();
  const Vec3 u = perpendicular(tilted.axis), v = cross(tilted.axis, u);
  // Openings with their middle, and a bit of room, inside the region; of the outermost a part is enough.
  const Shape shapes[] = {
      {box, {0, 0, -0.5}, middle, {x, y}, 35, 0},
      {box, {0.1, -0.5, 0.2}, middle, {z, x}, 21, 0},
      {box, {0, 0, 0}, middle, {x, y}, 35, 0},
      {tilted, {0, 0, -0.5}, tilted.base + 0.5 * tilted.height * tilted.axis, {u, v}, 21, 4}};
  for (const Shape& shape : shapes) {
    SourceModel m = rain_of(SizeKind::uniform, shape.region, shape.velocity, 0.02);
    m.sieve = Sieve{3e-3, 2.2e-3};
    Falling rain(m, 1e-4);
    std::set<std::pair<long, long>> used;
    for (int k = 0; k < 4000; ++k) {
      rain.step();
      for (const Parcel& p : rain.fresh()) {
        ASSERT_TRUE(inside(p, shape.region));
        const auto [a, i] = from_opening(dot(p.position - shape.middle, shape.across[0]), 3e-3);
        const auto [b, j] = from_opening(dot(p.position - shape.middle, shape.across[1]), 3e-3);
        ASSERT_LE(a + p.radius, 1.1e-3 * (1 + 1e-9));
        ASSERT_LE(b + p.radius, 1.1e-3 * (1 + 1e-9));
        used.insert({i, j});
      }
    }
    EXPECT_GE(used.size(), shape.openings);
    EXPECT_LE(used.size(), shape.openings + shape.corners);
  }
}

TEST(Sieve, OfOneParcelWidthGivesStrandsAndKeepsTheRate) {
  SourceModel m = rain_of(SizeKind::single, box_region({0, 0, 0}, {0.02, 0.02, 0.01}), {0, 0, -0.5}, 0.0);
  m.sieve = Sieve{2e-3, 1e-3};
  m.rate = 0.2 * 0.25 * 8000.0 * 0.02 * 0.02 * 0.5;  // a fifth of the open quarter is full
  Falling rain(m, 1e-4);
  for (int k = 0; k < 1000; ++k) {
    rain.step();
    for (const Parcel& p : rain.fresh()) {
      ASSERT_NEAR(from_opening(p.position.x - 0.01, 2e-3).first, 0.0, 1e-12);
      ASSERT_NEAR(from_opening(p.position.y - 0.01, 2e-3).first, 0.0, 1e-12);
    }
  }
  EXPECT_NEAR(rain.state().mass, m.rate * rain.time(), 0.03 * rain.state().mass);
}

TEST(Sieve, FinerThanTheParcelsIsRefused) {
  SourceModel m = rain_of(SizeKind::uniform, box_region({0, 0, 0}, {0.03, 0.03, 0.01}), {0, 0, -0.5}, 0.01);
  m.sieve = Sieve{3e-3, 1.9e-3};
  SourceState state;
  try {
    draw_parcels(m, state, 1, 0, 0, 1e-4, {}, cube(0.03, false));
    FAIL() << "parcels of 2 mm do not pass openings of 1.9 mm";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_case);
    EXPECT_NE(std::string(failure.what()).find("sieve"), std::string::npos) << failure.what();
  }
}

}  // namespace
