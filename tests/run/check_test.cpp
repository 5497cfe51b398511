// SPDX-License-Identifier: Apache-2.0
// The numbers that `pulvis check` derives, against formulas written down here once more.
#include <gtest/gtest.h>

#include <cmath>

#include "case/reader.hpp"
#include "case/units.hpp"
#include "run/preflight.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

struct Checked {
  Case c;
  Assembly assembly;
  Forecast forecast;
  std::string report;
};

Checked checked(const std::string& text, const std::vector<Override>& overrides = {}) {
  Checked k;
  k.c = read_case_text(text, "case.toml", overrides);
  k.assembly = assemble(k.c);
  k.forecast = forecast(k.c, k.assembly);
  k.report = check_report(k.c, k.assembly, k.forecast);
  return k;
}

void expect_close(double value, double expected, double relative, const char* what) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected)) << what;
}

// The small die in SI.
constexpr double alpha = 10.0, gamma_glass = 1e-4, gamma_steel = 4e-4, rho = 2500.0, g = 9.81;
constexpr double e_glass = 70e9, e_soft = 2e6, nu_glass = 0.25, e_steel = 210e9, nu_steel = 0.3;
const double d50 = std::pow(0.5 * (std::pow(45e-6, 4) + std::pow(55e-6, 4)), 0.25);  // uniform by number
const double work_glass = 2.0 * gamma_glass, work_wall = 2.0 * std::sqrt(gamma_glass * gamma_steel);

double mass_of(double d) { return rho * M_PI / 6.0 * d * d * d; }
double modulus(double e1, double nu1, double e2, double nu2) {
  return 1.0 / ((1 - nu1 * nu1) / e1 + (1 - nu2 * nu2) / e2);
}
double pull_off(double work, double radius) { return 1.5 * M_PI * work * radius; }
double sticking_speed(double work, double radius, double e, double mass) {
  return std::sqrt(2.0 * 7.0922 * std::cbrt(std::pow(work, 5) * std::pow(radius, 4) / (e * e)) / mass);
}
double stretch(double work, double radius, double e) {
  return 0.75 * std::cbrt(M_PI * M_PI * work * work * radius / (e * e));
}

/// Overlap of a JKR contact under a force, found by bisection of the contact radius a in
/// F = 4 E a^3/(3 R) - sqrt(8 pi W E a^3), delta = a^2/R - sqrt(2 pi W a/E).
double jkr_overlap(double force, double radius, double e, double work) {
  const auto load = [&](double a) {
    return 4.0 * e * a * a * a / (3.0 * radius) - std::sqrt(8.0 * M_PI * work * e * a * a * a);
  };
  double low = std::cbrt(9.0 * M_PI * work * radius * radius / (8.0 * e)), high = radius;  // from pull-off on
  for (int k = 0; k < 200; ++k) (load(0.5 * (low + high)) < force ? low : high) = 0.5 * (low + high);
  return low * low / radius - std::sqrt(2.0 * M_PI * work * low / e);
}

TEST(Check, ForecastsEveryPairWithTheWallsAmongThem) {
  const Checked k = checked(small_die);
  ASSERT_EQ(k.forecast.pairs.size(), 2u);
  EXPECT_EQ(k.forecast.pairs[0].first, "beads");
  EXPECT_EQ(k.forecast.pairs[0].second, "beads");
  EXPECT_EQ(k.forecast.pairs[1].first, "beads");
  EXPECT_TRUE(has(k.forecast.pairs[1].second, "steel"));
}

TEST(Check, PullOffAndBondFollowTheFormulas) {
  const Checked k = checked(small_die);
  const PairForecast &own = k.forecast.pairs[0], &wall = k.forecast.pairs[1];
  // Two d50 grains: R* = d/4. A grain on a wall: R* = d/2.
  expect_close(own.pull_off_real, pull_off(work_glass, d50 / 4), 1e-6, "grain on grain");
  expect_close(wall.pull_off_real, pull_off(work_wall, d50 / 2), 1e-6, "grain on wall");
  // Parcels: sizes times alpha, W times alpha, so that forces grow with its square (stress similarity).
  expect_close(own.pull_off, alpha * alpha * own.pull_off_real, 1e-6, "parcel on parcel");
  expect_close(wall.pull_off, alpha * alpha * wall.pull_off_real, 1e-6, "parcel on wall");
  expect_close(own.bond_real, pull_off(work_glass, d50 / 4) / (mass_of(d50) * g), 1e-6,
               "Bond number of grains");
  expect_close(wall.bond_real, pull_off(work_wall, d50 / 2) / (mass_of(d50) * g), 1e-6, "on the wall");
  expect_close(own.bond, own.bond_real / alpha, 1e-6, "weight grows with alpha^3");
  expect_close(wall.bond, wall.bond_real / alpha, 1e-6, "on the wall");
}

