// Where a ray leaves a Voronoi facet. The ray goes from the midpoint m of the facet's Delaunay edge through a point x
// of the facet. The search over the facet's ring is binary or linear (paper, section 4).
//
// Guarantees: exact; both searches find the same. For n elements of the ring, the binary one takes ceil(log2 n) signs
// from a start on the boundary (Proposition 1; duplicate vertices were merged when the ring was made), and at most
// twice that and a few from a start inside. The linear one takes up to n, and up to 2 n from a start inside.
#pragma once

#include <cstddef>

#include "flow/kernels/kernel.h"
#include "flowcert/orbit.h"
#include "geometry/contract.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::flow {

// On which side of the ray from the facet's midpoint through x an element of its ring lies: positive if it lies
// counterclockwise of the ray. centers(cluster) is the constructed point of a cluster, which Centers keeps;
// centers.point(v) is a sample.
template <ConstructsPoints Kernel, class Centers>
class RaySides {
 public:
  using MovingPoint = typename MovingPointOf<Kernel>::Type;

  RaySides(Kernel& kernel, Centers& centers, const FacetRing& ring, MovingPoint& x)
      : kernel_(kernel), centers_(centers), ring_(ring), x_(x) {}

  [[nodiscard]] Sign of_vertex(std::size_t k) const {
    if constexpr (HasMovingPoint<Kernel>) {
      return x_.sign_of_order(centers_.point(ring_.pieces[ring_.before(k)].apex), centers_.point(ring_.pieces[k].apex));
    } else {
      return kernel_.sign(SideOfRay{x_.number(), centers_.point(ring_.facet.v0), centers_.point(ring_.facet.v1),
                                    centers_(ring_.pieces[k].vertex)});
    }
  }
  [[nodiscard]] Sign of(std::size_t k) const {
    if (ring_.pieces[k].vertex != kNoCell) return of_vertex(k);
    const RingElement e = ring_.element(k);
    return times(e.factor, x_.sign_of_ray_at_infinity(centers_.point(e.apex)));
  }

  static Sign times(int factor, Sign sign) { return static_cast<Sign>(factor * static_cast<int>(sign)); }

 private:
  Kernel& kernel_;
  Centers& centers_;
  const FacetRing& ring_;
  MovingPoint& x_;
};

template <ConstructsPoints Kernel, class Centers>
class RingQuery {
 public:
  using MovingPoint = typename MovingPointOf<Kernel>::Type;

  RingQuery(Kernel& kernel, Centers& centers, const FacetRing& ring, MovingPoint& x)
      : kernel_(kernel), centers_(centers), ring_(ring), x_(x), n_(ring.size()), sides_(kernel, centers, ring, x) {}

  // What the ray reaches: an element or a piece, with its place in the ring, or infinity.
  struct Exit {
    enum class Kind : std::uint8_t { kInfinity, kElement, kPiece } kind = Kind::kInfinity;
    std::size_t at = 0;
  };

  // x lies on the boundary, and the ray enters the facet there. Counterclockwise from x on, the elements first lie
  // clockwise of the ray, then counterclockwise of it. The first one that does not lie clockwise is at the exit.
  // `first` is the element that follows x. `count` is the number of elements from there up to x again, without the
  // last one, which is known to lie counterclockwise.
  [[nodiscard]] Exit from_boundary(FacetSearch search, std::size_t first, std::size_t count) {
    std::size_t low = 0, high = count;  // all before low are clockwise; high is not, or the end
    while (low < high) {
      const std::size_t probe = search == FacetSearch::kBinary ? (low + high) / 2 : low;
      const Sign sign = side(first + probe);
      if (sign == Sign::kZero) return at_element(first + probe);
      if (sign == Sign::kNegative) {
        low = probe + 1;
      } else {
        high = probe;
      }
    }
    return before_element(first + low);
  }

  // x lies inside.
  [[nodiscard]] Exit from_inside(FacetSearch search) {
    if (n_ == 0) return {};
    if (search == FacetSearch::kBinary) {
      for (std::size_t k = 0; k < n_; ++k) {
        if (ring_.pieces[k].vertex != kNoCell) return by_angle(k);
      }
    }
    return by_all_signs();
  }

 private:
  // Places are below 2 n.
  [[nodiscard]] std::size_t around(std::size_t k) const { return k < n_ ? k : k - n_; }

