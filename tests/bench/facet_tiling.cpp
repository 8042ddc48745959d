// Whether the regions of all Voronoi facets of a scan tile them, and volumes add up: exactly, or modulo three primes of
// 61 bits. Exact numbers of a large scan are too long to be added.
//
// In each bounded facet, the areas of its regions add up to that of the polygon of its Voronoi vertices. For each
// stationary point, the pyramids over its regions add up to the joins of its arcs of Voronoi edges with their polygons.
// A wrong identity holds modulo one prime with a probability of less than 2^-40. Prints one line a prime; the exit
// status is 1 if anything differs.
//
// usage: facet_tiling [--exact] INPUT
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/read_points.h"
#include "morse/division_parameter.h"
#include "morse/exact_divisions.h"
#include "morse/facet_regions.h"
#include "morse/polygon_turn.h"

namespace {

using namespace flowcert;
using namespace flowcert::morse;

// ---- Numbers modulo a prime ----

std::uint64_t prime = 0;

class Residue {
 public:
  Residue() = default;
  Residue(int value)
      : value_(value < 0 ? prime - static_cast<std::uint64_t>(-value) : static_cast<std::uint64_t>(value)) {}
  // A double is an integer times a power of two.
  explicit Residue(double x) {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(std::fabs(x), &exponent), 53);
    value_ = static_cast<std::uint64_t>(mantissa) % prime;
    exponent -= 53;
    const Residue two = exponent < 0 ? Residue(2).inverse() : Residue(2);
    *this = *this * two.power(static_cast<std::uint64_t>(std::abs(exponent)));
    if (x < 0) *this = Residue(0) - *this;
  }

  friend Residue operator+(Residue a, Residue b) {
    const std::uint64_t sum = a.value_ + b.value_;
    return from(sum < prime ? sum : sum - prime);
  }
  friend Residue operator-(Residue a, Residue b) {
    return from(a.value_ < b.value_ ? a.value_ + prime - b.value_ : a.value_ - b.value_);
  }
  friend Residue operator*(Residue a, Residue b) {
    __extension__ using Wide = unsigned __int128;
    return from(static_cast<std::uint64_t>(Wide(a.value_) * b.value_ % prime));
  }
  friend Residue operator/(Residue a, Residue b) { return a * b.inverse(); }
  friend bool operator==(Residue, Residue) = default;

 private:
  static Residue from(std::uint64_t value) {
    Residue residue;
    residue.value_ = value;
    return residue;
  }
  [[nodiscard]] Residue power(std::uint64_t exponent) const {
    Residue result(1), square = *this;
    for (; exponent > 0; exponent >>= 1) {
      if ((exponent & 1u) != 0) result = result * square;
      square = square * square;
    }
    return result;
  }
  [[nodiscard]] Residue inverse() const { return power(prime - 2); }

  std::uint64_t value_ = 0;
};

// ---- Positions ----

template <class Number>
class Positions {
  using Vector = Vector3<Number>;

 public:
  Positions(const VoronoiDiagram& diagram, const LimitPartition& partition) : diagram_(diagram), partition_(partition) {
    for (const Point& p : diagram.delaunay().points) samples_.push_back({Number(p.x), Number(p.y), Number(p.z)});
    for (PointOfDivision number = 0; number < partition.point_count(); ++number) {
      const DivisionPoint& point = partition.point(number);
      parameters_.push_back(point.kind == DivisionPoint::Kind::kCrossing ? crossing(point) : Number(0));
    }
  }

  [[nodiscard]] const Vector& at(VertexIndex v) const { return samples_[v]; }
  [[nodiscard]] Number parameter(PointOfDivision number) const { return parameters_[number]; }
  // By what the parameter of a point is multiplied for other samples of its polygon.
  [[nodiscard]] Number ratio(const DivisionPoint& point, const std::array<VertexIndex, 3>& samples) const {
    return parameter_ratio<Number>([this](VertexIndex v) { return at(v); },
                                   {point.facet.v0, point.facet.v1, point.apex}, samples);
  }

