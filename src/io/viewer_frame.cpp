#include "io/viewer_frame.h"

#include <algorithm>
#include <cmath>

#include "flowcert/sphere.h"

namespace flowcert::io {

namespace {

// Floats hold this, and so do the squares that graphics computes of it.
constexpr double kFarthest = 1e15;

double clamped(double value) { return std::isnan(value) ? 0 : std::clamp(value, -kFarthest, kFarthest); }

}  // namespace

ViewerFrame::ViewerFrame(const PointSet& points) {
  if (points.empty()) return;
  std::array<double, 3> low, high;
  low = high = {points[0].x, points[0].y, points[0].z};
  for (const Point& point : points.points()) {
    const std::array<double, 3> row = point.coordinates();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], row[axis]);
      high[axis] = std::max(high[axis], row[axis]);
    }
  }
  double half = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Halves are taken first, so that nothing overflows. The half of the least double is 0, so that stays whole.
    origin_[axis] = low[axis] / 2 + high[axis] / 2;
    const double side = high[axis] - low[axis];
    half = std::max(half, !std::isfinite(side) ? high[axis] / 2 - low[axis] / 2 : side / 2 > 0 ? side / 2 : side);
  }
  if (half > 0) unit_ = half;
}

std::array<double, 3> ViewerFrame::placed(const Point& point) const {
  const std::array<double, 3> row = point.coordinates();
  std::array<double, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Halves do not overflow where the frame is large, and would underflow where it is small.
    at[axis] =
        clamped(unit_ > 1 ? (row[axis] / 2 - origin_[axis] / 2) / (unit_ / 2) : (row[axis] - origin_[axis]) / unit_);
  }
  return at;
}

std::array<double, 3> ViewerFrame::placed(const RationalPoint& point) const { return placed(rounded_point(point)); }

double ViewerFrame::scaled(double length) const { return clamped(length / unit_); }

}  // namespace flowcert::io
