// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>

// Numbers with a unit: text from a case file becomes an SI value, an SI value becomes text for reports.
namespace pulvis {

/// Exponents of the base units kg, m, s. An angle counts in turns (cycles), so that 90 deg is 0.25.
struct Dimension {
  int kilogram = 0, metre = 0, second = 0, turn = 0;
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
  return {a.kilogram + b.kilogram, a.metre + b.metre, a.second + b.second, a.turn + b.turn};
}
constexpr Dimension to_power(const Dimension& a, int n) {
  return {a.kilogram * n, a.metre * n, a.second * n, a.turn * n};
}

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension mass{1, 0, 0};
inline constexpr Dimension length{0, 1, 0};
inline constexpr Dimension area{0, 2, 0};
inline constexpr Dimension volume{0, 3, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension frequency{0, 0, -1};
inline constexpr Dimension speed{0, 1, -1};
inline constexpr Dimension acceleration{0, 1, -2};
inline constexpr Dimension density{1, -3, 0};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension pressure{1, -1, -2};
inline constexpr Dimension energy{1, 2, -2};
inline constexpr Dimension surface_energy{1, 0, -2};  // also that of a stiffness, N/m
inline constexpr Dimension mass_rate{1, 0, -1};
inline constexpr Dimension angle{0, 0, 0, 1};
}  // namespace dimension

/// A value in kg, m, s (turns for angles) and what it is.
struct Quantity {
  double value = 0.0;
  Dimension dimension;
};

/// What became of a text: a quantity, or a message that says what is wrong with it.
struct QuantityReading {
  std::optional<Quantity> quantity;
  std::string message;  ///< empty if there is a quantity
  std::string number;   ///< the number as written, if the text starts with one
};

/// Reads "4.6 um", "25 mJ/m^2", "10.2 g/cm3", "90 deg", "30 %". A bare number is a quantity without
/// dimension. Decimal prefixes are applied to the decimal exponent, so "4.6 um" is exactly 4.6e-6.
QuantityReading read_quantity(std::string_view text);

/// Writes an SI value in the unit an engineer would choose: 4.6e-6 m is "4.6 um".
std::string format_quantity(double value, const Dimension& dimension, int digits = 4);

/// "pressure", "length"; "number" without dimension; "quantity in kg m^2" for one without a name.
std::string dimension_name(const Dimension& dimension);

/// The same with its article: "a pressure", "an energy".
std::string dimension_with_article(const Dimension& dimension);

}  // namespace pulvis
