// Circumcentres of simplices, and the side of a point in regard to the smallest sphere through the vertices of one.
#pragma once

#include "points.h"

using Simplex = std::array<Id, 4>;  // one to four ids, then kNone

// The circumcentre in the affine hull of the simplex is v[0] + numerator / (2 denominator). The denominator is the
// volume for four vertices, and positive for fewer.
template <class N>
struct Circumcenter {
  Vector<N> numerator;
  N denominator;
};
template <class N>
Circumcenter<N> circumcenter(const Points& points, const Simplex& v) {
  if (v[1] == kNone) return {{}, N{1}};
  const auto a = points.vector<N>(v[0], v[1]);
  if (v[2] == kNone) return {a, N{1}};
  const auto b = points.vector<N>(v[0], v[2]), ab = cross(a, b);
  if (v[3] == kNone) return {cross(b, ab) * dot(a, a) + cross(ab, a) * dot(b, b), dot(ab, ab)};
  const auto c = points.vector<N>(v[0], v[3]);
  return {cross(b, c) * dot(a, a) + cross(c, a) * dot(b, b) + ab * dot(c, c), dot(ab, c)};
}

// Negative, zero or positive as x is inside, on or outside, if the denominator is positive.
inline int side_of_sphere(const Points& points, const Simplex& v, Id x) {
  return points.sign([&]<class N>() {
    const auto [numerator, denominator] = circumcenter<N>(points, v);
    const auto y = points.vector<N>(v[0], x);
    return denominator * dot(y, y) - dot(numerator, y);
  });
}
