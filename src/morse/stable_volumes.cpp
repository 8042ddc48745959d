// A volume is a sum of terms, one for each end of an arc. At a Voronoi vertex a term is the signed volume of the
// pyramid from there over a facet of the cell. If all four belong to one set, they add up to the cell.
#include "flowcert/stable_volumes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "flowcert/sphere.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/portions.h"
#include "morse/bounded_divisions.h"
#include "morse/exact_divisions.h"
#include "morse/limit_partition.h"
#include "morse/polygon_turn.h"

namespace flowcert {

using namespace morse;

namespace {

using RationalVector = Vector3<Rational>;

// Few, because the exact volumes of a portion can take long.
constexpr std::size_t kVolumesAtATime = geometry::portion_size(32);

// Sums of neighbours first, so that long numbers are few.
Rational total(std::span<const Rational> terms) {
  if (terms.empty()) return 0;
  if (terms.size() == 1) return terms.front();
  const std::size_t half = terms.size() / 2;
  return total(terms.first(half)) + total(terms.subspan(half));
}

}  // namespace

struct StableVolumes::Parts {
  using Records = std::span<const std::uint32_t>;
  using Shares = std::map<PointId, std::vector<Rational>>;  // by sample: what adds up to its part

  // Where an arc ends, and so what is added to a volume.
  struct VolumeTerm {
    enum class Kind : std::uint32_t {
      kCell,    // all of the cell `face`
      kVertex,  // the pyramid over the facet `face`, packed, from the Voronoi vertex of the cell
      kAfter,   // at the point of a division of the Voronoi edge `face`: the arc comes after it, towards end 1
      kBefore,  // the arc comes before it
    };
    Limit limit;
    Kind kind;
    std::uint32_t face;
    PointOfDivision point = kNoDivision;
  };

  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, const FlowLimits& all)
      : diagram(voronoi), partition(LimitPartition::of(all)), first(list.size() + 1, 0), doubles(list.size(), 0) {}

  void gather_terms();
  void gather_cell(CellIndex cell, std::vector<VolumeTerm>& found) const;
  void gather_points(PolygonRef polygon, std::vector<VolumeTerm>& found) const;
  void round_all(unsigned threads, const Progress& progress);
  void compute_hull();

  [[nodiscard]] std::span<const VolumeTerm> terms_of(std::size_t record) const {
    FLOWCERT_REQUIRES(record + 1 < first.size());
    return std::span(terms).subspan(first[record], first[record + 1] - first[record]);
  }
  [[nodiscard]] BoundedNumber bounded(const BoundedDivisions& divisions, const VolumeTerm& term) const;
  // Of some records together.
  [[nodiscard]] std::optional<double> rounded(const BoundedDivisions& divisions, Records records) const;
  // A sum of terms, as a volume.
  [[nodiscard]] static std::optional<double> rounded_sixth(const BoundedDivisions& divisions, const BoundedNumber& sum);
  [[nodiscard]] const BoundedDivisions& shared_bounds();
  void add_rounded_shares(const BoundedDivisions& divisions, const VolumeTerm& term,
                          std::map<PointId, BoundedNumber>& sums) const;
  // Nothing if the bounds leave one open.
  [[nodiscard]] std::optional<std::vector<std::pair<PointId, double>>> rounded_shares(std::size_t record);
  [[nodiscard]] RationalVector at(VertexIndex v) const { return exact_vector(diagram.point(v)); }
  [[nodiscard]] Rational determinant(CellIndex cell) const;
  [[nodiscard]] Rational pyramid(FacetRef face) const;
  [[nodiscard]] Rational ratio_over(const VolumeTerm& term, FacetRef triangle) const;
  [[nodiscard]] Rational exact(const VolumeTerm& term);
  [[nodiscard]] Rational exact(Records records);
  void add_shares(const std::array<VertexIndex, 3>& triangle, const Rational& volume, Shares& shares) const;
  void add_shares(const VolumeTerm& term, Shares& shares);
  [[nodiscard]] std::vector<FacetRef> triangles_of(PolygonRef polygon) const;

