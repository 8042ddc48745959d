// Exact numbers between GMP and Python.
//
// Guarantees: nothing is rounded, and no number is too long. Digits are hexadecimal, because Python refuses decimals of
// more than 4,300 digits. All of these need Python's lock.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <string>

#include "flowcert/rational.h"

namespace flowcert::python {

// (numerator, denominator), two ints; the denominator is positive.
[[nodiscard]] pybind11::tuple ratio_of(const Rational& value);
// Three of these.
[[nodiscard]] pybind11::tuple ratios_of(const RationalPoint& point);

// From "-1f/3", hexadecimal and reduced.
[[nodiscard]] Rational rational_of(const std::string& hexadecimal);
[[nodiscard]] RationalPoint point_of(const std::array<std::string, 3>& hexadecimal);

// The same number in decimals, "-31/3", "5".
[[nodiscard]] std::string decimal_text(const std::string& hexadecimal);

}  // namespace flowcert::python
