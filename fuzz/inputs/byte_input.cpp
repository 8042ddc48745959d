// The lattices, and both directions; see byte_input.h for the layout.
//
// Guarantees: every lattice point is a double, without rounding. It has 42 bits at most, in a unit whose largest
// multiple is finite and whose smallest is a subnormal. Encoding tries all lattices, and decodes to what was encoded.
#include "fuzz/inputs/byte_input.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flowcert::fuzz {
namespace {

constexpr std::array kHalfWidths = {1, 2, 3, 4, 6, 10, 30, 127};
// Exponents of the units: usual ones, ones far enough apart for filters to give up, and the ends of the range.
constexpr std::array kUnits = {0, -2, -30, 30, 250, -250, 980, -1074};
// The middle of a lattice that is far from the origin. There a few rows are enough to see an ulp.
constexpr std::array kFar = {0x1p40, -0x1p41, 0x1p39};
constexpr std::array kSteps = {0, 1, -1, 0};
constexpr std::size_t kRowBytes = 4;

using LatticePoint = std::array<int, 3>;

struct Lattice {
  int half_width = 1;
  int unit = 0;
  bool is_far = false;

  explicit Lattice(unsigned header)
      : half_width(kHalfWidths.at(header & 7U)), unit(kUnits.at(header >> 3U & 7U)), is_far((header & 0x40U) != 0) {}

  [[nodiscard]] double coordinate(std::size_t axis, int k) const {
    return std::ldexp((is_far ? kFar.at(axis) : 0) + k, unit);
  }
  // The nearest coordinate in the lattice; nothing if x is beyond its end.
  [[nodiscard]] std::optional<int> nearest(std::size_t axis, double x) const {
    const double k = std::nearbyint(std::ldexp(x, -unit) - (is_far ? kFar.at(axis) : 0));
    return std::abs(k) <= half_width ? std::optional<int>(static_cast<int>(k)) : std::nullopt;
  }
};

constexpr unsigned kUlpsCount = 0x80;
constexpr unsigned kSpecial = 0xc0;
constexpr unsigned kHasUlps = 0xc0;
constexpr unsigned kIsImage = 0x80;

// One of the 48 symmetries of the cube, by number. The numbers 48 to 63 are the identity.
LatticePoint image(const LatticePoint& point, unsigned number) {
  constexpr unsigned kSymmetries = 48;
  if (number % 64 >= kSymmetries) return point;
  const unsigned signs = number % 64 % 8;
  const unsigned order = number % 64 / 8;
  LatticePoint turned = point;
  std::rotate(turned.begin(), turned.begin() + order % 3, turned.end());
  if (order >= 3) std::swap(turned[0], turned[1]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((signs >> axis & 1U) != 0) turned.at(axis) = -turned.at(axis);
  }
  return turned;
}

LatticePoint lattice_point(const Lattice& lattice, Bytes row, const std::vector<LatticePoint>& earlier) {
  if ((row[3] & kSpecial) == kIsImage && !earlier.empty()) {
    return image(earlier[row[0] % earlier.size()], row[1]);
  }
  const int width = 2 * lattice.half_width + 1;
  return {row[0] % width - lattice.half_width, row[1] % width - lattice.half_width,
          row[2] % width - lattice.half_width};
}

std::optional<std::array<std::uint8_t, kRowBytes>> row_in(const Lattice& lattice, const Row& row) {
  std::array<std::uint8_t, kRowBytes> bytes{};
  unsigned ulps = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = lattice.nearest(axis, row[axis]);
    if (!k) return std::nullopt;
    bytes[axis] = static_cast<std::uint8_t>(*k + lattice.half_width);
    unsigned step = 0;
    while (step < 3 && nudged(lattice.coordinate(axis, *k), kSteps.at(step)) != row[axis]) ++step;
    if (step == 3) return std::nullopt;
    ulps |= step << 2 * axis;
  }
  bytes[3] = static_cast<std::uint8_t>(ulps == 0 ? 0 : kHasUlps | ulps);
  return bytes;
}

// The header says that ulps count if some row needs them.
std::optional<std::vector<std::uint8_t>> bytes_in(unsigned header, const Input& input) {
  const Lattice lattice(header);
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(header)};
  for (const Row& row : input.rows) {
    const auto row_bytes = row_in(lattice, row);
    if (!row_bytes) return std::nullopt;
    bytes.insert(bytes.end(), row_bytes->begin(), row_bytes->end());
    if (row_bytes->back() != 0) bytes.front() |= kUlpsCount;
  }
  return bytes;
}

}  // namespace

Input input_of_bytes(Bytes bytes, std::size_t most_rows) {
  Input input;
  if (bytes.empty()) return input;
  const unsigned header = bytes.front();
  const Lattice lattice(header);
  std::vector<LatticePoint> points;
  bytes = bytes.subspan(1);
  for (; bytes.size() >= kRowBytes && points.size() < most_rows; bytes = bytes.subspan(kRowBytes)) {
    points.push_back(lattice_point(lattice, bytes, points));
    const bool has_ulps = (header & kUlpsCount) != 0 && (bytes[3] & kSpecial) == kHasUlps;
    const unsigned ulps = has_ulps ? bytes[3] : 0U;
    Row row{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row.at(axis) = nudged(lattice.coordinate(axis, points.back().at(axis)), kSteps.at(ulps >> 2 * axis & 3U));
    }
    input.rows.push_back(row);
  }
  return input;
}

std::optional<std::vector<std::uint8_t>> bytes_of_input(const Input& input) {
  for (unsigned header = 0; header < kUlpsCount; ++header) {
    if (auto bytes = bytes_in(header, input)) return bytes;
  }
  return std::nullopt;
}

}  // namespace flowcert::fuzz
