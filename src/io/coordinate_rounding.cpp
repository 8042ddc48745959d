#include "io/coordinate_rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace flowcert::io {

namespace {

bool is_float(double x) {
  return std::fabs(x) <= std::numeric_limits<float>::max() && static_cast<double>(static_cast<float>(x)) == x;
}

// How many decimal places the shortest decimal has; negative for a multiple of ten. {fmt} knows it by a tenth of the
// tables that libc++ has for std::to_chars.
template <typename Number>
int decimal_places(Number x) {
  const std::string text = fmt::to_string(x);
  const std::size_t e = std::min(text.find('e'), text.size()), point = text.find('.');
  const int digits = point < e ? static_cast<int>(e - point) - 1 : 0;
  const std::size_t exponent_at = text.substr(e, 2) == "e+" ? e + 2 : e + 1;
  int exponent = 0;
  if (e < text.size()) std::from_chars(text.data() + exponent_at, text.data() + text.size(), exponent);
  return digits - exponent;
}

template <typename Visit>
void each_coordinate(const PointSet& points, const Visit& visit) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const double x : {points[k].x, points[k].y, points[k].z}) visit(x);
  }
}

}  // namespace

Rational coordinate_unit(const PointSet& points) {
  bool are_floats = true;
  each_coordinate(points, [&](double x) { are_floats = are_floats && is_float(x); });
  int places = 0;
  each_coordinate(points, [&](double x) {
    if (x == std::trunc(x)) return;
    places = std::max(places, are_floats ? decimal_places(static_cast<float>(x)) : decimal_places(x));
  });
  if (places == 0) return 0;
  return Rational(1, pow(boost::multiprecision::mpz_int(10), static_cast<unsigned>(places)));
}

Rational length_rounding(const PointSet& points) { return coordinate_unit(points) * Rational(7, 2); }

}  // namespace flowcert::io
