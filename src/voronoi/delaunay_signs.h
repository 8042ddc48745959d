// The signs that the triangulation asks for. Each comes from the first rung that knows it: the double filter, doubles
// that nothing was rounded in, and integers (geometry/predicates.h).
//
// Guarantees: exact for all finite doubles. There are no intervals and no directed rounding, which WebAssembly does not
// have.
#pragma once

#include <algorithm>

#include "flowcert/point_set.h"
#include "geometry/integer_grid.h"
#include "geometry/predicates.h"
#include "geometry/vector3.h"
#include "voronoi/layer.h"

namespace flowcert::voronoi {

class DelaunaySigns {
 public:
  // Asked of any points.
  DelaunaySigns() = default;
  // Asked of these points alone. Where they are on a coarse grid, as those of a lattice, ties are known in doubles.
  explicit DelaunaySigns(const PointSet& points) {
    const IntegerGrid grid(points.points());
    if (grid.fits_small()) reach_ = grid.exact_reach();
  }

  // The sign of det(q - p, r - p, s - p).
  [[nodiscard]] Sign orientation(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return sign(Orientation{p, q, r, s});
  }

  // Positive where t is inside the sphere of p, q, r and s, if these are positively oriented.
  [[nodiscard]] Sign inside_sphere(const Point& p, const Point& q, const Point& r, const Point& s,
                                   const Point& t) const {
    return opposite(sign(OutsideSphere{p, q, r, s, t}));
  }

  // Which way p, q and r turn in the first of the projections to xy, yz and xz where they turn at all. Zero iff they
  // are on one line.
  [[nodiscard]] Sign turn(const Point& p, const Point& q, const Point& r) const {
    Sign turn = plane_turn({p.x, p.y, 0}, {q.x, q.y, 0}, {r.x, r.y, 0});
    if (turn == Sign::kZero) turn = plane_turn({p.y, p.z, 0}, {q.y, q.z, 0}, {r.y, r.z, 0});
    if (turn == Sign::kZero) turn = plane_turn({p.x, p.z, 0}, {q.x, q.z, 0}, {r.x, r.z, 0});
    return turn;
  }

  // Positive where t is inside the circle of p, q and r, which are not on one line, and t is in their plane.
  [[nodiscard]] Sign inside_circle(const Point& p, const Point& q, const Point& r, const Point& t) const {
    if (t == p || t == q || t == r) return Sign::kZero;
    // A point that is not in the closed triangle is beyond one of its edges.
    const Sign outwards = opposite(turn(p, q, r));
    if (turn(p, q, t) == outwards) return opposite(sign(OutsideCircle{p, q, r, t}));
    if (turn(q, r, t) == outwards) return opposite(sign(OutsideCircle{q, r, p, t}));
    if (turn(r, p, t) == outwards) return opposite(sign(OutsideCircle{r, p, q, t}));
    return Sign::kPositive;
  }

 private:
  [[nodiscard]] static Sign opposite(Sign sign) { return static_cast<Sign>(-static_cast<int>(sign)); }

  // All three have z = 0. A fourth point above p makes it an orientation. Its height is on the grid of the points.
  [[nodiscard]] Sign plane_turn(const Point& p, const Point& q, const Point& r) const {
    if ((p.x == q.x && p.x == r.x) || (p.y == q.y && p.y == r.y)) return Sign::kZero;
    const double height = std::max({greatest_coordinate(p), greatest_coordinate(q), greatest_coordinate(r)});
    return sign(Orientation{p, q, r, {p.x, p.y, height}});
  }

  template <class Query>
  [[nodiscard]] Sign sign(const Query& query) const {
    if (const MaybeSign known = filtered_sign<Query>(query.vectors(vector_between<Point>))) return *known;
    return sign_beyond_filter(query);
  }
  template <class Query>
  [[nodiscard, gnu::noinline]] Sign sign_beyond_filter(const Query& query) const {
    const MaybeSign known = unrounded_sign<Query>(query.vectors(vector_between<Point>), reach_);
    return known ? *known : unfiltered_sign(query);
  }

  double reach_ = 0;
};

}  // namespace flowcert::voronoi