TEST(Check, SofteningThatKeepsThePullOffKeepsW) {
  const Checked k = checked(small_die, {{"powders.beads.coarse_graining", "1"},
                                        {"walls.die.max", R"(["0.3 mm", "0.3 mm", "0.4 mm"])"}});
  const PairForecast& own = k.forecast.pairs[0];
  expect_close(own.pull_off, own.pull_off_real, 1e-12, "pull-off");
  const double m = mass_of(d50) / 2, r = d50 / 4;
  expect_close(own.sticking_speed_real,
               sticking_speed(work_glass, r, modulus(e_glass, nu_glass, e_glass, nu_glass), m), 1e-4,
               "real sticking speed");
  expect_close(own.sticking_speed,
               sticking_speed(work_glass, r, modulus(e_soft, nu_glass, e_soft, nu_glass), m), 1e-4,
               "softened sticking speed");
  EXPECT_GT(own.sticking_speed, 10.0 * own.sticking_speed_real) << "the price of softening this way";
}

TEST(Check, SofteningThatKeepsTheStickingSpeedLowersW) {
  const std::vector<Override> settings = {{"powders.beads.keep", "\"sticking_speed\""},
                                          {"powders.beads.coarse_graining", "1"},
                                          {"walls.die.max", R"(["0.3 mm", "0.3 mm", "0.4 mm"])"}};
  const Checked k = checked(small_die, settings);
  const PairForecast &own = k.forecast.pairs[0], &wall = k.forecast.pairs[1];
  expect_close(own.sticking_speed, own.sticking_speed_real, 1e-9, "sticking speed on grains");
  expect_close(wall.sticking_speed, wall.sticking_speed_real, 1e-9, "sticking speed on walls");
  // W (E_sim/E)^(2/5) with the moduli of the pair.
  expect_close(own.pull_off, own.pull_off_real * std::pow(e_soft / e_glass, 0.4), 1e-9, "pull-off on grains");
  const double real = modulus(e_glass, nu_glass, e_steel, nu_steel),
               soft = modulus(e_soft, nu_glass, e_steel, nu_steel);
  expect_close(wall.pull_off, wall.pull_off_real * std::pow(soft / real, 0.4), 1e-9, "pull-off on walls");
  expect_close(k.assembly.pairs[0].simulated.work_of_adhesion, work_glass * std::pow(e_soft / e_glass, 0.4),
               1e-9, "W");
  expect_close(k.assembly.pairs[0].real.work_of_adhesion, work_glass, 1e-12, "real W");
}

TEST(Check, KeepIsThatOfTheSoftenedPowderInEitherOrder) {
  const std::string stiff =
      "[powders.stiff]\nmaterial = \"glass\"\nsize = { kind = \"single\", diameter = \"50 um\" }\n"
      "coarse_graining = 10\n\n";
  std::string text = with(small_die, "kind = \"rain\"", "kind = \"rain\"\npowder = \"beads\"");
  text = with(text, "keep = \"pull_off\"", "keep = \"sticking_speed\"");
  const double between = modulus(e_soft, nu_glass, e_glass, nu_glass),
               real = modulus(e_glass, nu_glass, e_glass, nu_glass);
  for (const char* before : {"[powders.beads]", "[contact]"}) {
    const Checked k = checked(with(text, before, stiff + before));
    expect_close(k.assembly.pairs[1].simulated.work_of_adhesion,
                 alpha * work_glass * std::pow(between / real, 0.4), 1e-9, before);
  }
  const std::string soft = with(stiff, "\n\n", "\nsimulated_modulus = \"3 MPa\"\nkeep = \"pull_off\"\n\n");
  for (const char* before : {"[powders.beads]", "[contact]"}) try {
      checked(with(text, before, soft + before));
      ADD_FAILURE() << "they keep different things";
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::bad_case);
      EXPECT_TRUE(has(failure.what(), "differ in what they keep")) << failure.what();
    }
}