  [[nodiscard]] Exit at_element(std::size_t k) const {
    if (ring_.pieces[around(k)].vertex == kNoCell) return {};
    return {Exit::Kind::kElement, around(k)};
  }
  [[nodiscard]] Exit before_element(std::size_t k) const {
    const std::size_t piece = ring_.before(around(k));
    if (!ring_.pieces[piece].is_finite()) return {};
    return {Exit::Kind::kPiece, piece};
  }

  [[nodiscard]] Sign side(std::size_t k) const { return sides_.of(around(k)); }

  // The side of the line from x to the vertex `reference`: positive for an element counterclockwise of it.
  [[nodiscard]] Sign side_of_reference(PointNumber reference, std::size_t k) {
    const RingElement e = ring_.element(around(k));
    const Point &p0 = centers_.point(ring_.facet.v0), &p1 = centers_.point(ring_.facet.v1);
    if (e.vertex != kNoCell) return kernel_.sign(AroundStart{x_.number(), p0, p1, reference, centers_(e.vertex)});
    return RaySides<Kernel, Centers>::times(
        e.factor, kernel_.sign(RayAroundStart{x_.number(), p0, p1, reference, centers_.point(e.apex)}));
  }

  // Whether c lies on the ray and beyond x. It must lie on the line of the ray; only the filter checks that, so that
  // no point becomes exact by it.
  [[nodiscard]] bool is_beyond(PointNumber c) {
    const Point &p0 = centers_.point(ring_.facet.v0), &p1 = centers_.point(ring_.facet.v1);
    const PointNumber x = x_.number();
    FLOWCERT_REQUIRES(kernel_.sign_on_rung(SideOfRay{x, p0, p1, c}, KernelRung::kFilter).value_or(Sign::kZero) ==
                      Sign::kZero);
    return kernel_.sign(AlongRay{x, p0, p1, c}) == Sign::kPositive &&
           kernel_.sign(BeforePoint{x, p0, p1, c, c}) == Sign::kPositive;
  }

  // Goes around x from a reference vertex, and counts angles counterclockwise from it. One sign decides whether the
  // ray's angle lies in (0, pi), in (pi, 2 pi), or is 0 or pi. Two signs then decide whether an element comes before
  // the ray.
  [[nodiscard]] Exit by_angle(std::size_t reference) {
    const PointNumber start = centers_(ring_.pieces[reference].vertex);
    const Sign first = side(reference);
    if (first == Sign::kZero && is_beyond(start)) {
      return at_element(reference);
    }
    std::size_t low = 1, high = n_;  // counted from the reference
    while (low < high) {
      const std::size_t probe = (low + high) / 2;
      const std::size_t k = reference + probe;
      bool is_before = false;
      if (first == Sign::kZero) {  // the ray's angle is pi
        const Sign turn = side_of_reference(start, k);
        if (turn == Sign::kZero) return at_element(k);
        is_before = turn == Sign::kPositive;
      } else {
        const Sign sign = side(k);
        const bool is_near = first == Sign::kNegative;  // the ray's angle is less than pi
        // The elements that decide lie on the same half turn from the reference as the ray.
        const Sign half = is_near ? Sign::kPositive : Sign::kNegative;
        if (sign == Sign::kZero) {
          if (side_of_reference(start, k) == half) return at_element(k);
          is_before = !is_near;
        } else if (is_near) {
          is_before = sign == Sign::kNegative && side_of_reference(start, k) == Sign::kPositive;
        } else {
          is_before = sign == Sign::kNegative || side_of_reference(start, k) != Sign::kNegative;
        }
      }
      (is_before ? low : high) = is_before ? probe + 1 : probe;
    }
    return before_element(reference + low);
  }

  // Looks for the change from clockwise to counterclockwise. If an element in between lies on the ray's line, the ray
  // leaves there. There is no change where the whole boundary is parallel to the ray.
  [[nodiscard]] Exit by_all_signs() {
    std::size_t clockwise = n_;  // the last one seen
    for (std::size_t k = 0; k < 2 * n_; ++k) {
      const Sign sign = side(k);
      if (sign == Sign::kNegative) clockwise = k;
      if (sign == Sign::kNegative || clockwise == n_) continue;
      return sign == Sign::kPositive ? before_element(k) : at_element(k);
    }
    return {};
  }

  Kernel& kernel_;
  Centers& centers_;
  const FacetRing& ring_;
  MovingPoint& x_;
  std::size_t n_;
  RaySides<Kernel, Centers> sides_;
};

}  // namespace flowcert::flow
