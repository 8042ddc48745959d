// Intervals of rationals, whose ends MPFR gives for cosines and roots. Where they decide the nearest double, they are
// narrow enough.
#include "io/crystal_cell.h"

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>

#include "io/number_text.h"

namespace flowcert::io {

namespace {

constexpr mpfr_prec_t kFirstPrecision = 128, kLastPrecision = 4096;

// A number of MPFR, which its destructor frees.
class Float {
 public:
  explicit Float(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  Float(const Rational& value, mpfr_prec_t precision, mpfr_rnd_t mode) : Float(precision) {
    mpfr_set_q(value_, value.backend().data(), mode);
  }
  ~Float() { mpfr_clear(value_); }
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;

  [[nodiscard]] mpfr_ptr get() { return value_; }
  [[nodiscard]] Rational rational() const {
    Rational value;
    mpfr_get_q(value.backend().data(), value_);
    return value;
  }

 private:
  mpfr_t value_;
};

struct Interval {
  Rational low, high;

  friend Interval operator+(const Interval& a, const Interval& b) { return {a.low + b.low, a.high + b.high}; }
  friend Interval operator-(const Interval& a, const Interval& b) { return {a.low - b.high, a.high - b.low}; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    const auto [low, high] = std::minmax(
        {Rational(a.low * b.low), Rational(a.low * b.high), Rational(a.high * b.low), Rational(a.high * b.high)});
    return {low, high};
  }
  // By a positive one.
  friend Interval operator/(const Interval& a, const Interval& b) {
    return a * Interval{Rational(1) / b.high, Rational(1) / b.low};
  }
};

Interval exactly(const Rational& value) { return {value, value}; }

Interval root(const Interval& square, mpfr_prec_t precision) {
  Float low(square.low, precision, MPFR_RNDD), high(square.high, precision, MPFR_RNDU);
  mpfr_sqrt(low.get(), low.get(), MPFR_RNDD);
  mpfr_sqrt(high.get(), high.get(), MPFR_RNDU);
  return {low.rational(), high.rational()};
}

// Of an angle between 0 and 180 degrees, where the cosine falls. Those of 60, 90 and 120 degrees are rational; no other
// angle of a rational number of degrees has a rational one (Niven).
Interval cosine(const Rational& degrees, mpfr_prec_t precision) {
  if (degrees == 90) return exactly(0);
  if (degrees == 60 || degrees == 120) return exactly(Rational(degrees == 60 ? 1 : -1) / 2);
  Float pi_low(precision), pi_high(precision);
  mpfr_const_pi(pi_low.get(), MPFR_RNDD);
  mpfr_const_pi(pi_high.get(), MPFR_RNDU);
  Float low(Rational(pi_high.rational() * degrees / 180), precision, MPFR_RNDU);
  Float high(Rational(pi_low.rational() * degrees / 180), precision, MPFR_RNDD);
  mpfr_cos(low.get(), low.get(), MPFR_RNDD);
  mpfr_cos(high.get(), high.get(), MPFR_RNDU);
  return {low.rational(), high.rational()};
}

// The rows of the matrix that takes fractional coordinates times their lengths to Cartesian ones.
using Rows = std::array<std::array<Interval, 3>, 3>;

// None where the precision does not show that the cell has a volume.
std::optional<Rows> rows_of(const std::array<Rational, 3>& angles, mpfr_prec_t precision) {
  const Interval alpha = cosine(angles[0], precision), beta = cosine(angles[1], precision),
                 gamma = cosine(angles[2], precision);
  const Interval one = exactly(1), zero = exactly(0);
  const Interval square = one - alpha * alpha - beta * beta - gamma * gamma + exactly(2) * alpha * beta * gamma;
  const Interval sine_square = one - gamma * gamma;
  if (square.low <= 0 || sine_square.low <= 0) return std::nullopt;
  const Interval sine = root(sine_square, precision);
  return Rows{
      {{one, gamma, beta}, {zero, sine, (alpha - beta * gamma) / sine}, {zero, zero, root(square, precision) / sine}}};
}

std::string without_blanks(std::string_view text) {
  std::string kept = lower_case(text);
  std::erase_if(kept, is_blank);
  return kept;
}

bool is_identity(std::string operation) {
  std::erase(operation, '+');
  return operation == "x,y,z";
}

}  // namespace

RationalPoint CartesianAxes::along_axes(const std::array<std::string_view, 3>& fractional,
                                        const LinePlace& place) const {
  RationalPoint along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along[axis] = claimed_number(fractional[axis], PlainInteger::kDecimal, place).value * lengths_[axis];
  }
  return along;
}

bool CartesianAxes::are_right() const {
  return std::ranges::all_of(angles_, [](const Rational& angle) { return angle == 90; });
}

std::optional<RationalPoint> CartesianAxes::exact_position(const std::array<std::string_view, 3>& fractional,
                                                           const LinePlace& place) const {
  if (!are_right()) return std::nullopt;
  return along_axes(fractional, place);
}

Point CartesianAxes::position(const std::array<std::string_view, 3>& fractional, const LinePlace& place) const {
  const RationalPoint along = along_axes(fractional, place);
  for (mpfr_prec_t precision = kFirstPrecision; precision <= kLastPrecision; precision *= 2) {
    const std::optional<Rows> rows = rows_of(angles_, precision);
    if (!rows) continue;
    std::array<std::optional<double>, 3> nearest;
    bool is_decided = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Interval sum = exactly(0);
      for (std::size_t k = 0; k < 3; ++k) sum = sum + (*rows)[axis][k] * exactly(along[k]);
      nearest[axis] = nearest_double(sum.low);
      is_decided = is_decided && nearest[axis] && nearest[axis] == nearest_double(sum.high);
    }
    if (is_decided) return {*nearest[0], *nearest[1], *nearest[2]};
  }
  place.reject("the Cartesian position is out of range, or its rounding is not decided by 4,096 bits");
}