TEST(Check, WarnsOfMoreMemoryThanThereIs) {
  const auto warned = [](const Checked& k) {
    return std::any_of(k.forecast.warnings.begin(), k.forecast.warnings.end(),
                       [](const std::string& w) { return has(w, "this machine has"); });
  };
  EXPECT_FALSE(warned(checked(small_die)));
  EXPECT_TRUE(warned(checked(with(small_die, "mass = \"24 mg\"", "count = 2147483647"))));
}

TEST(Check, WarnsOfARainThatCannotKeepItsRateAndSaysWhatItCan) {
  // Parcels leave the region of 2.8 mm x 2.8 mm x 1.8 mm within 7.6 ms, a quarter full.
  const double speed = 0.2, height = 1.8e-3,
               time = 2 * height / (speed + std::sqrt(speed * speed + 2 * g * height));
  const double open = 0.25 * rho * 2.8e-3 * 2.8e-3 * height / time;
  const auto warned = [](const std::string& rate, const std::string& sieve = "") {
    const std::string text =
        with(small_die, "mass_rate = \"600 mg/s\"", "mass_rate = \"" + rate + "\"\n" + sieve);
    bool found = false;
    for (const std::string& w : checked(text).forecast.warnings)
      found = found || (has(w, "sources.rain") && has(w, "mass_rate"));
    return found;
  };
  const auto share = [&](double factor) {
    return fmt::format("{} kg/s", factor * open / (1 + 0.25 * std::log(55.0 / 45.0)));
  };
  EXPECT_FALSE(warned("600 mg/s"));
  EXPECT_FALSE(warned(share(0.99)));
  EXPECT_TRUE(warned(share(1.01)));
  // Of the face, 36 % are open, and openings are filled less well.
  const std::string sieve = "sieve_pitch = \"1 mm\"\nsieve_opening = \"0.6 mm\"\n";
  EXPECT_FALSE(warned(share(0.99 * 0.36 * 0.17 / 0.25), sieve));
  EXPECT_TRUE(warned(share(1.01 * 0.36 * 0.17 / 0.25), sieve));
}

TEST(Check, CoarseGrainingScalesWByAlphaAfterSoftening) {
  for (const char* keep : {"\"pull_off\"", "\"sticking_speed\""}) {
    const Checked k = checked(small_die, {{"powders.beads.keep", keep}});
    const double softened = std::string(keep) == "\"pull_off\"" ? 1.0 : std::pow(e_soft / e_glass, 0.4);
    expect_close(k.assembly.pairs[0].simulated.work_of_adhesion, alpha * work_glass * softened, 1e-9, keep);
    EXPECT_EQ(k.assembly.pairs[0].simulated.friction, 0.4);
    EXPECT_EQ(k.assembly.pairs[0].simulated.restitution, 0.4);
  }
}

TEST(Check, PairThatGivesItsOwnWorkOfAdhesionHasIt) {
  const std::string pair =
      "[[pairs]]\nmaterials = [\"steel\", \"glass\"]\nwork_of_adhesion = \"3 mJ/m^2\"\n\n[contact]";
  const Checked k = checked(with(small_die, "[contact]", pair));
  expect_close(k.forecast.pairs[1].pull_off_real, pull_off(3e-3, d50 / 2), 1e-6, "its own W");
  expect_close(k.forecast.pairs[0].pull_off_real, pull_off(work_glass, d50 / 4), 1e-6, "the other pair");
}

TEST(Check, OverlapAtRestIsThatOfJkrUnderTheBed) {
  const Checked k = checked(small_die);
  const double pressure = 24e-6 * g / (3e-3 * 3e-3);  // weight of the bed on the floor of the die
  expect_close(k.forecast.bed_stress, pressure, 1e-9, "pressure");
  const double d = alpha * d50, force = std::max(pressure * d * d, mass_of(d) * g);
  expect_close(
      k.forecast.pairs[0].resting_overlap,
      jkr_overlap(force, d / 4, modulus(e_soft, nu_glass, e_soft, nu_glass), alpha * work_glass) / (d / 2),
      1e-4, "parcel on parcel");
  expect_close(
      k.forecast.pairs[1].resting_overlap,
      jkr_overlap(force, d / 2, modulus(e_soft, nu_glass, e_steel, nu_steel), alpha * work_wall) / (d / 2),
      1e-4, "parcel on wall");
}

