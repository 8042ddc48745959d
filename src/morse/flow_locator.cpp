#include "morse/flow_locator.h"

#include <algorithm>
#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "geometry/bounded_number.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "morse/bounded_divisions.h"
#include "morse/limit_partition.h"
#include "morse/polygon_turn.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;
using BoundedVector = Vector3<BoundedNumber>;

namespace {

namespace index = boost::geometry::index;
using SpatialPoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using SpatialEntry = std::pair<SpatialPoint, VertexIndex>;
using SampleTree = index::rtree<SpatialEntry, index::quadratic<16>>;

constexpr BoundedNumber kHalf{0.5, 0};

SpatialPoint spatial(const Point& p) { return {p.x, p.y, p.z}; }

// A Delaunay neighbour, and a cell that has both samples.
struct Neighbor {
  VertexIndex vertex;
  CellIndex cell;
};

// The Delaunay neighbours of each sample, side by side in memory. Cospherical samples may be neighbours by one
// triangulation and not by another.
class Neighborhoods {
 public:
  explicit Neighborhoods(const VoronoiDiagram& diagram) : first_(diagram.delaunay().points.size() + 1, 0) {
    struct Ordered {
      VertexIndex from;
      Neighbor to;
    };
    std::vector<Ordered> all;
    const CompactDelaunay& delaunay = diagram.delaunay();
    for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
      for (const VertexIndex v : delaunay.vertices(cell)) {
        for (const VertexIndex w : delaunay.vertices(cell)) {
          if (v != w) all.push_back({v, {w, cell}});
        }
      }
    }
    const auto key = [](const Ordered& one) { return std::pair(one.from, one.to.vertex); };
    std::ranges::sort(all, {}, key);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i > 0 && key(all[i - 1]) == key(all[i])) continue;
      ++first_[all[i].from + 1];
      neighbors_.push_back(all[i].to);
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  }

  [[nodiscard]] std::span<const Neighbor> of(VertexIndex v) const {
    return std::span(neighbors_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Neighbor> neighbors_;
};

// ---- Through which of several planes a ray leaves a convex set first ----

// A plane that a ray may leave a convex set through: at the parameter room / speed, if the speed is positive.
struct Wall {
  BoundedNumber room, speed;
};

// The wall that the ray meets first, and at which parameter. The bounds prove both.
struct Exit {
  std::size_t wall;
  BoundedNumber parameter;
};
enum class ExitKind : std::uint8_t { kThroughWall, kNowhere, kOpen };

// The ray starts on the inner side of all walls that it comes nearer to. So a wall that it does not come nearer to
// passes the same comparison, whatever room it has.
ExitKind first_exit(std::span<const Wall> walls, Exit& exit) {
  double most = 0;
  std::size_t best = walls.size();
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const double speed = walls[k].speed.value.high();
    if (!(speed > 0)) continue;
    const double rate = speed / walls[k].room.value.high();
    if (best < walls.size() && !(rate > most)) continue;
    most = rate, best = k;
  }
  if (best == walls.size()) {
    const bool is_sure = std::ranges::all_of(
        walls, [](const Wall& wall) { return geometry::decided_sign(wall.speed) == Sign::kNegative; });
    return is_sure ? ExitKind::kNowhere : ExitKind::kOpen;
  }
  const Wall& first = walls[best];
  if (geometry::decided_sign(first.speed) != Sign::kPositive) return ExitKind::kOpen;
  if (geometry::decided_sign(first.room) != Sign::kPositive) return ExitKind::kOpen;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (k == best) continue;
    const BoundedNumber lead = walls[k].room * first.speed - first.room * walls[k].speed;
    if (geometry::decided_sign(lead) != Sign::kPositive) return ExitKind::kOpen;
  }
  exit = {best, first.room / first.speed};
  return ExitKind::kThroughWall;
}

}  // namespace

// What all locators of one diagram share, and does not change.
struct FlowLocator::Map {
  Map(const VoronoiDiagram& voronoi, const StationaryPoints& list, const FlowLimits& limits)
      : diagram(voronoi), stationary(list), partition(LimitPartition::of(limits)) {
    if (diagram.dimension() < 3) return;
    neighborhoods.emplace(diagram);
    divisions.emplace(diagram, partition);
    one_in_units = Rational(std::ldexp(1.0, -divisions->unit()));
    std::vector<SpatialEntry> entries;
    const std::vector<Point>& points = diagram.delaunay().points;
    entries.reserve(points.size());
    for (VertexIndex v = 0; v < points.size(); ++v) entries.emplace_back(spatial(points[v]), v);
    tree = SampleTree(entries);
  }

  // In units (BoundedDivisions::unit). A scaled number that underflows is covered by every bound.
  [[nodiscard]] BoundedVector between(VertexIndex from, const Point& to) const;
  [[nodiscard]] BoundedVector between(VertexIndex from, VertexIndex to) const {
    return between(from, diagram.point(to));
  }
  [[nodiscard]] std::optional<BoundedVector> offset(VertexIndex from, const RationalPoint& x) const;
  [[nodiscard]] VertexIndex nearby(const Point& x) const;

  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  const LimitPartition& partition;
  // Dimension 3 only.
  std::optional<Neighborhoods> neighborhoods;
  std::optional<BoundedDivisions> divisions;
  Rational one_in_units;
  SampleTree tree;
};