  const VoronoiDiagram& diagram;
  const LimitPartition& partition;
  std::vector<VolumeTerm> terms;   // by record
  std::vector<std::size_t> first;  // of a record's
  std::vector<double> doubles;
  Rational hull = 0;
  std::atomic<std::size_t> decided_exactly = 0;
  std::mutex mutex;  // of what follows
  std::optional<ExactDivisions> divisions;
  std::optional<BoundedDivisions> bounds;  // constant once it is made
};

// ---- Terms ----

// The limits next to the cell's Voronoi vertex, on the edges of its four facets.
void StableVolumes::Parts::gather_cell(CellIndex cell, std::vector<VolumeTerm>& found) const {
  std::array<Limit, 4> limits{};
  bool is_one = true;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const FacetRef facet{cell, i};
    limits[i] = kInfinityLimit;
    if (diagram.complex().role(facet) == VoronoiComplex::FacetRole::kInterior) {
      is_one = false;
      continue;
    }
    const PolygonRef polygon = diagram.polygon(facet);
    const std::span<const Division> edge = partition.edge(polygon);
    // All facets of a polygon are given from the same cluster's side, which is that of end 0.
    const bool is_end_0 = diagram.end(polygon, 0) == diagram.complex().cluster(cell);
    limits[i] = (is_end_0 ? edge.front() : edge.back()).limit;
    is_one = is_one && limits[i] == limits[0];
  }
  if (is_one) {
    if (limits[0] != kInfinityLimit) found.push_back({limits[0], VolumeTerm::Kind::kCell, cell});
    return;
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (limits[i] != kInfinityLimit)
      found.push_back({limits[i], VolumeTerm::Kind::kVertex, FacetRef{cell, i}.packed()});
  }
}

void StableVolumes::Parts::gather_points(PolygonRef polygon, std::vector<VolumeTerm>& found) const {
  const std::span<const Division> edge = partition.edge(polygon);
  for (std::size_t i = 1; i + 1 < edge.size(); i += 2) {
    // The centre has the parameter 0.
    if (partition.point(edge[i].point).kind != DivisionPoint::Kind::kCrossing) continue;
    const auto add = [&](Limit limit, VolumeTerm::Kind kind) {
      if (limit != kInfinityLimit) found.push_back({limit, kind, polygon.packed(), edge[i].point});
    };
    add(edge[i - 1].limit, VolumeTerm::Kind::kBefore);
    add(edge[i + 1].limit, VolumeTerm::Kind::kAfter);
  }
}

// Sorted by record, stably.
void StableVolumes::Parts::gather_terms() {
  std::vector<VolumeTerm> found;
  for (CellIndex cell = 0; cell < diagram.delaunay().finite_count; ++cell) gather_cell(cell, found);
  for_each_polygon(diagram, [&](PolygonRef polygon) { gather_points(polygon, found); });
  for (const VolumeTerm& term : found) ++first[term.limit + 1];
  for (std::size_t record = 1; record < first.size(); ++record) first[record] += first[record - 1];
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  terms.resize(found.size());
  for (const VolumeTerm& term : found) terms[next[term.limit]++] = term;
}

// ---- In doubles ----

// Six times the term.
BoundedNumber StableVolumes::Parts::bounded(const BoundedDivisions& divisions_, const VolumeTerm& term) const {
  switch (term.kind) {
    case VolumeTerm::Kind::kCell:
      return divisions_.determinant(diagram.delaunay().vertices(term.face));
    case VolumeTerm::Kind::kVertex: {
      const auto [cell, index] = FacetRef::unpacked(term.face);
      const auto [a, b, c] = diagram.corners({cell, index});
      BoundedNumber r = divisions_.parameter_of_sphere(a, b, c, diagram.delaunay().vertices(cell)[index]);
      r.value = -r.value;
      return r;
    }
    case VolumeTerm::Kind::kAfter:
    case VolumeTerm::Kind::kBefore:
      break;
  }
  const PolygonRef polygon = PolygonRef::unpacked(term.face);
  const DivisionPoint& point = partition.point(term.point);
  const int turn = turn_of_same(point.samples(), diagram.corners(polygon));
  // Polygons with more than three samples are left to exact numbers.
  if (turn == 0 || diagram.complex().role(polygon) != VoronoiComplex::FacetRole::kWhole) return {};
  BoundedNumber r = divisions_.parameter(term.point);
  if ((turn < 0) == (term.kind == VolumeTerm::Kind::kBefore)) r.value = -r.value;
  return r;
}