TEST(Check, ParcelsAndMemoryAreForecast) {
  const Checked k = checked(small_die);
  const double mean_cube = (std::pow(55e-6, 4) - std::pow(45e-6, 4)) / (4.0 * 10e-6);  // of a uniform law
  EXPECT_EQ(k.forecast.parcels, std::round(24e-6 / (rho * M_PI / 6.0 * 1e3 * mean_cube)));
  EXPECT_GT(k.forecast.memory, 300.0 * k.forecast.parcels);
  const Checked million = checked(thrown(R"(["0 m/s", "0 m/s", "0 m/s"])"),
                                  {{"sources.pack.count", "1000000"},
                                   {"domain.max", R"(["1 m", "1 m", "1 m"])"},
                                   {"sources.pack.region.min", R"(["0 m", "0 m", "5 mm"])"},
                                   {"sources.pack.region.max", R"(["1 m", "1 m", "1 m"])"}});
  EXPECT_EQ(million.forecast.parcels, 1e6);
  EXPECT_LT(million.forecast.memory, 1024.0 * 1024.0 * 1024.0);
}

TEST(Check, TimeStepIsTheFractionOfTheSmallestLimit) {
  const Checked k = checked(small_die, {{"time.fraction", "0.25"}});
  const double d = alpha * 45e-6, m = mass_of(d);  // the smallest parcel
  const double e = modulus(e_soft, nu_glass, e_steel, nu_steel), work = alpha * work_wall;
  const double speed_limit = stretch(work, d / 2, e) / (10.0 * sticking_speed(work, d / 2, e, m));
  const double shear = e_soft / (2.0 * (1.0 + nu_glass));
  const double rayleigh = M_PI * d / 2 * std::sqrt(rho / shear) / (0.1631 * nu_glass + 0.8766);
  const StepLimit& binding = k.assembly.time_step.limits.front();
  EXPECT_EQ(binding.kind, "cohesive speed");
  EXPECT_TRUE(has(binding.of, "steel"));
  expect_close(binding.time, speed_limit, 1e-4, "the binding limit");
  expect_close(k.assembly.time_step.step, 0.25 * speed_limit, 1e-4, "the step");
  bool found = false;
  for (const StepLimit& l : k.assembly.time_step.limits) {
    if (l.kind != "rayleigh") continue;
    expect_close(l.time, rayleigh, 1e-9, "Rayleigh");
    found = true;
  }
  EXPECT_TRUE(found);
  EXPECT_TRUE(has(k.report, "time step " + format_quantity(0.25 * binding.time, dimension::time) +
                                ": 0.25 of the smallest limit, cohesive speed of beads / wall of steel"))
      << k.report;
}

TEST(Check, StiffPowderWithoutAdhesionIsBoundByRayleighOrHertz) {
  const Checked k = checked(
      small_die, {{"contact.normal", "\"hertz\""}, {"materials.glass.surface_energy", "\"0 J/m^2\""}});
  for (const StepLimit& l : k.assembly.time_step.limits) EXPECT_FALSE(has(l.kind, "cohesive")) << l.kind;
  EXPECT_EQ(k.assembly.time_step.limits.front().kind, "rayleigh");
}

TEST(Check, WarnsAboveOnePerCentOfOverlapOnly) {
  const auto warned = [](const Checked& k) {
    return std::any_of(k.forecast.warnings.begin(), k.forecast.warnings.end(), [](const std::string& w) {
      return has(w, "overlap at rest") && has(w, "simulated_modulus");
    });
  };
  const Checked stiff = checked(small_die),
                soft = checked(small_die, {{"powders.beads.simulated_modulus", "\"0.2 MPa\""}});
  EXPECT_LT(stiff.forecast.pairs[0].resting_overlap, 0.01);
  EXPECT_FALSE(warned(stiff));
  EXPECT_GT(soft.forecast.pairs[0].resting_overlap, 0.01);
  EXPECT_TRUE(warned(soft));
}