struct FlowLocator::Parts {
  Parts(std::shared_ptr<const Map> all, FlowOptions how)
      : map(std::move(all)), options(how), finder(map->stationary), faces(map->diagram), flow(map->diagram, how) {}

  // The three return kOpenLimit where bounds do not decide. u is x - p, and g is a vector from the midpoint.
  static constexpr Limit kOpenLimit = 0xfffffffeu;
  [[nodiscard]] Limit limit_in_cell(VertexIndex p, const BoundedVector& u);
  [[nodiscard]] Limit limit_in_facet(VertexIndex p, const Neighbor& q, const BoundedVector& g);
  [[nodiscard]] Limit limit_on_edge(FacetName facet, const RingPiece& piece, const BoundedNumber& parameter) const;
  [[nodiscard]] FlowPlace follow(const RationalPoint& x);
  [[nodiscard]] FlowPlace place(VertexIndex p, Limit limit) const;

  std::shared_ptr<const Map> map;
  FlowOptions options;
  RecordFinder finder;
  VoronoiFaces faces;
  Flow flow;
  std::vector<Wall> walls;
  std::vector<std::size_t> pieces;  // of the walls of a facet
  std::size_t followed = 0;
};

BoundedVector FlowLocator::Map::between(VertexIndex from, const Point& to) const {
  const Point& p = diagram.point(from);
  const auto scaled = [this](double a, double b) {
    return BoundedNumber{DoubleDouble::sum(std::ldexp(a, -divisions->unit()), -std::ldexp(b, -divisions->unit())),
                         geometry::kBoundedUnderflow};
  };
  return {scaled(to.x, p.x), scaled(to.y, p.y), scaled(to.z, p.z)};
}

// In units each coordinate is a double and a remainder, whose nearest double has an error of its own.
std::optional<BoundedVector> FlowLocator::Map::offset(VertexIndex from, const RationalPoint& x) const {
  const Point& p = diagram.point(from);
  bool is_finite = true;
  const auto from_origin = [&](const Rational& coordinate, double origin) {
    const Rational in_units = coordinate * one_in_units;
    const auto high = nearest_double(in_units);
    is_finite = is_finite && high.has_value();
    if (!high) return BoundedNumber{};
    const double low = nearest_double(in_units - Rational(*high)).value_or(0);
    const BoundedNumber to_high{DoubleDouble::sum(*high, -std::ldexp(origin, -divisions->unit())),
                                geometry::kBoundedUnderflow};
    return to_high + BoundedNumber{low, std::fabs(low) * geometry::kRoundingShare + geometry::kBoundedUnderflow};
  };
  const BoundedVector all{from_origin(x[0], p.x), from_origin(x[1], p.y), from_origin(x[2], p.z)};
  return is_finite ? std::optional(all) : std::nullopt;
}

// Doubles find it, and nothing depends on whether it is the nearest one.
VertexIndex FlowLocator::Map::nearby(const Point& x) const {
  return tree.qbegin(index::nearest(spatial(x), 1))->second;
}

// z = p + t u is in the cell while 2 t <u, q-p> <= |q-p|^2 for all neighbours q. p is the only nearest sample of x,
// where t is 1, iff the first exit is later.
Limit FlowLocator::Parts::limit_in_cell(VertexIndex p, const BoundedVector& u) {
  const std::span<const Neighbor> around = map->neighborhoods->of(p);
  walls.clear();
  for (const Neighbor& q : around) {
    const BoundedVector d = map->between(p, q.vertex);
    walls.push_back({dot(d, d), doubled(dot(u, d))});
  }
  Exit exit{};
  const ExitKind kind = first_exit(walls, exit);
  if (kind == ExitKind::kNowhere) return kInfinityLimit;
  if (kind == ExitKind::kOpen) return kOpenLimit;
  if (geometry::decided_sign(exit.parameter - BoundedNumber{1, 0}) != Sign::kPositive) return kOpenLimit;
  const Neighbor& q = around[exit.wall];
  return limit_in_facet(p, q, exit.parameter * u - kHalf * map->between(p, q.vertex));
}

// z = m + s g is in the facet while 2 s <g, w-m> <= <w-p, w-q> for the samples w of all its Voronoi edges.
Limit FlowLocator::Parts::limit_in_facet(VertexIndex p, const Neighbor& q, const BoundedVector& g) {
  const FacetName facet = voronoi::facet_name(p, q.vertex);
  const FacetRing ring = faces.ring(facet, q.cell);
  const BoundedVector half = kHalf * map->between(facet.v0, facet.v1);
  walls.clear();
  pieces.clear();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RingPiece& piece = ring.pieces[k];
    if (!piece.is_finite()) continue;
    const BoundedVector from_m = map->between(facet.v0, piece.apex) - half;
    // <w-p, w-q> = |w-m|^2 - |q-p|^2 / 4
    walls.push_back({dot(from_m, from_m) - dot(half, half), doubled(dot(g, from_m))});
    pieces.push_back(k);
  }
  Exit exit{};
  const ExitKind kind = first_exit(walls, exit);
  if (kind == ExitKind::kNowhere) return kInfinityLimit;
  if (kind == ExitKind::kOpen) return kOpenLimit;
  const RingPiece& piece = ring.pieces[pieces[exit.wall]];
  // The normal is orthogonal to p1-p0, so m may stand for p0 in the parameter (division_parameter.h).
  const BoundedVector normal = cross(map->between(facet.v0, facet.v1), map->between(facet.v0, piece.apex));
  return limit_on_edge(facet, piece, exit.parameter * dot(g, normal));
}

