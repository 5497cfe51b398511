// SPDX-License-Identifier: Apache-2.0
#include "output/picture.hpp"

#include <cmath>
#include <stdexcept>

#include "failures.hpp"
#include "output/colour_map.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;

bool alike(const Colour& a, const Colour& b) {
  const float one = 1.5f / 255.0f;
  return std::abs(a.red - b.red) < one && std::abs(a.green - b.green) < one &&
         std::abs(a.blue - b.blue) < one;
}

// Pixels of the scene, left of the colour bar, that `counts` accepts.
template <class Counts>
int pixels(const Image& image, const Counts& counts) {
  int sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += counts(image.at(x, y)) ? 1 : 0;
  return sum;
}

PictureRequest small_request() {
  PictureRequest request;
  request.width = 400;
  request.height = 300;
  return request;
}

PictureRequest bed() {
  auto request = small_request();
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 3; ++k)
        request.spheres.push_back({{2e-5 * i, 2e-5 * j, 2e-5 * k}, 1e-5, static_cast<float>(i) / 4.0f});
  request.cut = CutPlane{{0, 4.3e-5, 0}, {0, -1, 0}};
  request.colour_bar = ColourBar{"radius (µm)", 1.0, 2.0};
  return request;
}

TEST(Picture, ShowsCutSpheresInThePlainColourOfTheirValue) {
  auto request = small_request();
  request.spheres = {{{0, 0, 0}, 1.0, 0.7f}};
  request.cut = CutPlane{{0, 0, 0}, {0, -1, 0}};
  const Image image = draw_picture(request);
  const int disc = pixels(image, [](const Colour& c) { return alike(c, viridis(0.7f)); });
  const int scene = pixels(image, [](const Colour& c) { return c.blue < 0.9f * c.green; });
  // Half a sphere seen 24 degrees aside and 22 above: the face is an ellipse of cos 24 cos 22 times the
  // circle, the outline half a circle and half that ellipse.
  const double face = std::cos(24.0 * M_PI / 180.0) * std::cos(22.0 * M_PI / 180.0);
  EXPECT_NEAR(static_cast<double>(disc) / scene, face / (0.5 + 0.5 * face), 0.05);
}

TEST(Picture, ShowsASphereRoundAndAsLargeAsItsScaleSays) {
  auto request = small_request();
  request.spheres = {{{0, 0, 0}, 1.0, 0.7f}};
  const Image image = draw_picture(request);
  const int ball = pixels(image, [](const Colour& c) { return c.blue < 0.9f * c.green; });
  // The scene is 400 - 2 x 11 pixels wide and 300 - 11 - 44 high; 3 % is left free.
  const double radius = 0.5 * (300 - 11 - 44) / 1.03;
  EXPECT_NEAR(ball, M_PI * radius * radius, 0.02 * M_PI * radius * radius);
}

TEST(Picture, IsTheSameWithAnyNumberOfThreads) {
  auto request = bed();
  request.threads = 1;
  const Image one = draw_picture(request);
  request.threads = 3;
  EXPECT_EQ(one.rgb(), draw_picture(request).rgb());
}

TEST(Picture, LetsTheEyeThroughAWallInFront) {
  auto request = small_request();
  request.spheres = {{{0, 0, 0}, 1.0, 0.9f}};
  const auto yellow = [](const Colour& c) { return c.blue < 0.7f * c.green; };
  const int alone = pixels(draw_picture(request), yellow);
  request.walls.points = {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}};
  request.walls.triangles = {{0, 1, 2}, {0, 2, 3}};
  const int behind = pixels(draw_picture(request), yellow);
  EXPECT_GT(behind, alone / 2);
}

TEST(Picture, IsDrawnWithoutParcelsAndWithoutAnything) {
  auto request = small_request();
  EXPECT_EQ(draw_picture(request).width(), 400);
  request.walls.points = {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}};
  request.walls.triangles = {{0, 1, 2}};
  const Image image = draw_picture(request);
  EXPECT_GT(pixels(image, [](const Colour& c) { return c.red < 0.95f; }), 1000);
}

TEST(Picture, TakesCutsFromEverySide) {
  for (const Vec3 normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 1, 1}}) {
    auto request = bed();
    request.cut = CutPlane{{4.3e-5, 4.3e-5, 2.3e-5}, normal};
    int faces = 0;
    const Image image = draw_picture(request);
    for (int i = 0; i < 5; ++i)
      faces +=
          pixels(image, [&](const Colour& c) { return alike(c, viridis(static_cast<float>(i) / 4.0f)); });
    EXPECT_GT(faces, 500) << normal.x << normal.y << normal.z;  // more than the colour bar holds of them
  }
}

TEST(Picture, IsAPngOfTheSizeAskedFor) {
  ScratchFolder folder;
  write_picture(folder.file("p.png"), bed());
  const auto bytes = content_of(folder.file("p.png"));
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\x01\x90\0\0\x01\x2c", 8));  // 400 and 300, big-endian
  EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
}

TEST(Picture, RefusesSizesThatCannotHoldIt) {
  auto request = small_request();
  request.width = 399;
  EXPECT_THROW(draw_picture(request), std::invalid_argument);
  request.width = 20'000;
  EXPECT_THROW(draw_picture(request), std::invalid_argument);
}

TEST(Picture, FailsClearlyWithoutItsFolder) {
  ScratchFolder folder;
  failure_of(Exit::io, [&] { write_picture(folder.file("missing/p.png"), small_request()); });
}

}  // namespace
}  // namespace pulvis