TEST(Check, WarnsOfSurfaceEnergyThatTheLawDoesNotKnow) {
  const Checked k = checked(small_die, {{"contact.normal", "\"hertz\""}});
  bool warned = false;
  for (const std::string& w : k.forecast.warnings)
    warned = warned || (has(w, "surface energy") && has(w, "hertz"));
  EXPECT_TRUE(warned);
  for (const PairForecast& p : k.forecast.pairs) EXPECT_EQ(p.pull_off, 0.0);
}

TEST(Check, WarnsOfAPairThatDoesNotAdhereAmongThoseThatDo) {
  const Checked k = checked(small_die, {{"materials.steel.surface_energy", "\"0 J/m^2\""}});
  bool warned = false;
  for (const std::string& w : k.forecast.warnings) warned = warned || has(w, "does not adhere");
  EXPECT_TRUE(warned);
}

bool warns(const Checked& k, const std::vector<std::string>& parts) {
  return std::any_of(k.forecast.warnings.begin(), k.forecast.warnings.end(), [&](const std::string& w) {
    return std::all_of(parts.begin(), parts.end(), [&](const std::string& part) { return has(w, part); });
  });
}

TEST(Check, SaysNothingOfAPairWhoseCohesionTheCaseStates) {
  const std::vector<Override> clean_wall = {{"materials.steel.surface_energy", "\"0 J/m^2\""}};
  EXPECT_TRUE(warns(checked(small_die, clean_wall), {"beads / wall of steel does not adhere", "[[pairs]]"}));
  const std::string stated =
      with(small_die, "[contact]",
           "[[pairs]]\nmaterials = [\"glass\", \"steel\"]\nwork_of_adhesion = \"0 J/m^2\"\n\n[contact]");
  EXPECT_FALSE(warns(checked(stated, clean_wall), {"does not adhere"}));
}

TEST(Check, KnowsThePullOffOfEveryLaw) {
  const std::vector<Override> dmt = {{"contact.normal", "\"hertz\""}, {"contact.cohesion", "\"dmt\""}};
  const Checked k = checked(small_die, dmt);
  expect_close(k.forecast.pairs[0].pull_off_real, 2.0 * M_PI * work_glass * d50 / 4, 1e-9, "grains");
  expect_close(k.forecast.pairs[1].pull_off, 100.0 * 2.0 * M_PI * work_wall * d50 / 2, 1e-9,
               "parcel at wall");
  expect_close(k.forecast.pairs[1].bond_real, 2.0 * M_PI * work_wall * d50 / 2 / (mass_of(d50) * g), 1e-9,
               "Bond");
  for (const std::string& w : k.forecast.warnings) EXPECT_FALSE(has(w, "surface energy")) << w;
}

TEST(Check, WarnsOfCohesionTooStrongForTheStiffness) {
  // Overlap without force: (1.5 pi k_c/E*)^2 R*.
  const double soft = modulus(e_soft, nu_glass, e_soft, nu_glass);
  const auto die = [&](double share) {  // of the radius, at beads / beads
    const double density = soft / (1.5 * M_PI) * std::sqrt(2.0 * share);
    return checked(small_die, {{"contact.normal", "\"hertz\""},
                               {"contact.cohesion", "\"sjkr2_reduced_radius\""},
                               {"contact.cohesion_energy_density", fmt::format("\"{} Pa\"", density)}});
  };
  expect_close(die(0.009).forecast.pairs[0].own_overlap, 0.009, 1e-6, "own overlap");
  EXPECT_FALSE(warns(die(0.009), {"beads / beads", "too strong for the stiffness"}));
  EXPECT_TRUE(warns(die(0.011), {"beads / beads: cohesion is too strong for the stiffness", "1.10 %"}));
}

TEST(Check, WarnsOfContactsThatCollapse) {
  // Hooke with the same stiffness k at all sizes holds if 2 pi k_c R* < k, for parcels 10 k and 10 R*.
  const auto die = [&](double share) {
    const double density = share * 1.0 / (2.0 * M_PI * d50 / 2);
    return checked(small_die, {{"contact.normal", "\"hooke\""},
                               {"contact.normal_stiffness", "\"1 N/m\""},
                               {"contact.cohesion", "\"sjkr2_reduced_radius\""},
                               {"contact.cohesion_energy_density", fmt::format("\"{} Pa\"", density)}});
  };
  EXPECT_FALSE(warns(die(0.99), {"cohesion exceeds stiffness"}));
  const Checked above = die(1.01);
  EXPECT_TRUE(warns(above, {"beads / wall of steel: cohesion exceeds stiffness"}));
  EXPECT_FALSE(warns(above, {"beads / beads: cohesion exceeds stiffness"})) << "R* is half of it";
}