Limit FlowLocator::Parts::limit_on_edge(FacetName facet, const RingPiece& piece, const BoundedNumber& parameter) const {
  const std::span<const Division> all = map->partition.edge(piece.polygon());
  if (all.size() == 1) return all.front().limit;
  const std::array<VertexIndex, 3> samples{facet.v0, facet.v1, piece.apex};
  const bool is_forward = has_turn(map->diagram, piece.polygon(), samples);
  // The side of the division point 2 k + 1 that the parameter is on, towards end 1 positive.
  const auto side = [&](std::size_t k) -> MaybeSign {
    const PointOfDivision number = all[2 * k + 1].point;
    const DivisionPoint& point = map->partition.point(number);
    BoundedNumber there{0, 0};
    if (point.kind == DivisionPoint::Kind::kCrossing) {
      const int turn = turn_of_same(point.samples(), samples);
      if (turn == 0) return std::nullopt;
      there = map->divisions->parameter(number);
      if (turn < 0) there.value = -there.value;
    }
    const BoundedNumber beyond = is_forward ? parameter - there : there - parameter;
    return geometry::decided_sign(beyond);
  };
  std::size_t first = 0, last = all.size() / 2;  // division points that the parameter may lie before
  while (first < last) {
    const std::size_t middle = (first + last) / 2;
    const auto sign = side(middle);
    if (!sign) return kOpenLimit;
    (*sign == Sign::kPositive ? first : last) = *sign == Sign::kPositive ? middle + 1 : middle;
  }
  return all[2 * first].limit;
}

FlowPlace FlowLocator::Parts::follow(const RationalPoint& x) {
  ++followed;
  FlowPlace place;
  if (const auto limit = flow.limit(x)) {
    place.limit = finder.find(limit->index, limit->contact);
    if (!place.limit) throw std::logic_error("a stationary point that is not listed");
  }
  for (const VertexIndex v : faces.diagram().contact(faces.locate(x))) {
    place.nearest.push_back(map->diagram.name(v));
  }
  std::ranges::sort(place.nearest);
  return place;
}

FlowPlace FlowLocator::Parts::place(VertexIndex p, Limit limit) const {
  FlowPlace place{std::nullopt, {map->diagram.name(p)}};
  if (limit != kInfinityLimit) place.limit = limit;
  return place;
}

FlowLocator::FlowLocator(const VoronoiDiagram& diagram, const StationaryPoints& stationary, const FlowLimits& limits,
                         FlowOptions options)
    : parts_(geometry::in_ieee_doubles([&] {
        return std::make_unique<Parts>(std::make_shared<const Map>(diagram, stationary, limits), options);
      })) {}
FlowLocator::FlowLocator(const FlowLocator& other)
    : parts_(geometry::in_ieee_doubles(
          [&] { return std::make_unique<Parts>(other.parts_->map, other.parts_->options); })) {}
FlowLocator::~FlowLocator() = default;
FlowLocator::FlowLocator(FlowLocator&&) noexcept = default;
FlowLocator& FlowLocator::operator=(FlowLocator&&) noexcept = default;

FlowPlace FlowLocator::locate(const RationalPoint& x) {
  const geometry::IeeeDoubles ieee;
  Parts& all = *parts_;
  if (!all.map->divisions) return all.follow(x);
  const auto rounded = [](const Rational& value) { return nearest_double(value).value_or(HUGE_VAL); };
  const Point about{rounded(x[0]), rounded(x[1]), rounded(x[2])};
  if (!std::isfinite(about.x) || !std::isfinite(about.y) || !std::isfinite(about.z)) return all.follow(x);
  const VertexIndex p = all.map->nearby(about);
  const auto u = all.map->offset(p, x);
  const Limit limit = u ? all.limit_in_cell(p, *u) : Parts::kOpenLimit;
  return limit == Parts::kOpenLimit ? all.follow(x) : all.place(p, limit);
}

FlowPlace FlowLocator::locate(const Point& x) {
  const geometry::IeeeDoubles ieee;
  Parts& all = *parts_;
  if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z)) {
    throw InvalidInput("a position must be finite");
  }
  if (all.map->divisions) {
    const VertexIndex p = all.map->nearby(x);
    const Limit limit = all.limit_in_cell(p, all.map->between(p, x));
    if (limit != Parts::kOpenLimit) return all.place(p, limit);
  }
  return all.follow(exact_position(x));
}

std::size_t FlowLocator::followed() const { return parts_->followed; }

}  // namespace flowcert
