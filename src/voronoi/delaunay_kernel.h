// The kernel of the triangulation: points in doubles, and the predicates of geometry/predicates.h, which the proofs are
// about.
//
// Guarantees: exact for all finite doubles. There are no intervals and no directed rounding, which WebAssembly does not
// have. Signs are CGAL's, so that the triangulation is the one of CGAL's own kernels.
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>

#include <compare>

#include "flowcert/point_set.h"
#include "geometry/predicates.h"
#include "voronoi/layer.h"

namespace flowcert::voronoi {

// A point as CGAL reads it.
struct DelaunayPoint {
  Point at;

  [[nodiscard]] double x() const { return at.x; }
  [[nodiscard]] double y() const { return at.y; }
  [[nodiscard]] double z() const { return at.z; }
};

class DelaunayKernel {
  // Has the types that CGAL wants to be there, and the triangulation never asks for.
  using Unused = CGAL::Simple_cartesian<double>;

 public:
  using Point_3 = DelaunayPoint;
  using Segment_3 = Unused::Segment_3;
  using Triangle_3 = Unused::Triangle_3;
  using Tetrahedron_3 = Unused::Tetrahedron_3;
  using Line_3 = Unused::Line_3;
  using Ray_3 = Unused::Ray_3;
  using Object_3 = Unused::Object_3;

  struct Construct_point_3 {
    const Point_3& operator()(const Point_3& p) const { return p; }
  };
  [[nodiscard]] Construct_point_3 construct_point_3_object() const { return {}; }

  struct Compute_x_3 {
    double operator()(const Point_3& p) const { return p.at.x; }
  };
  struct Compute_y_3 {
    double operator()(const Point_3& p) const { return p.at.y; }
  };
  struct Compute_z_3 {
    double operator()(const Point_3& p) const { return p.at.z; }
  };
  struct Less_x_3 {
    bool operator()(const Point_3& p, const Point_3& q) const { return p.at.x < q.at.x; }
  };
  struct Less_y_3 {
    bool operator()(const Point_3& p, const Point_3& q) const { return p.at.y < q.at.y; }
  };
  struct Less_z_3 {
    bool operator()(const Point_3& p, const Point_3& q) const { return p.at.z < q.at.z; }
  };
  [[nodiscard]] Compute_x_3 compute_x_3_object() const { return {}; }
  [[nodiscard]] Compute_y_3 compute_y_3_object() const { return {}; }
  [[nodiscard]] Compute_z_3 compute_z_3_object() const { return {}; }
  [[nodiscard]] Less_x_3 less_x_3_object() const { return {}; }
  [[nodiscard]] Less_y_3 less_y_3_object() const { return {}; }
  [[nodiscard]] Less_z_3 less_z_3_object() const { return {}; }

  struct Compare_xyz_3 {
    CGAL::Comparison_result operator()(const Point_3& p, const Point_3& q) const {
      if (p.at.x != q.at.x) return p.at.x < q.at.x ? CGAL::SMALLER : CGAL::LARGER;
      if (p.at.y != q.at.y) return p.at.y < q.at.y ? CGAL::SMALLER : CGAL::LARGER;
      if (p.at.z != q.at.z) return p.at.z < q.at.z ? CGAL::SMALLER : CGAL::LARGER;
      return CGAL::EQUAL;
    }
  };
  [[nodiscard]] Compare_xyz_3 compare_xyz_3_object() const { return {}; }

  struct Orientation_3 {
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const {
      return static_cast<CGAL::Orientation>(sign(Orientation{p.at, q.at, r.at, s.at}));
    }
  };
  [[nodiscard]] Orientation_3 orientation_3_object() const { return {}; }

  struct Side_of_oriented_sphere_3 {
    CGAL::Oriented_side operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s,
                                   const Point_3& t) const {
      return static_cast<CGAL::Oriented_side>(-static_cast<int>(sign(OutsideSphere{p.at, q.at, r.at, s.at, t.at})));
    }
  };
  [[nodiscard]] Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }

  struct Coplanar_orientation_3 {
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r) const {
      return coplanar_orientation(p.at, q.at, r.at);
    }
  };
  [[nodiscard]] Coplanar_orientation_3 coplanar_orientation_3_object() const { return {}; }

  // p, q and r are not on a line.
  struct Coplanar_side_of_bounded_circle_3 {
    CGAL::Bounded_side operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& t) const {
      return coplanar_side_of_circle(p.at, q.at, r.at, t.at);
    }
  };
  [[nodiscard]] Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const { return {}; }

 private:
  template <class Query>
  [[nodiscard]] static Sign sign(const Query& query) {
    if (const MaybeSign known = filtered_sign<Query>(query.vectors(vector_between<Point>))) return *known;
    return unfiltered_sign(query);
  }

  [[nodiscard]] static CGAL::Orientation coplanar_orientation(const Point& p, const Point& q, const Point& r);
  [[nodiscard]] static CGAL::Bounded_side coplanar_side_of_circle(const Point& p, const Point& q, const Point& r,
                                                                  const Point& t);
};

// The first of the projections xy, yz and xz in which the points are not on a line, as CGAL takes it. A fourth point
// above p makes the turn of a projection an orientation; its height is a coordinate, so that it is on the points' grid.
inline CGAL::Orientation DelaunayKernel::coplanar_orientation(const Point& p, const Point& q, const Point& r) {
  const double height = std::max({greatest_coordinate(p), greatest_coordinate(q), greatest_coordinate(r)});
  const auto turn = [height](double px, double py, double qx, double qy, double rx, double ry) {
    return sign(Orientation{Point{px, py, 0}, Point{qx, qy, 0}, Point{rx, ry, 0}, Point{px, py, height}});
  };
  Sign known = turn(p.x, p.y, q.x, q.y, r.x, r.y);
  if (known == Sign::kZero) known = turn(p.y, p.z, q.y, q.z, r.y, r.z);
  if (known == Sign::kZero) known = turn(p.x, p.z, q.x, q.z, r.x, r.z);
  return static_cast<CGAL::Orientation>(known);
}

// A point that is not in the closed triangle is beyond one of its edges.
inline CGAL::Bounded_side DelaunayKernel::coplanar_side_of_circle(const Point& p, const Point& q, const Point& r,
                                                                  const Point& t) {
  if (t == p || t == q || t == r) return CGAL::ON_BOUNDARY;
  const CGAL::Orientation inside = coplanar_orientation(p, q, r);
  const auto across = [&t](const Point& a, const Point& b, const Point& c) {
    return static_cast<CGAL::Bounded_side>(-static_cast<int>(sign(OutsideCircle{a, b, c, t})));
  };
  if (coplanar_orientation(p, q, t) == -inside) return across(p, q, r);
  if (coplanar_orientation(q, r, t) == -inside) return across(q, r, p);
  if (coplanar_orientation(r, p, t) == -inside) return across(r, p, q);
  return CGAL::ON_BOUNDED_SIDE;
}

}  // namespace flowcert::voronoi

// CGAL finds its way with rounded orientations first, as for its own kernel: what it finds is the same.
template <>
struct CGAL::Triangulation_structural_filtering_traits<flowcert::voronoi::DelaunayKernel> {
  using Use_structural_filtering_tag = CGAL::Tag_true;
};