  [[nodiscard]] Vector of(FacetName facet, const RegionCorner& corner) const {
    switch (corner.kind) {
      case RegionCorner::Kind::kMidpoint:
        return Number(Number(1) / Number(2)) * (at(facet.v0) + at(facet.v1));
      case RegionCorner::Kind::kVertex: {
        const auto& v = diagram_.delaunay().vertices(corner.number);
        const auto sphere = geometry::circumsphere(at(v[1]) - at(v[0]), at(v[2]) - at(v[0]), at(v[3]) - at(v[0]));
        return at(v[0]) + Number(Number(1) / Number(Number(2) * sphere.determinant)) * sphere.numerator;
      }
      default:
        break;
    }
    const DivisionPoint& point = partition_.point(corner.number);
    if (point.kind == DivisionPoint::Kind::kCrossing) {
      const Vector p0 = at(point.facet.v0);
      return p0 + offset_of_parameter(at(point.facet.v1) - p0, at(point.apex) - p0, parameter(corner.number));
    }
    const auto [a, b, c] = diagram_.corners({point.from / 4, point.from % 4});
    return at(a) + offset_of_parameter(at(b) - at(a), at(c) - at(a), Number(0));
  }

 private:
  [[nodiscard]] Number crossing(const DivisionPoint& point) const {
    const Vector p0 = at(point.facet.v0), e = at(point.facet.v1) - p0, d = at(point.far_apex) - p0;
    Number r(0);
    const DivisionPoint& from = partition_.point(point.from);
    if (from.kind == DivisionPoint::Kind::kVertex) {
      const auto far = vertex_parameter(ApexPair<Number>(e, d, at(point.other) - p0), d);
      r = far.num / far.den;
    } else if (from.kind == DivisionPoint::Kind::kCrossing) {
      r = parameters_[point.from] * ratio(from, {point.facet.v0, point.facet.v1, point.far_apex});
    }
    const auto near = crossed_parameter(ApexPair<Number>(e, d, at(point.apex) - p0), r);
    return near.num / near.den;
  }

  const VoronoiDiagram& diagram_;
  const LimitPartition& partition_;
  std::vector<Vector> samples_;
  std::vector<Number> parameters_;
};

// ---- Sums ----

// <2 area, axis>
template <class Number>
Number area(const Vector3<Number>& axis, const std::vector<Vector3<Number>>& corners) {
  Number sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum = sum + dot(axis, cross(corners[i] - corners[0], corners[i + 1] - corners[0]));
  }
  return sum;
}

struct Outcome {
  std::size_t facets = 0, regions = 0, open = 0, not_tiled = 0, sets = 0, other_volumes = 0;
};

template <class Number>
class Sums {
  using Vector = Vector3<Number>;

 public:
  Sums(const FlowComplex& complex)
      : diagram_(complex.diagram()),
        partition_(LimitPartition::of(complex.limits())),
        faces_(complex.diagram()),
        positions_(diagram_, partition_),
        regions_(complex.stationary().size(), Number(0)),
        arcs_(complex.stationary().size(), Number(0)) {}

