#include "fuzz/inputs/transformations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace flowcert::fuzz {
namespace {

// The range of exponents by which a number can be scaled exactly; everything for 0.
std::pair<int, int> exact_exponents(double value) {
  constexpr int kReach = 2200;
  if (value == 0) {
    return {-kReach, kReach};
  }
  int exponent = 0;
  auto mantissa = static_cast<Integer>(std::ldexp(std::frexp(value, &exponent), 53));
  int lowest_bit = exponent - 53;
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++lowest_bit;
  }
  constexpr int kSmallest = std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
  return {kSmallest - lowest_bit, std::numeric_limits<double>::max_exponent - exponent};
}

}  // namespace

std::optional<Input> scaled(const Input& input, int exponent) {
  Input result = input;
  for (Row& row : result.rows) {
    for (double& coordinate : row) {
      const auto [least, most] = exact_exponents(coordinate);
      if (exponent < least || exponent > most) {
        return std::nullopt;
      }
      coordinate = std::ldexp(coordinate, exponent);
    }
  }
  return result;
}

rc::Gen<int> exact_scalings(const Input& input) {
  std::pair<int, int> common = exact_exponents(0);
  for (const Row& row : input.rows) {
    for (const double coordinate : row) {
      const auto [least, most] = exact_exponents(coordinate);
      common = {std::max(common.first, least), std::min(common.second, most)};
    }
  }
  // The two ends of the range together come as often as all values between.
  return rc::gen::map(rc::gen::pair(whole(0, 3), whole(common.first, common.second)),
                      [common](const std::pair<Integer, Integer>& choice) {
                        if (choice.first < 2) return static_cast<int>(choice.second);
                        return choice.first == 2 ? common.first : common.second;
                      });
}

std::optional<Input> turned(const Input& input, const IntegerRotation& rotation) {
  // A coordinate is a sum of three products with the matrix's entries, each of which is at most the norm.
  constexpr Integer kLargest = Integer{1} << 50;
  const Integer largest = kLargest / (3 * rotation.norm);
  const auto reach = static_cast<double>(largest);
  IntegerPoints points;
  for (const Row& row : input.rows) {
    const bool fits = std::all_of(row.begin(), row.end(), [reach](double coordinate) {
      return std::abs(coordinate) <= reach && coordinate == std::floor(coordinate);
    });
    if (!fits) {
      return std::nullopt;
    }
    points.push_back(
        rotation({static_cast<Integer>(row[0]), static_cast<Integer>(row[1]), static_cast<Integer>(row[2])}));
  }
  return to_input(points);
}

}  // namespace flowcert::fuzz
