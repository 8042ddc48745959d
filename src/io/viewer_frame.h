// The frame in which a viewer page draws: the input's bounding box becomes a box within [-1, 1]^3, which it fits in its
// longest direction.
//
// Guarantees: positions are finite floats, whatever the scale of the input. They are for drawing alone.
#pragma once

#include <array>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/layer.h"

namespace flowcert::io {

class ViewerFrame {
 public:
  // What is unbounded is cut at the box [-kClip, kClip]^3.
  static constexpr double kClip = 3;

  explicit ViewerFrame(const PointSet& points);

  [[nodiscard]] const std::array<double, 3>& origin() const { return origin_; }
  [[nodiscard]] double unit() const { return unit_; }

  [[nodiscard]] std::array<double, 3> placed(const Point& point) const;
  [[nodiscard]] std::array<double, 3> placed(const RationalPoint& point) const;
  // A length, such as a radius.
  [[nodiscard]] double scaled(double length) const;

 private:
  std::array<double, 3> origin_{};
  double unit_ = 1;
};

}  // namespace flowcert::io
