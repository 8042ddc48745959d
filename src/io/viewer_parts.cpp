// zlib compresses, and Boost writes base64.
#include "io/viewer_parts.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

#include "flowcert/sphere.h"

namespace flowcert::io {

// ---- Arrays ----

namespace {

using Bytes = std::vector<unsigned char>;

template <typename Number>
Bytes planes_of(std::span<const Number> numbers) {
  static_assert(std::endian::native == std::endian::little, "the first plane has the lowest bytes");
  Bytes planes(numbers.size_bytes());
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  auto to = planes.begin();
  for (std::size_t plane = 0; plane < sizeof(Number); ++plane) {
    for (std::size_t i = 0; i < numbers.size(); ++i) *to++ = bytes[i * sizeof(Number) + plane];
  }
  return planes;
}

Bytes compressed(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes stream(size);
  if (compress2(stream.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::bad_alloc();
  }
  stream.resize(size);
  return stream;
}

std::string base64(Bytes bytes) {
  namespace iterators = boost::archive::iterators;
  using Digits = iterators::base64_from_binary<iterators::transform_width<Bytes::const_iterator, 6, 8>>;
  if (bytes.size() > std::numeric_limits<int>::max() / 2) {
    throw std::runtime_error("an array of this complex is too large for a page");
  }
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.resize(bytes.size() + padding);  // Boost would read beyond the end
  std::string text(Digits(bytes.cbegin()), Digits(bytes.cend()));
  return text.replace(text.size() - padding, padding, padding, '=');
}

template <typename Number>
Json blob_of(const char* type, std::span<const Number> numbers) {
  Json blob;
  blob["type"] = type;
  blob["count"] = numbers.size();
  blob["data"] = numbers.empty() ? "" : base64(compressed(planes_of(numbers)));
  return blob;
}

}  // namespace

Json viewer_blob(std::span<const double> numbers) { return blob_of("f64", numbers); }
Json viewer_blob(std::span<const float> numbers) { return blob_of("f32", numbers); }
Json viewer_blob(std::span<const std::uint32_t> numbers) { return blob_of("u32", numbers); }
Json viewer_blob(std::span<const std::uint8_t> numbers) { return blob_of("u8", numbers); }

// ---- The frame ----

namespace {

// Floats hold this, and so do the squares that graphics computes of it.
constexpr double kFarthest = 1e15;

double clamped(double value) { return std::isnan(value) ? 0 : std::clamp(value, -kFarthest, kFarthest); }

}  // namespace

ViewerFrame::ViewerFrame(std::span<const Point> points) {
  if (points.empty()) return;
  std::array<double, 3> low, high;
  low = high = {points[0].x, points[0].y, points[0].z};
  for (const Point& point : points) {
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
