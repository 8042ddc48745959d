// Exact transformations; see transformations.h for what they guarantee.
//
// Source: a sum of doubles is exact iff the error term of Knuth's TwoSum is zero. The error term does not overflow
// here, because a sum that overflows is refused first.
#include "fuzz/inputs/transformations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <ostream>
#include <utility>

namespace flowcert::fuzz {
namespace {

bool is_exact_sum(double a, double b) {
  const double sum = a + b;
  if (!std::isfinite(sum)) {
    return false;
  }
  const double b_part = sum - a;
  const double error = (a - (sum - b_part)) + (b - b_part);
  return error == 0;
}

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

// A candidate for an offset: an integer one for the choices 0 and 1, otherwise minus a row.
Row offset_of_choice(const Input& input, Integer choice, const IntegerPoint& integers, int exponent) {
  if (choice < 2 || input.rows.empty()) {
    return {std::ldexp(static_cast<double>(integers[0]), exponent),
            std::ldexp(static_cast<double>(integers[1]), exponent),
            std::ldexp(static_cast<double>(integers[2]), exponent)};
  }
  const Row& row = input.rows[static_cast<std::size_t>(choice) % input.rows.size()];
  return {-row[0], -row[1], -row[2]};
}

}  // namespace

Input permuted(const Input& input, const std::vector<std::size_t>& order) {
  Input result;
  for (const std::size_t row : order) {
    result.rows.push_back(input.rows[row]);
  }
  return result;
}

rc::Gen<std::vector<std::size_t>> row_orders(std::size_t rows) {
  // This is Fisher and Yates' shuffle with one raw integer a row. All zeros give the identity.
  return rc::gen::map(rc::gen::container<std::vector<Integer>>(rows, whole(0, 1'000'000)),
                      [](const std::vector<Integer>& raw) {
                        std::vector<std::size_t> order(raw.size());
                        std::iota(order.begin(), order.end(), std::size_t{0});
                        for (std::size_t k = 0; k < order.size(); ++k) {
                          const std::size_t step = static_cast<std::size_t>(raw[k]) % (order.size() - k);
                          std::swap(order[k], order[k + step]);
                        }
                        return order;
                      });
}

std::ostream& operator<<(std::ostream& out, const AxisMap& map) {
  for (std::size_t k = 0; k < 3; ++k) {
    out << (k == 0 ? "" : " ") << (map.sign[k] < 0 ? '-' : '+') << "xyz"[map.axis[k]];
  }
  return out;
}

Input mapped(const Input& input, const AxisMap& map) {
  Input result;
  for (const Row& row : input.rows) {
    Row image{};
    for (std::size_t k = 0; k < 3; ++k) {
      image[k] = map.sign[k] * row[map.axis[k]];
    }
    result.rows.push_back(image);
  }
  return result;
}

rc::Gen<AxisMap> axis_maps() {
  return rc::gen::map(whole(0, 47), [](Integer code) {
    AxisMap map;
    for (Integer step = code / 8; step > 0; --step) {
      std::next_permutation(map.axis.begin(), map.axis.end());
    }
    for (std::size_t k = 0; k < 3; ++k) {
      map.sign[k] = (code >> k & 1) != 0 ? -1 : 1;
    }
    return map;
  });
}

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
                        switch (choice.first) {
                          case 2:
                            return common.first;
                          case 3:
                            return common.second;
                          default:
                            return static_cast<int>(choice.second);
                        }
                      });
}

std::optional<Input> translated(const Input& input, const Row& offset) {
  Input result = input;
  for (Row& row : result.rows) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!is_exact_sum(row[axis], offset[axis])) {
        return std::nullopt;
      }
      row[axis] += offset[axis];
    }
  }
  return result;
}

rc::Gen<Row> exact_translations(const Input& input) {
  return rc::gen::apply(
      [input](Integer choice, const IntegerPoint& integers, Integer largest_exponent) {
        for (auto exponent = static_cast<int>(largest_exponent); exponent >= 0; exponent -= 5) {
          const Row offset = offset_of_choice(input, choice, integers, exponent);
          if (translated(input, offset)) {
            return offset;
          }
        }
        return Row{0, 0, 0};
      },
      whole(0, 6), integer_point(-100, 100), whole(0, 44));
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
