// The input of everything: a finite set of points in R^3, repeated points merged.
//
// Guarantees: exact. Coordinates are the doubles given, -0.0 becomes 0.0, nothing is rounded.
// Source: spec clauses FC-IN-01 to FC-IN-04.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace flowcert {

// A row of the input: the 0-based ordinal of a point among the file's points, before merging.
using PointId = std::uint32_t;

struct Point {
  double x = 0;
  double y = 0;
  double z = 0;

  [[nodiscard]] std::array<double, 3> coordinates() const { return {x, y, z}; }
  [[nodiscard]] bool is_finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
  friend bool operator==(const Point&, const Point&) = default;
};

// The input cannot be used. what() is one line that says why; for input from a file it names the file and the line.
class InvalidInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class PointSet {
 public:
  PointSet() = default;

  // Merges repeated rows. Throws InvalidInput for a coordinate that is NaN or infinite, and for more than
  // 2^31 - 2 rows. left_out: rows of a file that a reader left out, counted from 0, ascending. O(n log n).
  explicit PointSet(std::span<const Point> rows, std::vector<std::size_t> left_out = {});

  // Rows given, before merging.
  [[nodiscard]] std::size_t row_count() const { return class_of_row_.size(); }
  // Rows that merging removed.
  [[nodiscard]] std::size_t merged_duplicates() const { return row_count() - size(); }

  // For headers of outputs. They are not among the rows given, and ids do not count them.
  [[nodiscard]] const std::vector<std::size_t>& left_out() const { return left_out_; }

  // Distinct points. Place k in points() is called the point's *ordinal*; ordinals ascend with names.
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  [[nodiscard]] const Point& operator[](std::size_t ordinal) const { return points_[ordinal]; }

  // The name of the class at an ordinal: its smallest row.
  [[nodiscard]] PointId name(std::size_t ordinal) const { return names_[ordinal]; }
  // The ordinal of the class that a row belongs to.
  [[nodiscard]] std::size_t ordinal_of_row(PointId row) const {
    return merged_duplicates() == 0 ? row : class_of_row_[row];  // without a miss of the cache, mostly
  }
  // The point that a row has.
  [[nodiscard]] const Point& at_row(PointId row) const { return points_[ordinal_of_row(row)]; }

  // Prefetches the points of the first four of these rows: a sphere is computed from these.
  [[gnu::always_inline]] void prefetch(std::span<const PointId> rows) const {
    for (const PointId row : rows.first(std::min<std::size_t>(rows.size(), 4))) __builtin_prefetch(&at_row(row));
  }

  // The classes of more than one row, each ascending, ordered by name. O(row_count()).
  [[nodiscard]] std::vector<std::vector<PointId>> repeated_classes() const;

 private:
  std::vector<Point> points_;
  std::vector<PointId> names_;
  std::vector<std::uint32_t> class_of_row_;
  std::vector<std::size_t> left_out_;
};

// The names of the rows' classes, ascending, each once.
[[nodiscard]] std::vector<PointId> class_names(const PointSet& points, std::span<const PointId> rows);

}  // namespace flowcert
