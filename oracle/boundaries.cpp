// Boundaries. FC-CHAIN-01 and 02 are one rule: a backward segment in the facet of p0p1 whose back y is no critical
// point is replaced by a path from p0 to p1 along edges that lead to y (FC-STAB-03), each with what is below it. Inside
// a Voronoi edge these are the other edges of its polygon (FC-STAB-06), and there is one path. Paths differ by cycles
// of edges that lead to y, so that each choice at each place adds a sum of such cycles, with what is below them. The
// edges that lead to the index-2 point itself are those of its polygon, and its boundary is the only cycle of these.
//
// What is above an edge. A chain of segments is followed with the flow. It leads through facets alone, so nothing that
// runs along a Voronoi edge is followed. An open interval of a Voronoi edge fans out in a facet, as in
// unstable_surface.cpp, and a single point has its own ray. Where they come to the midpoint of an edge that is regular
// stationary, all that it leads to is followed as well (FC-CHAIN-02). d grows on the way, so nothing is looked at
// beyond the death.
#include "oracle/boundaries.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "oracle/orbit.h"
#include "oracle/stable_set.h"
#include "oracle/unstable_set.h"

namespace oracle {

namespace {

// ---- Boundaries ----

class Below {
 public:
  Below(const PointSet& set, const Point& x) : set_(set) { add_segments(x); }

  // A chain to each sample of C(y), from the first of them, along edges that lead to y. Edges that close a cycle give
  // this to `cycles`, after those of what is below.
  const std::map<std::size_t, Chain>& walks(const Point& y) {
    const auto [known, is_new] = walks_.try_emplace(y);
    std::map<std::size_t, Chain>& walk = known->second;
    if (!is_new) return walk;
    std::vector<std::pair<std::array<std::size_t, 2>, Chain>> edges;
    for (const BackwardSegment& segment : leading_to_[y]) edges.emplace_back(segment.samples, below(segment));
    walk[edges.at(0).first[0]] = {};
    for (std::size_t before = 0; before != edges.size();) {
      before = edges.size();
      std::erase_if(edges, [&](const auto& edge) {
        const auto& [samples, chain] = edge;
        const auto a = walk.find(samples[0]), b = walk.find(samples[1]);
        if (a == walk.end() && b == walk.end()) return false;
        if (a == walk.end()) walk[samples[0]] = sum(b->second, chain);
        if (b == walk.end()) walk[samples[1]] = sum(a->second, chain);
        if (a != walk.end() && b != walk.end()) cycles.push_back(sum(sum(a->second, b->second), chain));
        return true;
      });
    }
    if (!edges.empty()) throw std::logic_error("the edges that lead to a point connect its samples");
    return walk;
  }

  std::vector<Chain> cycles;

 private:
  void add_segments(const Point& y) {
    for (const BackwardSegment& segment : stable_set(set_, y).segments) {
      if (!segment.front.at_infinity) leading_to_[segment.front.position].push_back(segment);
    }
  }
  Chain below(const BackwardSegment& segment) {
    const auto& [p0, p1] = segment.samples;
    if (segment.back_kind == BackKind::kCritical) return {{p0, p1}};
    const Point& y = segment.back.position;
    if (segment.back_kind == BackKind::kRegular && !walks_.contains(y)) add_segments(y);
    const std::map<std::size_t, Chain>& walk = walks(y);
    return sum(walk.at(p0), walk.at(p1));
  }

  const PointSet& set_;
  std::map<Point, std::vector<BackwardSegment>> leading_to_;
  std::map<Point, std::map<std::size_t, Chain>> walks_;
};

// ---- What is above an edge ----

// The samples that are nearest to a corner. For a corner at infinity, those that the ray from p meets first.
Places nearest_to(const PointSet& set, std::size_t p, const Corner& corner) {
  if (!corner.at_infinity) return set.nearest_places(corner.position);
  const auto meeting = set.first_meeting(p, set.points[p], corner.position);
  return meeting ? set.nearest_places(moved(set.points[p], *meeting, corner.position)) : Places{};
}

// in_cell(), with bisectors of those samples alone that are nearest to some corner. The cell is convex, so it has a
// region whose corners it has.
std::vector<Corner> part_in_cell(const PointSet& set, std::size_t place, const std::vector<Corner>& region) {
  PointSet near({});
  near.points = {set.points[place]};
  std::set<std::size_t> known = {place};
  std::set<Corner> seen;
  for (std::size_t before = 0; before != near.points.size();) {
    before = near.points.size();
    for (const Corner& corner : in_cell(near, 0, region)) {
      if (!seen.insert(corner).second) continue;
      for (const std::size_t q : nearest_to(set, place, corner)) {
        if (known.insert(q).second) near.points.push_back(set.points[q]);
      }
    }
  }
  return in_cell(near, 0, region);
}

class Above {
 public:
  Above(const PointSet& set, const Rational& death) : set_(set), death_(death) {}

