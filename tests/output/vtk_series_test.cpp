// SPDX-License-Identifier: Apache-2.0
#include "output/vtk_series.hpp"

#include "failures.hpp"
#include "scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace test;

TEST(VtkSeries, IsACompleteFileAfterEachFrame) {
  ScratchFolder folder;
  VtkSeries series(folder.file("parcels.pvd"));
  EXPECT_FALSE(folder.has("parcels.pvd"));
  series.add(0.0, "frames/p_0.vtp");
  series.add(0.1, folder.file("frames/p_1 & 2.vtp"));
  EXPECT_EQ(content_of(folder.file("parcels.pvd")),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "<Collection>\n"
            "<DataSet timestep=\"0\" part=\"0\" file=\"frames/p_0.vtp\"/>\n"
            "<DataSet timestep=\"0.1\" part=\"0\" file=\"frames/p_1 &amp; 2.vtp\"/>\n"
            "</Collection>\n</VTKFile>\n");
}

TEST(VtkSeries, GoesOnWithTheFramesBeforeATime) {
  ScratchFolder folder;
  {
    VtkSeries series(folder.file("a.pvd"));
    for (const double time : {0.0, 0.1, 0.30000000000000004, 0.4}) series.add(time, "\"<p>\" & more.vtp");
  }
  auto series = VtkSeries::continued(folder.file("a.pvd"), 0.4);
  ASSERT_EQ(series.frames().size(), 3u);
  EXPECT_EQ(series.frames()[2].time, 0.30000000000000004);
  EXPECT_EQ(series.frames()[2].file, "\"<p>\" & more.vtp");
  const auto before = content_of(folder.file("a.pvd"));
  series.add(0.4, "\"<p>\" & more.vtp");
  EXPECT_EQ(content_of(folder.file("a.pvd")), before);
}

TEST(VtkSeries, StartsEmptyWithoutAFile) {
  ScratchFolder folder;
  EXPECT_TRUE(VtkSeries::continued(folder.file("none.pvd"), 1.0).frames().empty());
}

TEST(VtkSeries, RefusesADamagedFile) {
  ScratchFolder folder;
  VtkSeries(folder.file("a.pvd")).add(0.5, "p.vtp");
  const auto whole = content_of(folder.file("a.pvd"));
  put(folder.file("cut.pvd"), whole.substr(0, whole.size() - 5));
  failure_of(Exit::bad_input, [&] { VtkSeries::continued(folder.file("cut.pvd"), 1.0); });
  auto wrong = whole;
  wrong.replace(wrong.find("0.5"), 3, "0.x");
  put(folder.file("wrong.pvd"), wrong);
  const auto message =
      failure_of(Exit::bad_input, [&] { VtkSeries::continued(folder.file("wrong.pvd"), 1.0); });
  EXPECT_NE(message.find("wrong.pvd:4:"), std::string::npos) << message;
}

}  // namespace
}  // namespace pulvis
