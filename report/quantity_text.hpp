// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace pulvis::report {

/// The unit in which numbers of a table or figure are shown.
struct DisplayUnit {
  double factor = 1.0;  ///< SI value times this
  std::string name;     ///< "mm"; empty for plain numbers
};

/// The unit an engineer would choose for numbers up to `largest` given in `unit` ("m", "kg/m^3", "1"). A unit that
/// is not known stays as it is.
DisplayUnit display_unit(double largest, const std::string& unit);
DisplayUnit display_unit(const std::vector<double>& values, const std::string& unit);

/// So many significant digits, without a power of ten where that is readable: "220", "0.48", "3.4e-06".
std::string number_text(double value, int digits = 4);

/// "1.6 g", "0.4803"; "-" for what is not a number.
std::string value_text(double value, const std::string& unit, int digits = 4);

/// "height (mm)", "porosity".
std::string with_unit(const std::string& words, const DisplayUnit& unit);

std::vector<double> scaled(const std::vector<double>& values, const DisplayUnit& unit);

/// "+2.1 %" of a ratio of 1.021.
std::string percent_more(double ratio);

/// "mean porosity" for "porosity_mean"; a name that is not known with blanks instead of underscores.
std::string measure_words(const std::string& name);

/// The largest of those that are finite, in absolute value; 0 if none is.
double largest_of(const std::vector<double>& values);

}  // namespace pulvis::report
