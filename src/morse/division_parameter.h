// Where the points of a division lie on their Voronoi edges, as one number each.
//
// The parameter of a point x on the Voronoi edge of a polygon with the samples p0, p1, q is <x - p0, n>, where
// n = (p1-p0) x (q-p0): six times the volume that the pyramid with base p0 p1 q and apex x has on the side to which n
// points. Guarantees: these are rational functions of the samples alone, over any number type. A ray through a facet
// maps one parameter to another by a quotient of linear functions, so that no position is needed.
//
// Names in all of them, for a facet with the samples p0, p1 and the midpoint m: e = p1-p0, d = q-p0, h = <q-p0, q-p1>,
// n = e x d. A point x with the parameter r has 2 |n|^2 (x-m) = h (n x e) + 2 r n. With D = det(e, d, d') and
// G = |e|^2 <d,d'> - <e,d> <e,d'>: <n x e, n'> = -|e|^2 D, <n, n'> = G, <n x e, q'-m> = G and <n, q'-m> = D.
#pragma once

#include "geometry/vector3.h"
#include "morse/layer.h"

namespace flowcert::morse {

// A facet with two of its polygons, whose apexes are q and q'.
template <class Number>
struct ApexPair {
  ApexPair(const Vector3<Number>& e, const Vector3<Number>& d, const Vector3<Number>& d_other)
      : length(dot(e, e)), along(dot(e, d)) {
    const Number along_other = dot(e, d_other);
    height = dot(d, d) - along;
    height_other = dot(d_other, d_other) - along_other;
    det = dot(cross(e, d), d_other);
    gram = length * dot(d, d_other) - along * along_other;
  }

  Number length;  // |e|^2
  Number along;   // <e,d>
  Number height, height_other;
  Number det, gram;
};

// The ray from m through the point with the parameter r on the Voronoi edge of q meets that of q' at <num, den> =
// num / den. (It meets the bisector of q' at m + h' (x-m) / (2 <x-m, q'-m>).)
template <class Number>
struct Quotient {
  Number num, den;
};
template <class Number>
[[nodiscard]] Quotient<Number> crossed_parameter(const ApexPair<Number>& pair, const Number& r) {
  const Number twice = r + r;
  const Number den = pair.height * pair.gram + twice * pair.det;
  return {pair.height_other * (twice * pair.gram - pair.height * pair.length * pair.det), den + den};
}

// The Voronoi vertex of p0, p1, q, q' on the Voronoi edge of q. It solves 2 <x-m, q'-m> = h'.
template <class Number>
[[nodiscard]] Quotient<Number> vertex_parameter(const ApexPair<Number>& pair, const Vector3<Number>& d) {
  const Number square = pair.length * dot(d, d) - pair.along * pair.along;
  return {square * pair.height_other - pair.height * pair.gram, pair.det + pair.det};
}

// x - p0
template <class Number>
[[nodiscard]] Vector3<Number> offset_of_parameter(const Vector3<Number>& e, const Vector3<Number>& d, const Number& r) {
  const Vector3<Number> n = cross(e, d);
  const Number half = Number(1) / Number(2), scale = Number(1) / dot(n, n);
  const Number height = dot(d, d) - dot(e, d);
  return half * e + Number(half * height * scale) * cross(n, e) + Number(r * scale) * n;
}

}  // namespace flowcert::morse
