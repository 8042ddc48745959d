// What CGAL's triangulation wants of a kernel: points, and functions that give the signs of delaunay_signs.h.
//
// Guarantees: signs are those of CGAL's exact kernels, so that the triangulation is theirs, with the same order of its
// cells. CGAL's intervals are not used.
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>

#include "flowcert/point_set.h"
#include "voronoi/delaunay_signs.h"
#include "voronoi/layer.h"

namespace flowcert::voronoi {

class DelaunayKernel {
 public:
  // A point as CGAL reads it.
  struct Point_3 {
    Point at;

    [[nodiscard]] double x() const { return at.x; }
    [[nodiscard]] double y() const { return at.y; }
    [[nodiscard]] double z() const { return at.z; }
  };
  struct Construct_point_3 {
    const Point_3& operator()(const Point_3& p) const { return p; }
  };
  struct Compare_xyz_3 {
    CGAL::Comparison_result operator()(const Point_3& p, const Point_3& q) const {
      const auto order = p.at.coordinates() <=> q.at.coordinates();
      return order < 0 ? CGAL::SMALLER : order > 0 ? CGAL::LARGER : CGAL::EQUAL;
    }
  };
  struct Orientation_3 {
    DelaunaySigns signs;
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const {
      return static_cast<CGAL::Orientation>(signs.orientation(p.at, q.at, r.at, s.at));
    }
  };
  struct Side_of_oriented_sphere_3 {
    DelaunaySigns signs;
    CGAL::Oriented_side operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s,
                                   const Point_3& t) const {
      return static_cast<CGAL::Oriented_side>(signs.inside_sphere(p.at, q.at, r.at, s.at, t.at));
    }
  };
  struct Coplanar_orientation_3 {
    DelaunaySigns signs;
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r) const {
      return static_cast<CGAL::Orientation>(signs.turn(p.at, q.at, r.at));
    }
  };
  struct Coplanar_side_of_bounded_circle_3 {
    DelaunaySigns signs;
    CGAL::Bounded_side operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& t) const {
      return static_cast<CGAL::Bounded_side>(signs.inside_circle(p.at, q.at, r.at, t.at));
    }
  };

  // CGAL wants these types to be there. The triangulation makes none of them.
  using Segment_3 = CGAL::Simple_cartesian<double>::Segment_3;
  using Triangle_3 = CGAL::Simple_cartesian<double>::Triangle_3;
  using Tetrahedron_3 = CGAL::Simple_cartesian<double>::Tetrahedron_3;
  using Line_3 = CGAL::Simple_cartesian<double>::Line_3;
  using Ray_3 = CGAL::Simple_cartesian<double>::Ray_3;
  using Object_3 = CGAL::Simple_cartesian<double>::Object_3;

  DelaunayKernel() = default;
  explicit DelaunayKernel(const DelaunaySigns& signs) : signs_(signs) {}

  [[nodiscard]] Construct_point_3 construct_point_3_object() const { return {}; }
  [[nodiscard]] Compare_xyz_3 compare_xyz_3_object() const { return {}; }
  [[nodiscard]] Orientation_3 orientation_3_object() const { return {signs_}; }
  [[nodiscard]] Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {signs_}; }
  [[nodiscard]] Coplanar_orientation_3 coplanar_orientation_3_object() const { return {signs_}; }
  [[nodiscard]] Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const { return {signs_}; }

 private:
  DelaunaySigns signs_;
};

}  // namespace flowcert::voronoi

// A walk by rounded orientations comes first, as with CGAL's own kernel. Exact ones begin where it ends.
template <>
struct CGAL::Triangulation_structural_filtering_traits<flowcert::voronoi::DelaunayKernel> {
  using Use_structural_filtering_tag = CGAL::Tag_true;
};