TEST(Check, WarnsOfARestitutionThatCohesionTakesAway) {
  const auto die = [](const char* energy, const char* restitution) {
    return checked(small_die, {{"materials.glass.surface_energy", energy},
                               {"materials.glass.restitution", restitution},
                               {"time.characteristic_speed", "\"0.05 m/s\""}});
  };
  const Checked weak = die("\"1e-6 J/m^2\"", "0.9");
  EXPECT_FALSE(warns(weak, {"beads / beads: restitution"}));
  EXPECT_NEAR(weak.forecast.pairs[0].restitution_shown, 0.9, 0.01);
  const Checked strong = die("\"5e-3 J/m^2\"", "0.99");
  EXPECT_TRUE(warns(strong, {"beads / beads: restitution 0.99 is asked for", "0.05 m/s", "unreachable"}));
  const PairForecast& p = strong.forecast.pairs[0];
  EXPECT_LT(p.restitution_shown, 0.9 * 0.99);
  EXPECT_LT(p.undamped_restitution, 0.99);
  // The elastic JKR collision: e^2 = 1 - (v_s/v)^2.
  expect_close(p.undamped_restitution, std::sqrt(1.0 - std::pow(p.sticking_speed / 0.05, 2)), 1e-3,
               "elastic");
  EXPECT_TRUE(warns(die("\"0.5 J/m^2\"", "0.99"), {"beads / beads: restitution", "show 0", "they stick"}));
  const Checked damped = die("\"5e-3 J/m^2\"", "0.3");
  EXPECT_TRUE(warns(damped, {"beads / beads: restitution 0.3 is asked for", "ask for more"}));
}

TEST(Check, WarnsOfStepsTooCoarseToShowTheRestitution) {
  const auto warned = [](const std::string& fraction) {
    const std::vector<Override> keys = {{"contact.normal", "\"hooke\""},
                                        {"contact.normal_stiffness", "\"1000 N/m\""},
                                        {"time.fraction", fraction}};
    for (const std::string& warning : checked(small_die, keys).forecast.warnings)
      if (has(warning, "at this time step collisions at") && has(warning, "lower time.fraction")) return true;
    return false;
  };
  EXPECT_TRUE(warned("1"));
  EXPECT_FALSE(warned("0.05"));
}

TEST(Check, ReportPrintsBothPowdersSideBySide) {
  const Checked k = checked(small_die);
  for (const PairForecast& p : k.forecast.pairs)
    for (const std::string& number :
         {format_quantity(p.pull_off_real, dimension::force), format_quantity(p.pull_off, dimension::force),
          fmt::format("{:.4g}", p.bond_real), fmt::format("{:.4g}", p.bond),
          format_quantity(p.sticking_speed_real, dimension::speed),
          format_quantity(p.sticking_speed, dimension::speed),
          fmt::format("{:.3f}%", 100 * p.resting_overlap),
          fmt::format("{:.3g} / {:.3g}", p.restitution, p.restitution_shown)})
      EXPECT_TRUE(has(k.report, number)) << number << " is not in\n" << k.report;
  for (const char* part : {"beads / beads", "beads / wall of steel", "pull-off", "Bond", "parcels 145",
                           "memory", "70 GPa", "2 MPa", "keeping the pull-off force", "15 m/s^2"})
    EXPECT_TRUE(has(k.report, part)) << part;
}

TEST(Check, ProgramPrintsTheReportAndWarningsAndWritesNothing) {
  TemporaryFolder folder;
  folder.file("case.toml", with(small_die, "\"2 MPa\"", "\"0.2 MPa\""));
  const Outcome outcome = call({"check", "case.toml"}, {.folder = folder.path().string()});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  const Checked k = checked(small_die, {{"powders.beads.simulated_modulus", "\"0.2 MPa\""}});
  EXPECT_EQ(outcome.out, k.report);
  EXPECT_TRUE(has(outcome.err, "warning: beads / beads: expected overlap at rest is ")) << outcome.err;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) files += entry.exists();
  EXPECT_EQ(files, 1u) << "only the case itself";
}

}  // namespace
