// The cell of a crystal, and fractional coordinates in it as Cartesian ones.
//
// Guarantees: with a along x and b in the plane of x and y, each coordinate is the double nearest to the exact value of
//   x = a u + b v cos γ + c w cos β
//   y = b v sin γ + c w (cos α - cos β cos γ) / sin γ
//   z = c w √(1 - cos² α - cos² β - cos² γ + 2 cos α cos β cos γ) / sin γ
// for the decimals that the file has. A value so near to the middle of two doubles that 4,096 bits do not decide is
// refused. Only the symmetry P 1 is taken. Throws InvalidInput. Source: spec clause FC-FILE-42.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/layer.h"
#include "io/line_reader.h"

namespace flowcert::io {

// 0.123(4) is 0.123 with an uncertainty of 4 in its last digit.
[[nodiscard]] std::string_view without_uncertainty(std::string_view number);

class CartesianAxes {
 public:
  // Lengths a, b, c, and angles α, β, γ in degrees.
  CartesianAxes(const std::array<Rational, 3>& lengths, const std::array<Rational, 3>& angles)
      : lengths_(lengths), angles_(angles) {}

  [[nodiscard]] Point position(const std::array<std::string_view, 3>& fractional, const LinePlace& place) const;
  // Whether all angles are right ones, so that positions are rational; and the position then.
  [[nodiscard]] bool are_right() const;
  [[nodiscard]] std::optional<RationalPoint> exact_position(const std::array<std::string_view, 3>& fractional,
                                                            const LinePlace& place) const;

 private:
  // Along the axes, in the unit of their lengths.
  [[nodiscard]] RationalPoint along_axes(const std::array<std::string_view, 3>& fractional,
                                         const LinePlace& place) const;

  std::array<Rational, 3> lengths_, angles_;
};

class CrystalCell {
 public:
  // An item of a CIF file, with its name in small letters. Those that are no concern of cells are passed over.
  void see_item(const std::string& name, std::string_view value, const LinePlace& place);
  // Whether a crystal's cell is said. Structures without a crystal have lengths of 1.
  [[nodiscard]] bool has_lengths() const;
  // Throws where the cell is not all there, or the symmetry is not known to be P 1.
  [[nodiscard]] CartesianAxes cartesian_axes(std::string_view file) const;

 private:
  void check_symmetry(std::string_view file) const;

  std::map<std::string, Rational> numbers_;  // by the end of their names, "length_a"
  std::vector<std::string> groups_, operations_;
};

}  // namespace flowcert::io
