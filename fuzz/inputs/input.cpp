// Exact printing of an input: std::to_chars without a precision is the shortest text that reads back the
// same, and does not depend on the locale.
#include "fuzz/inputs/input.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <ostream>
#include <string_view>

namespace flowcert::fuzz {

namespace {

void print(std::ostream& out, double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Input& input) {
  for (const Row& row : input.rows) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      print(out, row[axis]);
      out << (axis < 2 ? ' ' : '\n');
    }
  }
  return out;
}

double nudged(double value, int steps) {
  return steps == 0 ? value : std::nextafter(value, steps * std::numeric_limits<double>::infinity());
}

}  // namespace flowcert::fuzz
