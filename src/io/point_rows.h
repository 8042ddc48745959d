// Rows that a reader finds, one by one, as points; what all readers of point files share.
//
// Guarantees: a row with a coordinate that is not a finite number is an error, or is left out and counted where the
// user asks for that. Source: spec clauses FC-IN-01, FC-IN-02,
// FC-FILE-38.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "flowcert/rational.h"
#include "flowcert/read_points.h"
#include "io/ball_rows.h"
#include "io/layer.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

// The note of a binary file of 32-bit floats.
inline constexpr std::string_view kSinglePrecisionNote =
    "the coordinates are single precision, and are taken exactly as such";

// A number as files of points have it: with Fortran's exponent, 1.0D-03, and Mathematica's, 1.0*^-3, too.
[[nodiscard]] NumberText coordinate_of(std::string_view field);
// The same number, not rounded. Throws InvalidInput for what is none, and for one of absurd length (claimed_number).
[[nodiscard]] Rational exact_number(std::string_view field, const LinePlace& place);

class PointRows {
 public:
  // balls: takes the same rows, if it is there.
  PointRows(std::string_view file, const ReadingOptions& options, BallRows* balls = nullptr)
      : file_(file), options_(options), balls_(balls) {}

  [[nodiscard]] const ReadingOptions& options() const { return options_; }
  [[nodiscard]] std::string_view file() const { return file_; }
  // Null where no radii are asked for.
  [[nodiscard]] BallRows* balls() const { return balls_; }
  // The file's rows so far, those that are left out, too.
  [[nodiscard]] std::size_t count() const { return points_.rows.size() + points_.left_out.size(); }

  // The announced rows, of which each takes at least `smallest` of the remaining bytes: six for "0 0 0" in a line.
  void reserve(std::uint64_t announced, std::size_t bytes, std::size_t smallest);
  // A row of text. Returns whether it is a point.
  bool add(const std::array<std::string_view, 3>& fields, const LinePlace& place);
  // A row of numbers that a binary file stores.
  bool add(const Point& point);
  // What the file calls the last point, if it is a molecule, and which element it says.
  void name(const AtomName& name, const ElementText& element) {
    points_.atoms.add(name);
    if (balls_ != nullptr) balls_->see_element(points_.atoms, name.residue, element);
  }
  void note(std::size_t line, std::string text) { points_.notes.push_back({line, std::move(text)}); }

  [[nodiscard]] PointFile take();

 private:
  static constexpr std::size_t kRowsBetween = 4096;
  void tell() const {
    if (options_.progress && count() % kRowsBetween == 0) options_.progress();
  }

  std::string_view file_;
  const ReadingOptions& options_;
  BallRows* balls_;
  PointFile points_;
};

// A point from the next three fields. Any further fields are not looked at.
void add_first_three(Fields& fields, const LinePlace& place, PointRows& rows);

// Throws InvalidInput for anything but blanks and zero bytes behind the last row.
void reject_further_bytes(std::string_view bytes, std::string_view file);

}  // namespace flowcert::io