void CrystalCell::see_item(const std::string& name, std::string_view value, const LinePlace& place) {
  if (name.starts_with("_cell_length_") || name.starts_with("_cell.length_") || name.starts_with("_cell_angle_") ||
      name.starts_with("_cell.angle_")) {
    if (name.ends_with("_su") || name.ends_with("_esd") || value == "?" || value == ".") return;
    numbers_[name.substr(std::string_view("_cell_").size())] =
        claimed_number(without_uncertainty(value), PlainInteger::kDecimal, place).value;
  }
  const bool is_group = name.starts_with("_symmetry") || name.starts_with("_space_group");
  if (!is_group || value == "?" || value == ".") return;
  if (name.ends_with("equiv_pos_as_xyz") || name.ends_with("symop_operation_xyz") ||
      name.ends_with("symop.operation_xyz")) {
    operations_.push_back(without_blanks(value));
  } else if (name.find("name_h-m") != std::string::npos) {
    groups_.emplace_back(value);
  } else if (name.ends_with("it_number") || name.ends_with("int_tables_number")) {
    groups_.push_back(value == "1" ? "P 1" : "number " + std::string(value));
  }
}

void CrystalCell::check_symmetry(std::string_view file) const {
  for (const std::string& operation : operations_) {
    if (!is_identity(operation)) {
      reject_file(file, fmt::format("fractional coordinates are read in P 1 alone, and this has the symmetry {}",
                                    in_quotes(operation)));
    }
  }
  for (const std::string& group : groups_) {
    if (without_blanks(group) != "p1") {
      reject_file(file, fmt::format("fractional coordinates are read in P 1 alone, and this is {}", in_quotes(group)));
    }
  }
  if (operations_.empty() && groups_.empty()) {
    reject_file(file, "fractional coordinates are read in P 1 alone, and the symmetry is not said");
  }
}

bool CrystalCell::has_lengths() const {
  return std::ranges::any_of(numbers_,
                             [](const auto& item) { return item.first.starts_with("length_") && item.second != 1; });
}

CartesianAxes CrystalCell::cartesian_axes(std::string_view file) const {
  check_symmetry(file);
  const auto number = [&](const char* name) {
    const auto found = numbers_.find(name);
    if (found == numbers_.end())
      reject_file(file, fmt::format("fractional coordinates, and no cell: there is no {}", name));
    return found->second;
  };
  const std::array<Rational, 3> lengths = {number("length_a"), number("length_b"), number("length_c")};
  const std::array<Rational, 3> angles = {number("angle_alpha"), number("angle_beta"), number("angle_gamma")};
  const bool is_cell = std::ranges::all_of(lengths, [](const Rational& length) { return length > 0; }) &&
                       std::ranges::all_of(angles, [](const Rational& angle) { return angle > 0 && angle < 180; }) &&
                       rows_of(angles, kLastPrecision).has_value();
  if (!is_cell) reject_file(file, "the cell's lengths and angles are those of no cell");
  return {lengths, angles};
}

std::string_view without_uncertainty(std::string_view number) {
  const std::size_t open = number.find('(');
  if (open == std::string_view::npos || open == 0 || !number.ends_with(')')) return number;
  const std::string_view digits = number.substr(open + 1, number.size() - open - 2);
  return is_integer(digits) ? number.substr(0, open) : number;
}

}  // namespace flowcert::io
