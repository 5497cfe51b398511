// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "meshes/mending.hpp"
#include "meshes/mesh_words.hpp"
#include "meshes/stl_file.hpp"
#include "shapes.hpp"
#include "tests/output/scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;

const std::string example = std::string(PULVIS_CASES) + "/die-filling/stepped-die.stl";

/// The die of two levels as a solid in mm, walls and floor 1 mm thick: cavity 8 x 6 mm, 8 mm deep for x < 4
/// and 5 mm beyond. Faces look out of the solid, those of the cavity into it.
TriangleSoup stepped_die() {
  TriangleSoup die{"stepped-die.stl", {}};
  add_quad(die, {-1, -1, -1}, {-1, 7, -1}, {9, 7, -1}, {9, -1, -1});  // bottom
  add_quad(die, {-1, -1, -1}, {9, -1, -1}, {9, -1, 8}, {-1, -1, 8});  // outer sides
  add_quad(die, {9, -1, -1}, {9, 7, -1}, {9, 7, 8}, {9, -1, 8});
  add_quad(die, {9, 7, -1}, {-1, 7, -1}, {-1, 7, 8}, {9, 7, 8});
  add_quad(die, {-1, 7, -1}, {-1, -1, -1}, {-1, -1, 8}, {-1, 7, 8});
  add_quad(die, {-1, -1, 8}, {9, -1, 8}, {8, 0, 8}, {0, 0, 8});  // rim
  add_quad(die, {9, -1, 8}, {9, 7, 8}, {8, 6, 8}, {8, 0, 8});
  add_quad(die, {9, 7, 8}, {-1, 7, 8}, {0, 6, 8}, {8, 6, 8});
  add_quad(die, {-1, 7, 8}, {-1, -1, 8}, {0, 0, 8}, {0, 6, 8});
  add_quad(die, {0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0});  // lower floor, riser, upper floor
  add_quad(die, {4, 0, 0}, {4, 0, 3}, {4, 6, 3}, {4, 6, 0});
  add_quad(die, {4, 0, 3}, {8, 0, 3}, {8, 6, 3}, {4, 6, 3});
  add_quad(die, {0, 0, 0}, {0, 6, 0}, {0, 6, 8}, {0, 0, 8});  // the ends of the cavity
  add_quad(die, {8, 0, 3}, {8, 0, 8}, {8, 6, 8}, {8, 6, 3});
  // The sides of the cavity have six corners each; fans from the corner of the step cut them up.
  add_quad(die, {4, 0, 3}, {0, 0, 8}, {8, 0, 8}, {8, 0, 3});
  add_quad(die, {4, 0, 3}, {4, 0, 0}, {0, 0, 0}, {0, 0, 8});
  add_quad(die, {4, 6, 3}, {8, 6, 3}, {8, 6, 8}, {0, 6, 8});
  add_quad(die, {4, 6, 3}, {0, 6, 8}, {0, 6, 0}, {4, 6, 0});
  return die;
}

// With PULVIS_WRITE_DOCUMENTS set, the file is written instead of compared.
TEST(SteppedDie, TheExampleIsWhatItsGeneratorWrites) {
  const std::string name = "stepped die, millimetres (SPDX-License-Identifier: Apache-2.0)";
  if (std::getenv("PULVIS_WRITE_DOCUMENTS")) write_stl(example, stepped_die(), StlForm::text, name);
  ScratchFolder folder;
  write_stl(folder.file("die.stl"), stepped_die(), StlForm::text, name);
  EXPECT_EQ(content_of(example), content_of(folder.file("die.stl")))
      << "renew it: PULVIS_WRITE_DOCUMENTS=1 mesh_tests --gtest_filter='SteppedDie.*'";
}

TEST(SteppedDie, NeedsNoMending) {
  const auto die = mend(read_stl(example), 1e-3);
  const double expected = (10.0 * 8 * 9 - 8 * 6 * 8 + 4 * 6 * 3) * 1e-9;
  EXPECT_EQ(die.report.triangles, 36u);
  EXPECT_EQ(die.report.triangles, die.report.triangles_read);
  EXPECT_TRUE(die.report.watertight);
  EXPECT_EQ(die.report.shells, 1u);
  EXPECT_NEAR(die.report.volume.value_or(0), expected, 1e-12 * expected);
  EXPECT_TRUE(warnings_of(die.report, "die").empty());
  EXPECT_EQ(describe(die.report, "die").find("mended"), std::string::npos);
}

TEST(SteppedDie, MeetsAtRightAnglesOrFlat) {
  const auto die = mend(read_stl(example), 1e-3).mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> seen;
  int sharp = 0;
  for (std::size_t t = 0; t < die.triangles.size(); ++t) {
    const Vec3 direction = cross(die.corner(t, 1) - die.corner(t, 0), die.corner(t, 2) - die.corner(t, 0));
    const Vec3 normal = direction / norm(direction);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({die.triangles[t][k], die.triangles[t][(k + 1) % 3]});
      const auto [at, first] = seen.insert({{low, high}, normal});
      if (first) continue;
      const double cosine = dot(at->second, normal);
      EXPECT_TRUE(cosine == 0.0 || cosine == 1.0) << cosine;
      sharp += cosine == 0.0;
    }
  }
  EXPECT_EQ(sharp, 30);
}

}  // namespace
}  // namespace pulvis
