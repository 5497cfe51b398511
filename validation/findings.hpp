// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "output/figure.hpp"

namespace pulvis::validation {

/// How a value is set against its reference.
enum class Compare {
  relative,  ///< |value/reference - 1|
  absolute,  ///< |value - reference|
  bound,     ///< the value itself is the deviation: an error that should be 0
  at_least   ///< what the value lacks of the reference
};

/// One comparison: a quantity, what it should be and who says so, and what we found.
struct Row {
  std::string name;
  std::string source;  ///< of the reference
  double reference = 0.0, value = 0.0, deviation = 0.0;
  std::optional<double> limit;      ///< of the deviation; none: reported, not judged
  std::optional<double> automatic;  ///< the same quantity at the time step a case would be given

  /// A deviation that is not a number does not pass.
  bool passed() const { return !limit || deviation <= *limit; }
};

/// What one chapter found.
class Findings {
 public:
  /// Adds a comparison; `limit` none where it is only reported.
  Row& compare(std::string name, std::string source, double reference, double value, Compare how,
               std::optional<double> limit);
  void figure(Figure figure) { figures_.push_back(std::move(figure)); }

  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<Figure>& figures() const { return figures_; }
  bool passed() const;

 private:
  std::vector<Row> rows_;
  std::vector<Figure> figures_;
};

}  // namespace pulvis::validation
