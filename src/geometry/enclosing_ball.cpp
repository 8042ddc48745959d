#include "geometry/enclosing_ball.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Min_sphere_annulus_d_traits_3.h>
#include <CGAL/Min_sphere_d.h>

#include <vector>

#include "geometry/contract.h"

namespace flowcert::geometry {

namespace {

using Kernel = CGAL::Cartesian<CGAL::Gmpq>;
using Ball = CGAL::Min_sphere_d<CGAL::Min_sphere_annulus_d_traits_3<Kernel>>;

Rational to_rational(const CGAL::Gmpq& value) { return Rational(value.mpq()); }

}  // namespace

RationalPoint enclosing_ball_center(std::span<const Point> points) {
  FLOWCERT_REQUIRES(!points.empty());
  std::vector<Kernel::Point_3> positions;
  for (const Point& p : points) positions.emplace_back(p.x, p.y, p.z);
  const Ball ball(positions.begin(), positions.end());
  const Kernel::Point_3 center = ball.center();
  return {to_rational(center.x()), to_rational(center.y()), to_rational(center.z())};
}

}  // namespace flowcert::geometry
