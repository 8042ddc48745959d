#include "io/point_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flowcert::io {

namespace {

constexpr std::string_view kHowToSkip = "; --skip-invalid leaves such rows out";

// With e for the exponent's mark. A text without another mark stays as it is.
std::string with_e(std::string_view field) {
  std::string text(field);
  const bool is_hexadecimal = text.find_first_of("xX") != std::string::npos;
  if (const std::size_t mark = text.find("*^"); mark != std::string::npos) text.replace(mark, 2, 1, 'e');
  const std::size_t mark = text.find_first_of("dD");
  if (mark != std::string::npos && mark > 0 && !is_hexadecimal) text[mark] = 'e';
  return text;
}

}  // namespace

NumberText coordinate_of(std::string_view field) {
  const NumberText number = parse_number(field);
  // "nan" and "infinity" have no d.
  return number.is_number() ? number : parse_number(with_e(field));
}

Rational exact_number(std::string_view field, const LinePlace& place) {
  if (const char* const fault = coordinate_of(field).fault; fault != nullptr) {
    place.reject(fmt::format("{}: {}", fault, in_quotes(field)));
  }
  const bool is_usual = parse_number(field).is_number();
  const std::string text = is_usual ? std::string(field) : with_e(field);
  return claimed_number(text, PlainInteger::kDecimal, place).value;
}

void PointRows::reserve(std::uint64_t announced, std::size_t bytes, std::size_t smallest) {
  points_.rows.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(announced, bytes / smallest + 1)));
}

bool PointRows::add(const std::array<std::string_view, 3>& fields, const LinePlace& place) {
  std::array<double, 3> numbers{};
  bool is_point = true;
  tell();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const NumberText number = coordinate_of(fields[axis]);
    const bool is_skipped = !number.is_finite && options_.skip_invalid;
    if (number.fault != nullptr && !is_skipped) {
      place.reject(fmt::format("{}: {}{}", number.fault, in_quotes(fields[axis]), number.is_finite ? "" : kHowToSkip));
    }
    is_point = is_point && number.is_finite;
    numbers[axis] = number.value;
  }
  if (is_point) {
    points_.rows.push_back({numbers[0], numbers[1], numbers[2]});
    if (balls_ != nullptr) balls_->add(fields, place);
  } else {
    points_.left_out.push_back(count());
  }
  return is_point;
}

bool PointRows::add(const Point& point) {
  tell();
  for (const auto& [value, axis] : {std::pair(point.x, 'x'), std::pair(point.y, 'y'), std::pair(point.z, 'z')}) {
    if (std::isfinite(value)) continue;
    if (!options_.skip_invalid) {
      reject_file(file_, fmt::format("row {}: not a finite number: {}{}", count(), axis, kHowToSkip));
    }
    points_.left_out.push_back(count());
    return false;
  }
  points_.rows.push_back(point);
  if (balls_ != nullptr) balls_->add(point);
  return true;
}

PointFile PointRows::take() {
  if (points_.rows.empty() && !points_.left_out.empty()) reject_file(file_, "no row is a point");
  return std::move(points_);
}

void add_first_three(Fields& fields, const LinePlace& place, PointRows& rows) {
  std::array<std::string_view, 3> row;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!fields.next(row[k])) place.reject(fmt::format("too few numbers: {} of 3", k));
  }
  rows.add(row, place);
}

void reject_further_bytes(std::string_view bytes, std::string_view file) {
  const auto is_padding = [](char c) { return c == '\0' || is_blank(c); };
  if (!std::ranges::all_of(bytes, is_padding)) reject_file(file, "there are more bytes than rows announced");
}

}  // namespace flowcert::io
