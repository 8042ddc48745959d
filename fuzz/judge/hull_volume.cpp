// The hull is cut into pyramids: their bases are the facets, and their common apex is the first point.
#include "fuzz/judge/hull_volume.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>

namespace flowcert::judge {

namespace {

using oracle::Point;
using oracle::Rational;
using Places = std::vector<std::size_t>;

// The points on a plane that has all others on its negative side, or none if it does not.
std::optional<Places> facet_of(const std::vector<Point>& points, const Point& on_plane, const Point& normal) {
  Places facet;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const int side = oracle::dot(normal, oracle::minus(points[k], on_plane)).sign();
    if (side > 0) return std::nullopt;
    if (side == 0) facet.push_back(k);
  }
  return facet;
}

// The facets of the hull, each with a normal that points outwards.
std::map<Places, Point> facets_of(const std::vector<Point>& points) {
  std::map<Places, Point> facets;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        const Point a = oracle::minus(points[j], points[i]), b = oracle::minus(points[k], points[i]);
        for (const Point& normal : {oracle::cross(a, b), oracle::cross(b, a)}) {
          if (normal == Point{}) continue;
          if (const auto facet = facet_of(points, points[i], normal)) facets.emplace(*facet, normal);
        }
      }
    }
  }
  return facets;
}

// Twice the area of the convex hull of these points of a plane, as a normal vector. The sum is over the edges ab of
// that hull: all other points are on their left, or between a and b.
Point doubled_area(const std::vector<Point>& points, const Point& normal) {
  Point sum;
  for (const Point& a : points) {
    for (const Point& b : points) {
      const Point ab = oracle::minus(b, a);
      const auto is_left_or_between = [&](const Point& c) {
        const Point ac = oracle::minus(c, a);
        const int side = oracle::dot(normal, oracle::cross(ab, ac)).sign();
        const Rational along = oracle::dot(ab, ac);
        return side > 0 || (side == 0 && along >= 0 && along <= oracle::dot(ab, ab));
      };
      if (a == b || !std::ranges::all_of(points, is_left_or_between)) continue;
      sum = oracle::moved(sum, 1, oracle::cross(oracle::minus(a, points[0]), oracle::minus(b, points[0])));
    }
  }
  return sum;
}

}  // namespace

oracle::Rational oracle_hull_volume(const std::vector<oracle::Point>& points) {
  Rational sum = 0;
  if (oracle::affine_dimension(points) < 3) return sum;
  for (const auto& [places, normal] : facets_of(points)) {
    std::vector<Point> facet;
    for (const std::size_t k : places) facet.push_back(points[k]);
    sum += oracle::dot(doubled_area(facet, normal), oracle::minus(facet[0], points[0]));
  }
  return sum / 6;
}

}  // namespace flowcert::judge
