// Lengths, positions and volumes of one input with the same number of decimals, so that columns can be compared.
//
// Guarantees: a thousandth of the samples' spacing can be seen. Where the spacing is beyond 10^-6 to 10^6, numbers have
// four digits and an exponent instead. No number is "-0.000".
#pragma once

#include <optional>
#include <string>

#include "cli/layer.h"
#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert::cli {

class FixedDecimals {
 public:
  // Nothing for fewer than two samples.
  explicit FixedDecimals(const std::optional<Rational>& squared_spacing);

  [[nodiscard]] std::string length(double value) const;
  [[nodiscard]] std::string volume(double value) const;
  // "1.250 0.000 -3.100"
  [[nodiscard]] std::string position(const Point& point) const;

 private:
  std::optional<int> decimals_, of_volumes_;
};

}  // namespace flowcert::cli
