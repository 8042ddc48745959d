// The rows of a file of atoms as balls, exactly, beside the rows as doubles (point_rows.h): where radii are asked for.
//
// Guarantees: a coordinate or a radius is the number that is written, or the float that a binary file stores. Numbers
// that would take far more room than doubles do are refused. What is wrong with an atom is said with its line, its id
// and its name. Source: spec clause FC-FILE-55.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flowcert/atom_names.h"
#include "flowcert/atom_radii.h"
#include "flowcert/ball_set.h"
#include "io/elements.h"
#include "io/layer.h"
#include "io/line_reader.h"

namespace flowcert::io {

// The note of a cell that is left aside.
inline constexpr std::string_view kCellNote =
    "the cell is ignored: the atoms are a finite set, without periodic images";

// Throws InvalidInput for a radius of 0 or below. text: as it is written.
void require_radius(const Rational& radius, std::string_view text, const LinePlace& place);

class BallRows {
 public:
  // is_finite: a user says that the cell of a crystal is left aside.
  BallRows(const AtomRadii& radii, std::string_view file, bool is_finite)
      : radii_(radii), file_(file), is_finite_(is_finite), place_{.file = file} {}

  [[nodiscard]] const AtomRadii& radii() const { return radii_; }

  // ---- What is known of the next row before it is added ----
  void see_radius(std::string_view text) { next_radius_ = text; }
  // Where it is, and its centre if that is not the doubles that are added.
  void see_centre(const std::optional<RationalPoint>& centre, const LinePlace& place);

  // ---- Rows ----
  void add(const std::array<std::string_view, 3>& fields, const LinePlace& place);
  void add(const Point& point);
  // Of the row that was added last; names has it, too.
  void see_element(const AtomNames& names, std::string_view residue, const ElementText& text);

  // ---- Cells ----
  // Throws InvalidInput where the atoms are those of a crystal, unless a user says that they are a finite set.
  void see_crystal(std::size_t line) const;

  // How many elements are known by names of atoms alone.
  [[nodiscard]] std::size_t named_elements() const { return named_elements_; }
  [[nodiscard]] std::vector<Ball> take() { return std::move(balls_); }

 private:
  void add(RationalPoint centre);
  void take_radius(const Rational& radius);
  void require_short(const Rational& number) const;
  void reject_element(const AtomNames& names, const ElementText& text, const MeantElement& meant) const;

  const AtomRadii& radii_;
  std::string_view file_;
  bool is_finite_;
  std::string_view next_radius_;
  std::optional<RationalPoint> next_centre_;
  LinePlace place_;  // of the last row; its line is 0 where it has none
  std::size_t named_elements_ = 0;
  std::vector<Ball> balls_;
};

}  // namespace flowcert::io