  [[nodiscard]] Outcome run() {
    for (CellIndex cell = 0; cell < diagram_.delaunay().finite_count; ++cell) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        if (diagram_.complex().role({cell, i}) != VoronoiComplex::FacetRole::kInterior) add_end({cell, i});
      }
    }
    std::vector<bool> is_visited;
    for_each_polygon(diagram_, [&](PolygonRef polygon) {
      add_points(polygon);
      for (const PolygonSide& side : diagram_.sides(polygon)) {
        const FacetName facet{side.v0, side.v1};
        const FacetRing ring = faces_.ring(facet, diagram_.cell_of_side(polygon, facet));
        if (ring.id >= is_visited.size()) is_visited.resize(2 * std::size_t{ring.id} + 1, false);
        if (!is_visited[ring.id]) add_facet(ring);
        is_visited[ring.id] = true;
      }
    });
    for (std::size_t record = 0; record < arcs_.size(); ++record) {
      outcome_.sets += regions_[record] == Number(0) ? 0 : 1;
      outcome_.other_volumes += regions_[record] == arcs_[record] ? 0 : 1;
    }
    return outcome_;
  }

 private:
  void add_facet(const FacetRing& ring) {
    const Vector axis = positions_.at(ring.facet.v1) - positions_.at(ring.facet.v0);
    Number sum(0);
    bool is_bounded = true;
    ++outcome_.facets;
    for (const FacetRegion& region : regions_of(diagram_, partition_, ring)) {
      ++outcome_.regions;
      std::vector<Vector> corners;
      for (const RegionCorner& corner : region.corners) {
        if (corner.kind == RegionCorner::Kind::kEnd) break;
        corners.push_back(positions_.of(ring.facet, corner));
      }
      is_bounded = is_bounded && corners.size() == region.corners.size();
      if (corners.size() < region.corners.size()) continue;
      const Number part = area(axis, corners);
      sum = sum + part;
      if (region.limit != kInfinityLimit) regions_[region.limit] = regions_[region.limit] + part;
    }
    if (!is_bounded) {
      ++outcome_.open;
      return;
    }
    std::vector<Vector> vertices;
    for (const RingPiece& piece : ring.pieces) {
      vertices.push_back(positions_.of(ring.facet, {RegionCorner::Kind::kVertex, 0, piece.vertex}));
    }
    outcome_.not_tiled += sum == area(axis, vertices) ? 0 : 1;
  }

  void add(Limit limit, const Number& term) {
    if (limit != kInfinityLimit) arcs_[limit] = arcs_[limit] + term;
  }
  // At the Voronoi vertex of the cell, on the edge of one of its facets.
  void add_end(FacetRef facet) {
    const PolygonRef polygon = diagram_.polygon(facet);
    const std::span<const Division> edge = partition_.edge(polygon);
    const bool is_end_0 = diagram_.end(polygon, 0) == diagram_.complex().cluster(facet.cell);
    const auto [a, b, c] = diagram_.corners(facet);
    const Vector p0 = positions_.at(a), d = positions_.at(c) - p0;
    const Vector apex = positions_.at(diagram_.delaunay().vertices(facet.cell)[facet.index]) - p0;
    const auto r = vertex_parameter(ApexPair<Number>(positions_.at(b) - p0, d, apex), d);
    add((is_end_0 ? edge.front() : edge.back()).limit, Number(0) - Number(r.num / r.den));
  }
  void add_points(PolygonRef polygon) {
    const std::span<const Division> edge = partition_.edge(polygon);
    for (std::size_t i = 1; i + 1 < edge.size(); i += 2) {
      const DivisionPoint& point = partition_.point(edge[i].point);
      if (point.kind != DivisionPoint::Kind::kCrossing) continue;
      Number ratio(0);
      if (diagram_.complex().role(polygon) == VoronoiComplex::FacetRole::kWhole) {
        ratio = positions_.ratio(point, diagram_.corners(polygon));
      } else {
        for (const FacetRef piece : diagram_.complex().large_polygon(diagram_.complex().large_polygon_of(polygon))) {
          ratio = ratio + positions_.ratio(point, diagram_.corners(piece));
        }
      }
      const Number r = positions_.parameter(edge[i].point) * ratio;
      add(edge[i - 1].limit, r);
      add(edge[i + 1].limit, Number(0) - r);
    }
  }

  const VoronoiDiagram& diagram_;
  const LimitPartition& partition_;
  VoronoiFaces faces_;
  Positions<Number> positions_;
  std::vector<Number> regions_, arcs_;  // by record: six times the volume
  Outcome outcome_;
};

bool is_right(const std::string& how, const Outcome& o) {
  fmt::print(
      "{}: {} facets, {} of them unbounded; {} regions; {} facets not tiled; {} sets of positive volume, {} with "
      "another volume\n",
      how, o.facets, o.open, o.regions, o.not_tiled, o.sets, o.other_volumes);
  return o.not_tiled == 0 && o.other_volumes == 0;
}

int run(const std::string& path, bool exactly) {
  const FlowComplex complex{PointSet(read_points(path).rows)};
  if (complex.dimension() < 3) throw std::runtime_error("the points do not span space");
  if (exactly) return is_right("exactly", Sums<Rational>(complex).run()) ? 0 : 1;
  bool all_right = true;
  for (const std::uint64_t next : {2305843009213693951u, 2305843009213693921u, 2305843009213693907u}) {
    prime = next;
    all_right = is_right(fmt::format("modulo {}", prime), Sums<Residue>(complex).run()) && all_right;
  }
  return all_right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool exactly = words.size() == 2 && words.front() == "--exact";
  if (words.empty() || (words.size() > 1 && !exactly)) {
    fmt::print(stderr, "usage: facet_tiling [--exact] INPUT\n");
    return 2;
  }
  try {
    return run(words.back(), exactly);
  } catch (const std::exception& error) {
    fmt::print(stderr, "facet_tiling: {}\n", error.what());
    return 2;
  }
}
