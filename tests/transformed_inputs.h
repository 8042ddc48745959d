// More transformations of an input under which its answer is known, beside those of fuzz/inputs/transformations.h:
// permutations of the rows, signed permutations of the axes, and translations where they are exact on every coordinate.
//
// Guarantees: no rounding. `translated` gives nothing where a coordinate of the result would have to be rounded; the
// generators make only exact ones, and shrink towards the identity.
//
// Source: a sum of doubles is exact iff the error term of Knuth's TwoSum is zero. The error term does not overflow
// here, because a sum that overflows is refused first.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {

// Row k of the result is row order[k] of the input.
inline Input permuted(const Input& input, const std::vector<std::size_t>& order) {
  Input result;
  for (const std::size_t row : order) {
    result.rows.push_back(input.rows[row]);
  }
  return result;
}

inline rc::Gen<std::vector<std::size_t>> row_orders(std::size_t rows) {
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

// Coordinate k of a result is sign[k] times coordinate axis[k].
struct AxisMap {
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};
};
// As "+z -x +y".
inline std::ostream& operator<<(std::ostream& out, const AxisMap& map) {
  for (std::size_t k = 0; k < 3; ++k) {
    out << (k == 0 ? "" : " ") << (map.sign[k] < 0 ? '-' : '+') << "xyz"[map.axis[k]];
  }
  return out;
}

inline Input mapped(const Input& input, const AxisMap& map) {
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

inline rc::Gen<AxisMap> axis_maps() {
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

inline bool is_exact_sum(double a, double b) {
  const double sum = a + b;
  if (!std::isfinite(sum)) {
    return false;
  }
  const double b_part = sum - a;
  const double error = (a - (sum - b_part)) + (b - b_part);
  return error == 0;
}

inline std::optional<Input> translated(const Input& input, const Row& offset) {
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

// A candidate for an offset: an integer one for the choices 0 and 1, otherwise minus a row.
inline Row offset_of_choice(const Input& input, Integer choice, const IntegerPoint& integers, int exponent) {
  if (choice < 2 || input.rows.empty()) {
    return {std::ldexp(static_cast<double>(integers[0]), exponent),
            std::ldexp(static_cast<double>(integers[1]), exponent),
            std::ldexp(static_cast<double>(integers[2]), exponent)};
  }
  const Row& row = input.rows[static_cast<std::size_t>(choice) % input.rows.size()];
  return {-row[0], -row[1], -row[2]};
}

// Integer offsets, or one that takes a point of the input to the origin; no offset where none of those tried
// is exact.
inline rc::Gen<Row> exact_translations(const Input& input) {
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

}  // namespace flowcert::fuzz