std::optional<double> StableVolumes::Parts::rounded(const BoundedDivisions& divisions_, Records records) const {
  BoundedNumber sum{0, 0};
  for (const std::uint32_t record : records) {
    for (const VolumeTerm& term : terms_of(record)) {
      const BoundedNumber next = bounded(divisions_, term);
      if (!(next.error < HUGE_VAL)) return std::nullopt;
      sum = sum + next;
    }
  }
  return rounded_sixth(divisions_, sum);
}

std::optional<double> StableVolumes::Parts::rounded_sixth(const BoundedDivisions& divisions_,
                                                          const BoundedNumber& sum) {
  const DoubleDouble sixth = sum.value / DoubleDouble(6);
  // The division has one roundoff.
  constexpr double kSixthBound = 2 * DoubleDouble::kRoundoff;
  const double rounding = kSixthBound * std::fabs(sixth.high());
  const auto in_units = decided_double({sixth, (sum.error / 6 + rounding) * geometry::kBoundedSlack});
  if (!in_units) return std::nullopt;
  const double volume = std::ldexp(*in_units, 3 * divisions_.unit());
  const bool is_normal = std::isnormal(volume) && std::ldexp(volume, -3 * divisions_.unit()) == *in_units;
  return is_normal ? std::optional(volume) : std::nullopt;
}

void StableVolumes::Parts::round_all(unsigned threads, const Progress& progress) {
  const BoundedDivisions bounded_divisions(diagram, partition);
  geometry::in_portions(threads, doubles.size(), kVolumesAtATime, progress, [&](std::size_t, std::size_t record) {
    if (terms_of(record).empty()) return;
    const std::array one = {static_cast<std::uint32_t>(record)};
    if (const auto volume = rounded(bounded_divisions, one)) {
      doubles[record] = *volume;
    } else {
      ++decided_exactly;
      doubles[record] = nearest_or_infinity(exact(one));
    }
  });
}

// ---- Exactly ----

Rational StableVolumes::Parts::determinant(CellIndex cell) const {
  const auto& v = diagram.delaunay().vertices(cell);
  const RationalVector origin = at(v[0]);
  return dot(at(v[1]) - origin, cross(at(v[2]) - origin, at(v[3]) - origin));
}

// Six times the signed volume over a facet of a cell, from the cell's Voronoi vertex.
Rational StableVolumes::Parts::pyramid(FacetRef face) const {
  const auto [a, b, c] = diagram.corners(face);
  const RationalVector p0 = at(a), e = at(b) - p0, d = at(c) - p0;
  const RationalVector apex = at(diagram.delaunay().vertices(face.cell)[face.index]) - p0;
  const auto r = vertex_parameter(ApexPair<Rational>(e, d, apex), d);
  return -(r.num / r.den);
}

// The facets of a polygon, which name it together.
std::vector<FacetRef> StableVolumes::Parts::triangles_of(PolygonRef polygon) const {
  if (diagram.complex().role(polygon) == VoronoiComplex::FacetRole::kWhole) return {polygon};
  const auto pieces = diagram.complex().large_polygon(diagram.complex().large_polygon_of(polygon));
  return {pieces.begin(), pieces.end()};
}

