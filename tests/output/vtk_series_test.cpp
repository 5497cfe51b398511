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

TEST(VtkSeries, GoesOnWithTheFramesItHad) {
  ScratchFolder folder;
  std::vector<VtkSeries::Frame> before;
  {
    VtkSeries series(folder.file("a.pvd"));
    for (const double time : {0.0, 0.1, 0.30000000000000004}) series.add(time, "\"<p>\" & more.vtp");
    before = series.frames();
    series.add(0.4, "p.vtp");
  }
  const auto whole = content_of(folder.file("a.pvd"));
  VtkSeries series(folder.file("a.pvd"), before);
  EXPECT_EQ(content_of(folder.file("a.pvd")).find("\"0.4\""), std::string::npos) << "it is no frame any more";
  series.add(0.4, "p.vtp");
  EXPECT_EQ(content_of(folder.file("a.pvd")), whole);
}

}  // namespace
}  // namespace pulvis
