// SPDX-License-Identifier: Apache-2.0
// Beds from text dumps of LIGGGHTS and LAMMPS.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/failure.hpp"
#include "run/bed_file.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

Box metre() { return {{-1, -1, -1}, {1, 1, 1}}; }

// As LIGGGHTS 3.8 writes it with "dump custom id type x y z vx vy vz radius": not in order of the ids, a
// space at the end of each line.
const std::string liggghts = R"(ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS ff ff ff
-0.05 0.05
-0.05 0.05
0 0.15
ITEM: ATOMS id type x y z vx vy vz radius 
9 1 0.5 0.5 0.5 0 0 0 0.001 
ITEM: TIMESTEP
20000
ITEM: NUMBER OF ATOMS
3
ITEM: BOX BOUNDS ff ff ff
-0.05 0.05
-0.05 0.05
0 0.15
ITEM: ATOMS id type x y z vx vy vz radius 
7 1 0.00123456 -0.0201 0.0314159 0.01 -0.02 -0.3 0.0025 
2 1 -1.5e-05 0.04 0.002 0 0 1.25E-3 0.0015 
5 1 0.01 0.02 0.03 -1e-10 0 0 0.002 
)";

TEST(BedFile, ReadsTheLastFrameOfALiggghtsDumpInOrderOfIds) {
  TemporaryFolder folder;
  const auto bed = read_bed(folder.file("bed.dump", liggghts), 2500.0, 3, metre()).parcels;
  ASSERT_EQ(bed.size(), 3u);
  EXPECT_EQ(bed[0].position, (Vec3{-1.5e-05, 0.04, 0.002}));
  EXPECT_EQ(bed[0].velocity, (Vec3{0, 0, 1.25e-3}));
  EXPECT_EQ(bed[0].radius, 0.0015);
  EXPECT_EQ(bed[1].position, (Vec3{0.01, 0.02, 0.03}));
  EXPECT_EQ(bed[1].velocity, (Vec3{-1e-10, 0, 0}));
  EXPECT_EQ(bed[2].position, (Vec3{0.00123456, -0.0201, 0.0314159}));
  EXPECT_EQ(bed[2].velocity, (Vec3{0.01, -0.02, -0.3}));
  EXPECT_EQ(bed[2].radius, 0.0025);
  for (const Parcel& p : bed) {
    EXPECT_EQ(p.species, 3u);
    EXPECT_NEAR(p.mass, 2500.0 * 4.0 / 3.0 * M_PI * std::pow(p.radius, 3), 1e-12 * p.mass);
    EXPECT_EQ(p.spin, Vec3{});
  }
}

TEST(BedFile, ReadsColumnsInAnyOrderDiametersSpinsAndWindowsLines) {
  TemporaryFolder folder;
  const std::string dump =
      "ITEM: TIMESTEP\r\n5\r\nITEM: NUMBER OF ATOMS\r\n1\r\nITEM: BOX BOUNDS pp pp ff\r\n0 1\r\n0 1\r\n0 "
      "1\r\n"
      "ITEM: ATOMS diameter omegaz z y x id omegax mass\r\n0.004 7 0.3 0.2 0.1 1 -2 99\r\n";
  const auto bed = read_bed(folder.file("bed.dump", dump), 1000.0, 0, metre()).parcels;
  ASSERT_EQ(bed.size(), 1u);
  EXPECT_EQ(bed[0].position, (Vec3{0.1, 0.2, 0.3}));
  EXPECT_EQ(bed[0].radius, 0.002);
  EXPECT_EQ(bed[0].spin, (Vec3{-2, 0, 7}));
  EXPECT_EQ(bed[0].velocity, Vec3{});
  EXPECT_NEAR(bed[0].mass, 1000.0 * 4.0 / 3.0 * M_PI * 8e-9, 1e-18)
      << "by the case's density, not the file's";
}

TEST(BedFile, TakesUnitsAndTimeAheadOfAFrame) {
  TemporaryFolder folder;
  const std::string dump = "ITEM: UNITS\nsi\nITEM: TIME\n0.25\n" + liggghts;
  EXPECT_EQ(read_bed(folder.file("bed.dump", dump), 2500.0, 0, metre()).ids,
            (std::vector<std::uint64_t>{2, 5, 7}));
}

TEST(BedFile, BringsParcelsBackAlongPeriodicAxesOnly) {
  TemporaryFolder folder;
  const std::string file = folder.file("bed.dump", with(liggghts, "0.00123456", "1.25"));
  Box box = metre();
  EXPECT_THROW(read_bed(file, 1.0, 0, box), Failure);
  box.periodic[0] = true;
  EXPECT_EQ(read_bed(file, 1.0, 0, box).parcels.at(2).position.x, -0.75);
  EXPECT_THROW(read_bed(folder.file("far.dump", with(liggghts, "0.00123456", "3.25")), 1.0, 0, box), Failure);
}