// By what the parameter of a term's point is multiplied to be one over a triangle of its polygon.
Rational StableVolumes::Parts::ratio_over(const VolumeTerm& term, FacetRef triangle) const {
  return parameter_ratio<Rational>([this](VertexIndex v) { return at(v); }, partition.point(term.point).samples(),
                                   diagram.corners(triangle));
}

Rational StableVolumes::Parts::exact(const VolumeTerm& term) {
  if (term.kind == VolumeTerm::Kind::kCell) return determinant(term.face);
  if (term.kind == VolumeTerm::Kind::kVertex) return pyramid(FacetRef::unpacked(term.face));
  Rational ratio = 0;
  for (const FacetRef triangle : triangles_of(PolygonRef::unpacked(term.face))) ratio += ratio_over(term, triangle);
  const Rational r = divisions->parameter(term.point) * ratio;
  return term.kind == VolumeTerm::Kind::kBefore ? r : Rational(-r);
}

Rational StableVolumes::Parts::exact(Records records) {
  const std::scoped_lock lock(mutex);
  if (!divisions) divisions.emplace(diagram, partition);
  std::vector<Rational> values;
  for (const std::uint32_t record : records) {
    for (const VolumeTerm& term : terms_of(record)) values.push_back(exact(term));
  }
  return total(values) / 6;
}

void StableVolumes::Parts::compute_hull() {
  Rational sum = 0;
  const RationalVector origin = at(0);
  for (CellIndex cell = 0; cell < diagram.delaunay().finite_count; ++cell) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (diagram.delaunay().is_finite(diagram.delaunay().neighbors(cell)[i])) continue;
      const auto [a, b, c] = diagram.corners({cell, i});
      sum += dot(at(a) - origin, cross(at(b) - origin, at(c) - origin));
    }
  }
  hull = sum / 6;
}

// ---- Shares ----

// The join of an arc with a triangle is cut along the planes through the arc. A part with the side p q belongs half to
// p and half to q. By the barycentric coordinates w of the circle's centre, the triangle's sides have w of the opposite
// corner. So p has (1 - w_p) / 2.
void StableVolumes::Parts::add_shares(const std::array<VertexIndex, 3>& triangle, const Rational& volume,
                                      Shares& shares) const {
  std::array<Rational, 3> weights;
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalVector p = at(triangle[i]), q = at(triangle[(i + 1) % 3]), r = at(triangle[(i + 2) % 3]);
    weights[i] = dot(r - q, r - q) * dot(q - p, r - p);
    sum += weights[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    shares[diagram.name(triangle[i])].push_back(volume * (sum - weights[i]) / (2 * sum));
  }
}

void StableVolumes::Parts::add_shares(const VolumeTerm& term, Shares& shares) {
  if (term.kind == VolumeTerm::Kind::kCell) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      add_shares(diagram.corners({term.face, i}), pyramid({term.face, i}), shares);
    }
    return;
  }
  if (term.kind == VolumeTerm::Kind::kVertex) {
    const FacetRef face = FacetRef::unpacked(term.face);
    return add_shares(diagram.corners(face), pyramid(face), shares);
  }
  const Rational r = divisions->parameter(term.point) * (term.kind == VolumeTerm::Kind::kBefore ? 1 : -1);
  for (const FacetRef triangle : triangles_of(PolygonRef::unpacked(term.face))) {
    add_shares(diagram.corners(triangle), r * ratio_over(term, triangle), shares);
  }
}

const BoundedDivisions& StableVolumes::Parts::shared_bounds() {
  const std::scoped_lock lock(mutex);
  if (!bounds) bounds.emplace(diagram, partition);
  return *bounds;
}

void StableVolumes::Parts::add_rounded_shares(const BoundedDivisions& divisions_, const VolumeTerm& term,
                                              std::map<PointId, BoundedNumber>& sums) const {
  const auto add = [&](const VolumeTerm& over_triangle, const std::array<VertexIndex, 3>& triangle) {
    const auto parts = divisions_.parts_of_corners(bounded(divisions_, over_triangle), triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      BoundedNumber& sum = sums.try_emplace(diagram.name(triangle[i]), BoundedNumber{0, 0}).first->second;
      sum = sum + parts[i];
    }
  };
  if (term.kind != VolumeTerm::Kind::kCell) return add(term, diagram.corners(PolygonRef::unpacked(term.face)));
  for (std::uint32_t i = 0; i < 4; ++i) {
    const FacetRef face{term.face, i};
    add({term.limit, VolumeTerm::Kind::kVertex, face.packed()}, diagram.corners(face));
  }
}