  // All that leaves a stationary point through the facet that it is in.
  void add_root(const StationaryPoint& y) {
    const Places face = face_of(set_, y);
    const std::vector<Point> contact = select(set_.points, places_of(set_, y.contact));
    for (const auto& [from, to] : free_directions(contact, set_.points[face[0]], set_.points[face[1]]).arcs) {
      add_fan(face, {}, y.center, from, to);
    }
  }

  std::vector<StationaryPoint> saddles;

 private:
  // The open fan of rays from the midpoint of an edge between two directions, from the Voronoi edge of a polygon. They
  // leave the facet through sides that lie on no ray.
  void add_fan(const Places& edge, const Places& polygon, const Point& m, const Point& from, const Point& to) {
    const auto ray = [](const Point& way) { return Corner(as_direction(way), true); };
    const std::vector<Corner> part = part_in_cell(set_, edge[0], {m, ray(from), ray(to)});
    for (const auto& [a, b] : sides_of(part)) {
      if (!a.at_infinity) add_point(a.position);
      if (a == b || (a.at_infinity && b.at_infinity) || in_line(a, m, b)) continue;
      const Places contact = set_.nearest_places(between(a, b));
      if (contact != polygon) add_interval(contact, a, b);
    }
  }

  void add_interval(const Places& polygon, const Corner& a, const Corner& b) {
    const std::vector<Point> corners = select(set_.points, polygon);
    const Point z = circumcentre(spanning_subset(corners))->center;
    if (squared_distance(z, corners[0]) >= death_) return;
    if (face_dimension(corners, z)) {
      if (dot(way_to(a, z), way_to(b, z)) < 0) add_point(z);
      return;
    }
    const auto [p0, p1] = obtuse_edge(set_, polygon);
    const Point m = midpoint(set_.points[p0], set_.points[p1]);
    add_fan({p0, p1}, polygon, m, way_to(a, m), way_to(b, m));
  }

  void add_point(const Point& x) {
    if (!points_.insert(x).second) return;
    const Places contact = set_.nearest_places(x);
    if (squared_distance(x, set_.points[contact[0]]) >= death_) return;
    const Point from = driver(set_, contact, x), way = minus(x, from);
    if (from == x) return add_stationary(stationary_point(set_, x, contact));
    const Places crossed = crossed_places(set_, contact, way);
    if (crossed.size() != 2) return;
    const auto meeting = set_.first_meeting(crossed[0], x, way);
    if (meeting) add_point(moved(x, *meeting, way));
  }

  void add_stationary(const StationaryPoint& y) {
    if (y.is_critical() && y.hull_dimension == 2) saddles.push_back(y);
    if (!y.is_critical() && y.face_dimension == 1) add_root(y);
  }

  const PointSet& set_;
  const Rational& death_;
  std::set<Point> points_;
};

}  // namespace

Chain sum(Chain a, const Chain& b) {
  for (const Contact& edge : b) {
    if (a.erase(edge) == 0) a.insert(edge);
  }
  return a;
}

Boundary boundary(const PointSet& set, const StationaryPoint& x) {
  Below below(set, x.center);
  below.walks(x.center);
  const Chain chain = below.cycles.back();
  below.cycles.pop_back();
  return {chain, below.cycles};
}

std::vector<StationaryPoint> saddles_above(const PointSet& set, const std::vector<StationaryPoint>& edges,
                                           const Rational& death) {
  Above above(set, death);
  for (const StationaryPoint& edge : edges) above.add_root(edge);
  return above.saddles;
}

bool is_sum_of(Chain chain, const std::vector<Chain>& cycles) {
  std::map<Contact, Chain> kept;  // by their last edges
  const auto reduce = [&](Chain& column) {
    while (!column.empty() && kept.contains(*column.rbegin())) column = sum(column, kept.at(*column.rbegin()));
  };
  for (Chain cycle : cycles) {
    reduce(cycle);
    if (!cycle.empty()) kept[*cycle.rbegin()] = cycle;
  }
  reduce(chain);
  return chain.empty();
}

}  // namespace oracle