TEST(BedFile, RefusesSeveralTypesOtherUnitsAndIdsThatAreNotWhole) {
  TemporaryFolder folder;
  for (const auto& [dump, said] : std::vector<std::pair<std::string, std::string>>{
           {with(liggghts, "2 1 -1.5e-05", "2 2 -1.5e-05"), "one powder"},
           {with(liggghts, "2 1 -1.5e-05", "2.5 1 -1.5e-05"), "2.5 is no whole number"},
           {"ITEM: UNITS\ncgs\n" + liggghts, "cgs"}}) {
    try {
      read_bed(folder.file("bed.dump", dump), 1.0, 0, metre());
      ADD_FAILURE() << said;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::bad_input);
      EXPECT_TRUE(has(failure.what(), said)) << failure.what();
    }
  }
}

TEST(BedFile, NeedsPositionAndSize) {
  TemporaryFolder folder;
  for (const std::string missing : {" x", " radius", " id"}) {
    const std::string file =
        folder.file("bed.dump", with(liggghts, "ATOMS id type x y z vx vy vz radius",
                                     with("ATOMS id type x y z vx vy vz radius", missing, " q")));
    try {
      read_bed(file, 1000.0, 0, metre());
      ADD_FAILURE() << "no error without" << missing;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::bad_input);
      EXPECT_TRUE(has(failure.what(), "no column \"" + missing.substr(1) + "\"")) << failure.what();
      EXPECT_TRUE(has(failure.what(), file + ":9")) << failure.what();
    }
  }
}

std::string bed_case(const std::string& path) {
  return die_with("[sources.bed]\nkind = \"file\"\npath = \"" + path +
                  "\"\n\n[[phases]]\nname = \"settle\"\nsources = [\"bed\"]\nuntil = \"time\"\nduration = "
                  "\"0.1 ms\"\n\n");
}

/// Found by fuzzing: rows then have fewer cells than the numbers of the columns say.
TEST(BedFile, RefusesTwoColumnsOfOneName) {
  TemporaryFolder folder;
  const std::string file = folder.file("bed.dump", with(liggghts, "ATOMS id type x y z vx vy vz radius",
                                                        "ATOMS id type x y z vy vy vz radius"));
  try {
    read_bed(file, 1000.0, 0, metre());
    ADD_FAILURE() << "no error";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_input);
    EXPECT_TRUE(has(failure.what(), file + ":9")) << failure.what();
    EXPECT_TRUE(has(failure.what(), "two columns \"vy\"")) << failure.what();
  }
}

TEST(BedFile, GivesTheProgramItsParcels) {
  TemporaryFolder folder;
  folder.file("bed.dump",
              "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
              "ITEM: ATOMS id type x y z vx vy vz radius\n40 1 0.002 0.002 0.002 0.5 0 0 0.00023\n"
              "12 1 0.001 0.001 0.001 0 -0.25 0 0.00026\n");
  const std::string file = folder.file("case.toml", bed_case("bed.dump")), out = folder / "out";
  const Outcome outcome = call({"run", file, "--out", out, "--threads", "1"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const Json r = json_of(out + "/result.json"), frames = open_series(out + "/parcels.pvd");
  EXPECT_EQ(r.at("ledger").at("inserted"), 2);
  const Json& last = frames.back();
  ASSERT_EQ(last.at("points"), 2);
  EXPECT_NEAR(last.at("radius")[0].get<double>(), 0.00026, 1e-9) << "ids in the order of the dump's";
  EXPECT_NEAR(last.at("radius")[1].get<double>(), 0.00023, 1e-9);
  EXPECT_NEAR(last.at("velocity")[1].get<double>(), -0.25, 1e-6);
  EXPECT_NEAR(last.at("velocity")[3].get<double>(), 0.5, 1e-6);
  const double t = r.at("simulated_time_s");
  EXPECT_NEAR(last.at("velocity")[5].get<double>(), -9.81 * t, 1e-8) << "free fall since";
}

TEST(BedFile, ParcelsSmallerThanThePowderShortenTheTimeStep) {
  const auto step_with = [](const char* radius) {
    TemporaryFolder folder;
    folder.file(
        "bed.dump",
        std::string("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n"
                    "0 1\nITEM: ATOMS id x y z radius\n1 0.002 0.002 0.002 ") +
            radius + "\n");
    const std::string file = folder.file("case.toml", bed_case("bed.dump")), out = folder / "out";
    const Outcome outcome = call({"run", file, "--out", out, "--threads", "1"});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return json_of(out + "/result.json").at("time_step_s").get<double>();
  };
  EXPECT_LT(step_with("2.5e-5"), 0.5 * step_with("2.5e-4"));
}

}  // namespace
