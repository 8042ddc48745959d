// What a function of the library returns, as a text that holds every bit of it. Tests compare results with it.
//
// Guarantees: two results have one text iff all their numbers, ids and strings are equal; doubles count by their bits.
// A type that is not here does not compile.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <ranges>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "certify/orbit_claim.h"
#include "certify/orbit_difference.h"
#include "certify/pair_claim.h"
#include "certify/pair_differences.h"
#include "flowcert/check.h"
#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "flowcert/read_points.h"
#include "flowcert/surface.h"
#include "io/cell_surfaces.h"
#include "io/cycles.h"
#include "io/medial_points.h"
#include "io/pocket_persistence.h"
#include "io/surface_selection.h"
#include "io/vtk_exports.h"
#include "morse/explain.h"

namespace flowcert {

// The fields of a type that is no number, string, range or pair.
inline auto fields(const Point& p) { return std::tie(p.x, p.y, p.z); }
inline auto fields(const ExactSphere& s) { return std::tie(s.center, s.squared_radius); }
inline auto fields(const RoundedSphere& s) { return std::tie(s.center, s.squared_radius); }
inline auto fields(const StationaryIndex& i) { return std::tie(i.face_dimension, i.hull_dimension); }
inline auto fields(const StationaryLimit& l) { return std::tie(l.position, l.index, l.contact); }
inline auto fields(const FlowSegment& s) {
  return std::tie(s.type, s.start, s.driver, s.start_contact, s.crossed_contact, s.end, s.end_contact);
}
inline auto fields(const Orbit& o) { return std::tie(o.start, o.segments, o.limit); }
inline auto fields(const FlowPlace& p) { return std::tie(p.limit, p.nearest); }
inline auto fields(const FlowLimits::Entry& e) { return std::tie(e.limit, e.is_arc); }
inline auto fields(const LambdaList::Direction& d) { return std::tie(d.limit, d.exit, d.is_vector); }
inline auto fields(const LambdaList& l) { return std::tie(l.directions, l.arcs); }
inline auto fields(const RoundedLambdaList::Direction& d) { return std::tie(d.limit, d.exit, d.is_vector); }
inline auto fields(const RoundedLambdaList& l) { return std::tie(l.directions, l.arcs); }
template <class X>
auto fields(const Corner<X>& c) {
  return std::tie(c.position, c.at_infinity);
}
template <class X>
auto fields(const EdgePart<X>& p) {
  return std::tie(p.polygon, p.front, p.back);
}
template <class X>
auto fields(const Crossing<X>& c) {
  return std::tie(c.samples, c.front, c.back);
}
template <class X>
auto fields(const Region<X>& r) {
  return std::tie(r.samples, r.corners);
}
inline auto fields(const BackwardSegment<>& s) {
  return std::tie(s.samples, s.front, s.back, s.front_contact, s.back_contact, s.back_kind);
}
inline auto fields(const BackwardInterval<>& i) { return std::tie(i.polygon, i.front, i.back, i.back_is_stationary); }
inline auto fields(const StableSet<>& s) { return std::tie(s.segments, s.intervals, s.sectors); }
inline auto fields(const RoundedSegments::Position& p) { return std::tie(p.sphere, p.end); }
inline auto fields(const RoundedSegments::Segment& s) { return std::tie(s.samples, s.front, s.back); }
inline auto fields(const RoundedSegments& s) { return std::tie(s.positions, s.segments); }
inline auto fields(const UnstableSurface<>& s) { return std::tie(s.vertices, s.traces, s.runs, s.sheets, s.segments); }
inline auto fields(const UnstableSurfaceSize& s) {
  return std::tie(s.vertices, s.traces, s.runs, s.sheets, s.segments);
}
inline auto fields(const RoundedUnstableSurface::Corner& c) { return std::tie(c.position, c.at_infinity, c.exact); }
inline auto fields(const RoundedUnstableSurface::Part& p) { return std::tie(p.kind, p.samples, p.corners); }
inline auto fields(const RoundedUnstableSurface& s) { return std::tie(s.corners, s.parts); }
inline auto fields(const RegionCorner& c) { return std::tie(c.kind, c.end, c.number); }
inline auto fields(const StableRegion& r) { return std::tie(r.samples, r.limit, r.corners); }
inline auto fields(const Connection& c) { return std::tie(c.from, c.to, c.orbits, c.families); }
inline auto fields(const Explanation& e) {
  return std::tie(e.index, e.sphere, e.contact, e.squared_distance, e.driver, e.clause, e.reason, e.witnesses);
}
inline auto fields(const WidestPath& w) { return std::tie(w.gates); }
inline auto fields(const Pocket& p) {
  return std::tie(p.maxima, p.peaks, p.cell, p.mouths, p.neighbours, p.highest_mouth, p.to_infinity);
}
inline auto fields(const PersistencePair& p) { return std::tie(p.dimension, p.birth, p.death); }
inline auto fields(const HistogramBin& b) { return std::tie(b.from, b.to, b.count); }
inline auto fields(const HistogramValley& v) { return std::tie(v.bin, v.below, v.beyond); }
inline auto fields(const AutomaticThreshold& t) { return std::tie(t.valley); }
inline auto fields(const MedialPoints& m) { return std::tie(m.records, m.automatic_persistence, m.automatic_radius); }
inline auto fields(const PocketPersistence& p) { return std::tie(p.square, p.automatic); }
inline auto fields(const CellSurface& s) { return std::tie(s.vertices, s.triangles); }
inline auto fields(const TriangleEdges& e) {
  return std::tie(e.boundary, e.manifold, e.non_manifold, e.components, e.without_orientation);
}
inline auto fields(const SurfaceMesh& m) {
  return std::tie(m.vertices, m.squared_distances, m.samples, m.triangles, m.set_of_triangle, m.edges);
}
inline auto fields(const LoopWitness& w) { return std::tie(w.surface, w.loop, w.cocycle, w.met); }
inline auto fields(const Void& v) { return std::tie(v.maxima, v.cell, v.walls); }
inline auto fields(const LoopCycle& c) { return std::tie(c.surface, c.edges, c.polygons); }
inline auto fields(const Cycle& c) { return std::tie(c.pair, c.chain); }
inline auto fields(const SurfaceThresholds& t) {
  return std::tie(t.squared_radius_below, t.squared_persistence_above, t.automatic_radius, t.automatic_persistence);
}
inline auto fields(const SelectedSets& s) { return std::tie(s.sets, s.thresholds); }
inline auto fields(const ReadingNote& n) { return std::tie(n.line, n.text); }
inline auto fields(const PointFile& f) { return std::tie(f.rows, f.format, f.notes, f.left_out); }
inline auto fields(const VtpArray& a) { return std::tie(a.name, a.values, a.components); }
inline auto fields(const VtpCells& c) { return std::tie(c.connectivity, c.offsets); }
inline auto fields(const PolyData& d) {
  return std::tie(d.points, d.vertices, d.lines, d.polygons, d.point_data, d.cell_data);
}
inline auto fields(const UnstructuredGrid& g) { return std::tie(g.points, g.cells, g.shapes, g.cell_data); }
inline auto fields(const ClaimedNumber& n) { return std::tie(n.value, n.is_exact); }
inline auto fields(const ClaimedPair& p) { return std::tie(p.dimension, p.birth, p.death, p.line); }
inline auto fields(const ListedPair& p) { return std::tie(p.dimension, p.birth, p.death); }
inline auto fields(const PairDifference& d) {
  return std::tie(d.claimed, d.truth, d.reason, d.dimension, d.is_claimed, d.is_true, d.line);
}
inline auto fields(const PathDifference& d) { return std::tie(d.is_permitted, d.claimed, d.truth); }
inline auto fields(const PathSegment& s) {
  return std::tie(s.type, s.driver, s.end, s.start_contact, s.crossed_contact, s.end_contact);
}
inline auto fields(const PathLimit& l) { return std::tie(l.kind, l.index, l.position, l.contact, l.squared_distance); }
inline auto fields(const OrbitPath& p) { return std::tie(p.segments, p.limit); }
inline auto fields(const Finding& f) {
  return std::tie(f.level, f.reason, f.is_variation, f.clause, f.line, f.contact, f.claimed, f.truth, f.is_decided,
                  f.record);
}
inline auto fields(const CheckReport& r) {
  return std::tie(r.verdict, r.conforms, r.is_exact, r.findings, r.not_judged, r.not_decided, r.claimed_counts,
                  r.true_counts);
}

class ResultText {
 public:
  template <class T>
  void add(const T& value) {
    if constexpr (std::same_as<T, double>) {
      out_ << 'd' << std::hex << std::bit_cast<std::uint64_t>(value) << std::dec << ' ';
    } else if constexpr (std::is_enum_v<T> || std::integral<T>) {
      out_ << static_cast<long long>(value) << ' ';
    } else if constexpr (std::convertible_to<T, std::string>) {
      const std::string text(value);
      out_ << text.size() << ':' << text << ' ';
    } else if constexpr (std::same_as<T, Rational>) {
      out_ << to_text(value) << ' ';
    } else if constexpr (std::ranges::range<T>) {
      out_ << '[' << std::ranges::distance(value) << ' ';
      for (const auto& each : value) add(each);
      out_ << ']';
    } else if constexpr (requires { value.has_value(); }) {
      add(value.has_value());
      if (value) add(*value);
    } else if constexpr (requires { value.valueless_by_exception(); }) {
      std::visit([this](const auto& held) { add(held); }, value);
    } else if constexpr (requires { std::tuple_size<T>::value; }) {
      std::apply([this](const auto&... each) { (add(each), ...); }, value);
    } else {
      out_ << '(';
      std::apply([this](const auto&... each) { (add(each), ...); }, fields(value));
      out_ << ')';
    }
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

template <class T>
std::string result_text(const T& value) {
  ResultText text;
  text.add(value);
  return text.text();
}

}  // namespace flowcert
