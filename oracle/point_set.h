// The merged point set P, and what is nearest in it: sections 1 and 2 of the spec, and section 8's first meeting.
//
// Each question is answered by its definition, with a linear scan over all points or over all subsets of a contact
// set. Exact. The three virtual functions take most of the time for a large set or for many small ones.
// fast::PointSet (oracle/fast/) gives the same answers faster, and nothing here depends on it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/exact_geometry.h"

namespace oracle {

// Where points of a PointSet are in its `points`, ascending unless said otherwise.
using Places = std::vector<std::size_t>;

struct PointSet {
  // FC-IN-03. Throws std::invalid_argument for a coordinate that is not finite (FC-IN-01).
  explicit PointSet(const std::vector<std::array<double, 3>>& rows);
  PointSet(const PointSet&) = default;
  PointSet& operator=(const PointSet&) = default;
  virtual ~PointSet() = default;

  // The contact set C(x) of FC-DIST-01. Empty only for no points.
  virtual Places nearest_places(const Point& x) const;

  // The first t > 0 at which some point of P is as near to x + t * direction as p is, but was farther for smaller
  // t > 0 (FC-FLOW-01). Nothing iff there is no such t. p must have the largest inner product with the direction
  // among the points of C(x).
  virtual std::optional<Rational> first_meeting(std::size_t p, const Point& x, const Point& direction) const;

  // oracle::inner_circumcentre() of these points.
  virtual std::optional<Point> inner_circumcentre(const Places& simplex) const;

  std::size_t merged_duplicates = 0;
  std::vector<Point> points;       // distinct, by first appearance in the input
  std::vector<std::size_t> names;  // their class names, so ascending
};

// The places of the named classes.
Places places_of(const PointSet& set, const std::vector<std::size_t>& names);

// The contact set of x, by class names.
std::vector<std::size_t> contact_set(const PointSet& set, const Point& x);

// The point of conv C(x) nearest to x (FC-DIST-02). `contact` is C(x).
Point driver(const PointSet& set, const Places& contact, const Point& x);

}  // namespace oracle
