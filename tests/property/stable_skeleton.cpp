// How the header's promises are kept.
#include "tests/property/stable_skeleton.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/property/oracle_pieces.h"

namespace flowcert::property {
namespace {

using oracle::Point;

const Point& point_of(const oracle::PointSet& set, std::size_t name) {
  return set.points[oracle::places_of(set, {name}).front()];
}

Point middle(const Point& a, const Point& b) { return oracle::moved(a, Rational(1, 2), oracle::minus(b, a)); }

// Three corners in a row of a convex polygon need not span its plane, but some do.
Point normal_of(const std::vector<Point>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Point normal = oracle::cross(oracle::minus(corners[1], corners[0]), oracle::minus(corners[i], corners[0]));
    if (normal != Point{}) return normal;
  }
  return {};
}

// Whether m is beyond the side from corner i to the next. Rays towards m leave the sector there.
bool is_exit(const std::vector<Point>& corners, const Point& normal, const Point& m, std::size_t i) {
  const Point& a = corners[i % corners.size()];
  const Point side = oracle::minus(corners[(i + 1) % corners.size()], a);
  return oracle::dot(normal, oracle::cross(side, oracle::minus(m, a))) < 0;
}

class Conversion {
 public:
  explicit Conversion(const oracle::PointSet& set) : set_(set) {}

  void add_point(const Point& x) {
    if (!seen_.insert(x).second) return;
    const std::vector<std::size_t> contact = oracle::contact_set(set_, x);
    const bool is_vertex = oracle::affine_dimension(oracle::select(set_.points, oracle::places_of(set_, contact))) == 3;
    result_.has_vertex = result_.has_vertex || is_vertex;
    result_.points.push_back({x, contact});
  }

  void add(const BackwardSegment<>& s) {
    result_.segments.push_back(to_oracle(s));
    add_point(s.front.position);
    if (s.back_kind == BackKind::kEdge || s.back_kind == BackKind::kVertex) add_point(s.back.position);
  }

  void add(const BackwardInterval<>& i) {
    result_.intervals.push_back(to_oracle(i));
    add_point(i.front.position);
    if (!i.back_is_stationary) add_point(i.back.position);
  }

  void add(const Region<>& s) {
    result_.sectors.push_back(to_oracle(s));
    std::vector<Point> corners;
    for (const Corner<>& corner : s.corners) corners.push_back(corner.position);
    const std::size_t count = corners.size();
    const Point m = middle(point_of(set_, s.samples[0]), point_of(set_, s.samples[1]));
    const Point normal = normal_of(corners);
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_exit(corners, normal, m, i)) continue;
      const auto [a, b] = std::minmax(corners[i], corners[(i + 1) % count]);
      result_.crossed.push_back({oracle::contact_set(set_, middle(a, b)), a, b});
      if (is_exit(corners, normal, m, i + 1)) add_point(corners[(i + 1) % count]);
    }
  }

  oracle::StableSet sorted() && {
    std::sort(result_.points.begin(), result_.points.end());
    std::sort(result_.segments.begin(), result_.segments.end());
    std::sort(result_.intervals.begin(), result_.intervals.end());
    std::sort(result_.crossed.begin(), result_.crossed.end());
    std::sort(result_.sectors.begin(), result_.sectors.end());
    return std::move(result_);
  }

 private:
  const oracle::PointSet& set_;
  std::set<Point> seen_;
  oracle::StableSet result_;
};

}  // namespace

oracle::StableSet skeleton_of(const oracle::PointSet& set, const oracle::StationaryPoint& z, const StableSet<>& fast) {
  Conversion conversion(set);
  conversion.add_point(z.center);
  for (const BackwardSegment<>& s : fast.segments) conversion.add(s);
  for (const BackwardInterval<>& i : fast.intervals) conversion.add(i);
  for (const Region<>& s : fast.sectors) conversion.add(s);
  return std::move(conversion).sorted();
}

}  // namespace flowcert::property
