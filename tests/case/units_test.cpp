// SPDX-License-Identifier: Apache-2.0
#include "case/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace pulvis {
namespace {

double value_of(const std::string& text, const Dimension& due) {
  const QuantityReading reading = read_quantity(text);
  EXPECT_TRUE(reading.quantity) << text << ": " << reading.message;
  if (!reading.quantity) return std::nan("");
  EXPECT_EQ(reading.quantity->dimension, due) << text;
  return reading.quantity->value;
}

TEST(Units, ReadsWhatEngineersWrite) {
  EXPECT_EQ(value_of("4.6 um", dimension::length), 4.6e-6);  // exactly: prefixes shift the decimal point
  EXPECT_EQ(value_of("25 mJ/m^2", dimension::surface_energy), 25e-3);
  EXPECT_EQ(value_of("5 Hz", dimension::frequency), 5.0);
  EXPECT_EQ(value_of("10.2 g/cm^3", dimension::density), 10200.0);
  EXPECT_EQ(value_of("10.2 g/cm3", dimension::density), 10200.0);
  EXPECT_EQ(value_of("317 GPa", dimension::pressure), 317e9);
  EXPECT_EQ(value_of("0.2 m/s", dimension::speed), 0.2);
  EXPECT_EQ(value_of("-9.81 m/s^2", dimension::acceleration), -9.81);
  EXPECT_EQ(value_of("2 g/s", dimension::mass_rate), 2e-3);
  EXPECT_EQ(value_of("30 N/m", dimension::surface_energy), 30.0);
  EXPECT_EQ(value_of("1 min", dimension::time), 60.0);
  EXPECT_EQ(value_of("30 %", dimension::none), 0.3);
  EXPECT_EQ(value_of("0.31", dimension::none), 0.31);
  EXPECT_EQ(value_of("600 rpm", dimension::frequency), 10.0);
}

TEST(Units, CountsAnglesInTurns) {
  EXPECT_EQ(value_of("90 deg", dimension::angle), 0.25);
  EXPECT_EQ(value_of("90°", dimension::angle), 0.25);
  EXPECT_DOUBLE_EQ(value_of("3.141592653589793 rad", dimension::angle), 0.5);
  EXPECT_EQ(value_of("0.25 cycles", dimension::angle), 0.25);
}

TEST(Units, ReadsTypographicSpellings) {
  EXPECT_EQ(value_of("4.6 µm", dimension::length), 4.6e-6);  // micro sign
  EXPECT_EQ(value_of("4.6 μm", dimension::length), 4.6e-6);  // Greek mu
  EXPECT_EQ(value_of("9.81 m/s²", dimension::acceleration), 9.81);
  EXPECT_EQ(value_of("1 g/cm³", dimension::density), 1000.0);
}

TEST(Units, ReadsProductsQuotientsAndPowers) {
  EXPECT_EQ(value_of("1 kg m s^-2", dimension::force), 1.0);
  EXPECT_EQ(value_of("1 kg*m/s/s", dimension::force), 1.0);
  EXPECT_EQ(value_of("1 kg.m.s-2", dimension::force), 1.0);
  EXPECT_EQ(value_of("1 kg/(m s^2)", dimension::pressure), 1.0);
  EXPECT_EQ(value_of("3 1/s", dimension::frequency), 3.0);
  EXPECT_EQ(value_of("2 mm^3", dimension::volume), 2e-9);
  EXPECT_EQ(value_of("1 (m/s)^2", Dimension({0, 2, -2})), 1.0);
  EXPECT_EQ(value_of("1e3mm", dimension::length), 1.0);
  EXPECT_EQ(value_of(".5 mm", dimension::length), 0.5e-3);
}

TEST(Units, SaysWhatIsWrong) {
  const auto message = [](const std::string& text) { return read_quantity(text).message; };
  EXPECT_EQ(message("70 GP"), "unknown unit \"GP\"");
  EXPECT_EQ(message("4,6 um"), "a decimal point is due, not a comma");
  EXPECT_EQ(message("um"), "\"um\" does not start with a number");
  EXPECT_EQ(message("1 J/m s"), "a product after \"/\" can be read in two ways; use parentheses");
  EXPECT_EQ(message("1 m^12"), "a power is a whole number from -9 to 9, not 0");
  EXPECT_EQ(message("1 m/"), "a unit is missing at the end");
  EXPECT_EQ(message("1 (m"), "a parenthesis is not closed");
  EXPECT_EQ(message("1 m)"), "unexpected \")\"");
  EXPECT_EQ(message("1e999 m"), "1e999 m is beyond the range of numbers");
  EXPECT_EQ(message("1e99999999999999999999 m"), "1e99999999999999999999 m is beyond the range of numbers");
  EXPECT_NE(message("nan m"), "");
  EXPECT_NE(message("inf m"), "");
  EXPECT_NE(message(""), "");
  EXPECT_NE(message(std::string(1000, '(')), "");
  EXPECT_NE(message("1 " + std::string(90, '(')), "");
}

TEST(Units, WritesTheUnitAnEngineerWouldChoose) {
  EXPECT_EQ(format_quantity(4.6e-6, dimension::length), "4.6 um");
  EXPECT_EQ(format_quantity(10200, dimension::density), "10.2 g/cm^3");
  EXPECT_EQ(format_quantity(317e9, dimension::pressure), "317 GPa");
  EXPECT_EQ(format_quantity(0.025, dimension::surface_energy), "25 mJ/m^2");
  EXPECT_EQ(format_quantity(0, dimension::length), "0 m");
  EXPECT_EQ(format_quantity(-9.81, dimension::acceleration), "-9.81 m/s^2");
  EXPECT_EQ(format_quantity(0.25, dimension::angle), "90 deg");
  EXPECT_EQ(format_quantity(0.31, dimension::none), "0.31");
  EXPECT_EQ(format_quantity(1e-6, dimension::time), "1 us");
  EXPECT_EQ(format_quantity(2.0, Dimension{1, 2, -1}), "2 kg m^2 s^-1");
}

TEST(Units, ReadsBackWhatItWrites) {
  const std::vector<Dimension> dimensions{
      dimension::mass,     dimension::length,         dimension::time,      dimension::frequency,
      dimension::speed,    dimension::force,          dimension::energy,    dimension::area,
      dimension::pressure, dimension::density,        dimension::volume,    dimension::angle,
      dimension::none,     dimension::surface_energy, dimension::mass_rate, Dimension{2, -1, 3}};
  for (const Dimension& due : dimensions)
    for (double value = 1.2345678e-18; value < 1e15; value *= 7.3)
      for (const double sign : {1.0, -1.0}) {
        const std::string text = format_quantity(sign * value, due, 15);
        EXPECT_NEAR(value_of(text, due) / value, sign, 1e-13) << text;
      }
}

TEST(Units, NamesDimensions) {
  EXPECT_EQ(dimension_with_article(dimension::pressure), "a pressure");
  EXPECT_EQ(dimension_with_article(dimension::energy), "an energy");
  EXPECT_EQ(dimension_name(Dimension{1, 2, 0}), "quantity in kg m^2");
}

}  // namespace
}  // namespace pulvis