std::optional<std::vector<std::pair<PointId, double>>> StableVolumes::Parts::rounded_shares(std::size_t record) {
  const BoundedDivisions& shared = shared_bounds();
  std::map<PointId, BoundedNumber> sums;
  for (const VolumeTerm& term : terms_of(record)) {
    // A term of a large polygon is that of several triangles, and is left to exact numbers.
    if (!(bounded(shared, term).error < HUGE_VAL)) return std::nullopt;
    add_rounded_shares(shared, term, sums);
  }
  std::vector<std::pair<PointId, double>> shares;
  for (const auto& [sample, sum] : sums) {
    const auto share = rounded_sixth(shared, sum);
    if (!share) return std::nullopt;
    shares.emplace_back(sample, *share);
  }
  return shares;
}

// ---- The class ----

StableVolumes::StableVolumes(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                             const FlowLimits& limits, unsigned threads, const Progress& progress)
    : parts_(geometry::in_ieee_doubles([&] { return std::make_unique<Parts>(diagram, stationary, limits); })) {
  const geometry::IeeeDoubles ieee;
  if (diagram.dimension() == 3) {
    parts_->gather_terms();
    parts_->round_all(threads, progress);
    parts_->compute_hull();
  }
  if (progress) progress(stationary.size(), stationary.size());
}
StableVolumes::~StableVolumes() = default;
StableVolumes::StableVolumes(StableVolumes&&) noexcept = default;
StableVolumes& StableVolumes::operator=(StableVolumes&&) noexcept = default;

double StableVolumes::nearest(std::size_t record) const { return parts_->doubles[record]; }
Rational StableVolumes::exact(std::size_t record) const {
  return exact_sum(std::array{static_cast<std::uint32_t>(record)});
}

double StableVolumes::nearest_sum(std::span<const std::uint32_t> records) const {
  const geometry::IeeeDoubles ieee;
  if (records.size() == 1) return nearest(records.front());
  const std::optional<double> sum = parts_->rounded(parts_->shared_bounds(), records);
  // By their bounds, a sum without terms and what is below the doubles look alike.
  return sum ? *sum : nearest_or_infinity(exact_sum(records));
}
Rational StableVolumes::exact_sum(std::span<const std::uint32_t> records) const {
  const geometry::IeeeDoubles ieee;
  return parts_->exact(records);
}

std::vector<std::pair<PointId, Rational>> StableVolumes::shares(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  Parts& all = *parts_;
  const std::scoped_lock lock(all.mutex);
  if (!all.divisions) all.divisions.emplace(all.diagram, all.partition);
  Parts::Shares parts;
  for (const Parts::VolumeTerm& term : all.terms_of(record)) all.add_shares(term, parts);
  std::vector<std::pair<PointId, Rational>> shares;
  for (const auto& [sample, values] : parts) {
    const Rational sum = total(values) / 6;
    if (sum != 0) shares.emplace_back(sample, sum);
  }
  return shares;
}

std::vector<std::pair<PointId, double>> StableVolumes::rounded_shares(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  if (auto decided = parts_->rounded_shares(record)) return std::move(*decided);
  std::vector<std::pair<PointId, double>> rounded;
  for (const auto& [sample, share] : shares(record)) {
    rounded.emplace_back(sample, nearest_double(share).value_or(HUGE_VAL));
  }
  return rounded;
}

const Rational& StableVolumes::hull() const { return parts_->hull; }
std::size_t StableVolumes::decided_exactly() const { return parts_->decided_exactly; }

}  // namespace flowcert
