// What the transformations of fuzz/inputs/transformations.h and tests/transformed_inputs.h do to an answer: to its
// points and to its names.
//
// Guarantees: exact.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "flowcert/rational.h"
#include "fuzz/inputs/input.h"
#include "tests/transformed_inputs.h"

namespace flowcert::property {

// For each row of `input`, the name of its class after the rows were reordered: its smallest new place.
inline std::vector<std::size_t> names_after(const fuzz::Input& input, const std::vector<std::size_t>& order) {
  std::map<fuzz::Row, std::size_t> smallest;  // -0.0 and 0.0 are one key
  for (std::size_t place = 0; place < order.size(); ++place) {
    smallest.emplace(input.rows[order[place]], place);
  }
  std::vector<std::size_t> names;
  names.reserve(input.rows.size());
  for (const fuzz::Row& row : input.rows) {
    names.push_back(smallest.at(row));
  }
  return names;
}

inline Rational power_of_two(int exponent) {
  const auto magnitude = static_cast<unsigned>(std::abs(exponent));
  const Rational power(boost::multiprecision::mpz_int(1) << magnitude);
  return exponent < 0 ? Rational(1 / power) : power;
}

inline RationalPoint image_of(const RationalPoint& x, const fuzz::AxisMap& map) {
  RationalPoint image;
  for (std::size_t k = 0; k < 3; ++k) {
    image[k] = map.sign[k] * x[map.axis[k]];
  }
  return image;
}

inline RationalPoint scaled_by(const RationalPoint& x, const Rational& factor) {
  return {x[0] * factor, x[1] * factor, x[2] * factor};
}

inline RationalPoint translated_by(const RationalPoint& x, const fuzz::Row& offset) {
  return {x[0] + Rational(offset[0]), x[1] + Rational(offset[1]), x[2] + Rational(offset[2])};
}

}  // namespace flowcert::property
