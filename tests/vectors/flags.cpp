#include "tests/vectors/flags.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <set>
#include <stdexcept>

#include "oracle/program/read_points.h"
#include "oracle/stable_pieces.h"
#include "tests/vectors/landscape_flags.h"

namespace oracle::vectors {

namespace {

// ---- Of the input

bool is_negative_zero(double value) { return value == 0 && std::signbit(value); }
bool is_subnormal(double value) { return value != 0 && std::abs(value) < DBL_MIN; }
bool is_huge(double value) { return std::abs(value) >= 0x1p+1000; }

bool some_coordinate(const Findings& found, bool (*holds)(double)) {
  for (const Row& row : found.rows) {
    if (std::any_of(row.begin(), row.end(), holds)) return true;
  }
  return false;
}

bool spans(const Findings& found, int dimension, std::size_t least_points) {
  return found.set.points.size() >= least_points && affine_dimension(found.set.points) == dimension;
}

// Whether the values are equally spaced. Nothing iff there is one value.
bool are_equally_spaced(const std::set<Rational>& values, std::optional<Rational>& step) {
  for (auto next = values.begin(), value = next++; next != values.end(); value = next++) {
    const Rational difference = *next - *value;
    if (step && *step != difference) return false;
    step = difference;
  }
  return true;
}

// So many different points of a box of that many places are all of it.
bool is_whole_lattice(const Findings& found) {
  std::array<std::set<Rational>, 3> values;
  for (const Point& p : found.set.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) values[axis].insert(p[axis]);
  }
  const std::size_t k = values[0].size();
  std::optional<Rational> step;
  return k > 0 && values[1].size() == k && values[2].size() == k && found.set.points.size() == k * k * k &&
         are_equally_spaced(values[0], step) && are_equally_spaced(values[1], step) &&
         are_equally_spaced(values[2], step);
}

bool is_few(const Findings& found) { return !found.set.points.empty() && found.set.points.size() < 4; }

bool has_mixed_magnitudes(const Findings& found) {
  constexpr int kBinades = 100;
  int least = DBL_MAX_EXP, most = -DBL_MAX_EXP * 2;
  for (const Row& row : found.rows) {
    for (const double value : row) {
      if (value == 0) continue;
      least = std::min(least, std::ilogb(value));
      most = std::max(most, std::ilogb(value));
    }
  }
  return most - least > kBinades;
}

// A million times as far from the origin as the points are from each other.
bool is_far_away(const Findings& found) {
  if (found.set.points.size() < 2) return false;
  double extent = 0, distance = 0;
  for (const Row& row : found.rows) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      extent = std::max(extent, std::abs(row[axis] - found.rows[0][axis]));
      distance = std::max(distance, std::abs(row[axis]));
    }
  }
  return distance >= std::ldexp(extent, 20);
}

// ---- Of the stationary points

bool is_regular(const StationaryPoint& x) { return x.face_dimension != x.hull_dimension; }
bool is_maximum(const StationaryPoint& x) { return !is_regular(x) && x.hull_dimension == 3; }
bool is_saddle(const StationaryPoint& x) { return !is_regular(x) && x.hull_dimension < 3; }

// More points than an affinely independent set of their dimension has.
bool is_cluster(const StationaryPoint& x) { return x.contact.size() > static_cast<std::size_t>(x.hull_dimension) + 1; }

bool some_kind(const Findings& found, int face, int hull) {
  for (const StationaryPoint& x : found.answer.stationary) {
    if (x.face_dimension == face && x.hull_dimension == hull) return true;
  }
  return false;
}

bool some_critical_cluster(const Findings& found, int index) {
  for (const StationaryPoint& x : found.answer.stationary) {
    if (!is_regular(x) && x.hull_dimension == index && is_cluster(x)) return true;
  }
  return false;
}

bool some_regular_cluster(const Findings& found) {
  for (const StationaryPoint& x : found.answer.stationary) {
    if (is_regular(x) && is_cluster(x)) return true;
  }
  return false;
}

// ---- Of the orbits, those of U2 included

bool some_orbit(const Findings& found, bool (*holds)(const PointSet&, const Orbit&)) {
  for (const Orbit& path : found.orbits) {
    if (holds(found.set, path)) return true;
  }
  for (const auto& two : found.unstable) {
    if (holds(found.set, two[0]) || holds(found.set, two[1])) return true;
  }
  return false;
}

bool moves_to_a_point(const Orbit& path) { return !path.segments.empty() && path.limit; }

bool goes_to_maximum(const PointSet&, const Orbit& path) { return moves_to_a_point(path) && is_maximum(*path.limit); }
bool goes_to_saddle(const PointSet&, const Orbit& path) { return moves_to_a_point(path) && is_saddle(*path.limit); }
bool goes_to_regular(const PointSet&, const Orbit& path) { return moves_to_a_point(path) && is_regular(*path.limit); }
bool goes_to_infinity(const PointSet&, const Orbit& path) { return !path.limit; }

bool passes_a_vertex(const PointSet& set, const Orbit& path) {
  for (std::size_t k = 1; k < path.segments.size(); ++k) {
    if (face_letter(set, path.segments[k].start_contact) == 'V') return true;
  }
  return false;
}

// The longest run of segments of which all are so.
std::size_t longest_run(const PointSet& set, const Orbit& path, bool (*holds)(const PointSet&, const FlowSegment&)) {
  std::size_t longest = 0, run = 0;
  for (const FlowSegment& segment : path.segments) {
    run = holds(set, segment) ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

bool crosses_edge(const PointSet& set, const FlowSegment& segment) {
  return face_letter(set, segment.crossed_contact) == 'E';
}
bool crosses_facet_to_edge(const PointSet& set, const FlowSegment& segment) {
  return face_letter(set, segment.crossed_contact) == 'F' && segment.end &&
         face_letter(set, segment.end_contact) == 'E';
}

bool crosses_edges_in_a_row(const PointSet& set, const Orbit& path) {
  return longest_run(set, path, crosses_edge) >= 2;
}
bool crosses_facets_in_a_row(const PointSet& set, const Orbit& path) {
  return longest_run(set, path, crosses_facet_to_edge) >= 3;
}

bool some_start(const Findings& found, char letter) {
  for (std::size_t k = 0; k < found.orbits.size(); ++k) {
    if (found.orbits[k].segments.empty()) continue;
    if (face_letter(found.set, contact_set(found.set, found.starts[k])) == letter) return true;
  }
  return false;
}

bool has_stationary_start(const Findings& found) {
  for (const Orbit& path : found.orbits) {
    if (path.segments.empty()) return true;
  }
  return false;
}

bool has_changing_driver(const Findings& found) {
  return std::any_of(found.orbits.begin(), found.orbits.end(),
                     [](const Orbit& path) { return path.segments.size() > 1; });
}

// Whether x is inside of the segment. A segment without an end goes on for ever.
bool is_inside(const FlowSegment& segment, const Point& x) {
  const Point way = segment.end ? minus(*segment.end, segment.start) : minus(segment.start, segment.driver);
  const Point to_x = minus(x, segment.start);
  const Rational along = dot(way, to_x);
  return cross(way, to_x) == Point{0, 0, 0} && along > 0 && (!segment.end || along < dot(way, way));
}

bool has_start_inside_a_segment(const Findings& found) {
  for (const Orbit& path : found.orbits) {
    for (const FlowSegment& segment : path.segments) {
      for (const Point& start : found.starts) {
        if (is_inside(segment, start)) return true;
      }
    }
  }
  return false;
}

bool has_saddle_with_one_limit(const Findings& found) {
  for (const auto& two : found.unstable) {
    if (two[0].limit == two[1].limit) return true;
  }
  return false;
}

// ---- Of stable sets, and of persistence pairs

bool has_vertex(const StableSet& set) { return set.has_vertex; }
bool has_interval(const StableSet& set) { return !set.intervals.empty(); }

bool has_cut_sector(const StableSet& set) {
  for (const Region& sector : set.sectors) {
    if (sector.corners.size() > 3) return true;
  }
  return false;
}

// To which only intervals or sectors lead (FC-STAB-11).
bool has_uncounted_segment(const Findings& found) {
  return std::any_of(found.stable.begin(), found.stable.end(), [&](const auto& place_and_set) {
    const auto& [place, set] = place_and_set;
    return segments_without_intervals(found.answer.stationary[place], set) < set.segments.size();
  });
}

bool has_walk(const StableSet& set) { return !set.has_vertex; }
bool has_determined_boundary(const Findings& found) {
  return std::any_of(found.stable.begin(), found.stable.end(), [&](const auto& place_and_set) {
    const auto& [place, set] = place_and_set;
    return is_saddle(found.answer.stationary[place]) && !has_tie(set);
  });
}

bool has_back(const StableSet& set, BackKind kind) {
  for (const BackwardSegment& segment : set.segments) {
    if (segment.back_kind == kind) return true;
  }
  return false;
}
bool has_edge_back(const StableSet& set) { return has_back(set, BackKind::kEdge); }
bool has_regular_back(const StableSet& set) { return has_back(set, BackKind::kRegular); }

bool some_stable_set(const Findings& found, bool (*holds)(const StableSet&)) {
  for (const auto& place_and_set : found.stable) {
    if (holds(place_and_set.second)) return true;
  }
  return false;
}

bool some_pair(const Findings& found, int dimension) {
  for (const PersistencePair& pair : found.persistence) {
    if (pair.dimension == dimension) return true;
  }
  return false;
}

bool has_equal_pairs(const Findings& found) {
  return std::adjacent_find(found.persistence.begin(), found.persistence.end()) != found.persistence.end();
}

// ---- Of λ-lists, connections and volumes

bool some_entry(const Findings& found, bool (*holds)(const UnstableEntry&)) {
  for (const auto& place_and_list : found.lambda) {
    for (const UnstableEntry& entry : place_and_list.second) {
      if (holds(entry)) return true;
    }
  }
  return false;
}

bool is_whole_circle(const UnstableEntry& entry) { return entry.is_arc && !entry.from; }
bool is_arc_to_infinity(const UnstableEntry& entry) { return entry.is_arc && !entry.limit; }
bool is_arc_to_no_maximum(const UnstableEntry& entry) {
  return entry.is_arc && entry.limit && !is_maximum(*entry.limit);
}

// A list that goes around a circle is left out, because there each arc may have its ends.
bool has_closed_arc(const Findings& found) {
  for (const auto& [place, list] : found.lambda) {
    if (!is_regular(found.answer.stationary[place])) continue;
    for (std::size_t k = 1; k < list.size(); ++k) {
      if (list[k].is_arc != list[k - 1].is_arc && list[k].limit == list[k - 1].limit) return true;
    }
  }
  return false;
}

bool some_connection(const Findings& found, bool (*holds)(const Connection&)) {
  return std::any_of(found.connections.begin(), found.connections.end(), holds);
}

bool leads_between_saddles(const Connection& one) {
  return one.from.is_critical() && one.from.hull_dimension == 2 && one.to && one.to->is_critical() &&
         one.to->hull_dimension == 2;
}
bool leads_to_regular(const Connection& one) { return one.to && is_regular(*one.to); }
bool leads_there_twice(const Connection& one) { return one.directions + one.arcs >= 2; }

bool some_volume(const Findings& found, bool (*holds)(const StationaryPoint&)) {
  for (std::size_t i = 0; i < found.volumes.size(); ++i) {
    if (found.volumes[i].volume != 0 && holds(found.answer.stationary[i])) return true;
  }
  return false;
}

// ---- Of unstable sets

template <class Part>
bool some_part(const Findings& found, std::vector<Part> UnstableSurface::* parts, bool (*holds)(const Part&)) {
  return std::any_of(found.surfaces.begin(), found.surfaces.end(), [&](const auto& place_and_surface) {
    const std::vector<Part>& all = place_and_surface.second.*parts;
    return std::any_of(all.begin(), all.end(), holds);
  });
}

bool is_any_run(const EdgePart&) { return true; }
bool is_any_ray(const Crossing&) { return true; }
bool is_single_point(const EdgePart& trace) { return trace.front == trace.back; }
bool has_two_sheets(const Findings& found) {
  return std::any_of(found.surfaces.begin(), found.surfaces.end(),
                     [](const auto& place_and_surface) { return place_and_surface.second.sheets.size() >= 2; });
}

// ---- The table

constexpr Flag kFlags[] = {
    // ---- Aims
    {"general-position", "Random coordinates of 53 bits: no ties by intention.", "FC-CRIT-05", nullptr},
    {"lattice", "Points of a small integer lattice, where ties of all sorts are common.", "FC-CRIT-03 FC-VOR-01",
     nullptr},
    {"scan", "A surface rounded to a grid, as scanners and depth images are.", "FC-VOR-01", nullptr},
    {"cospherical", "More than four points of one sphere, of which a Delaunay triangulation has several.",
     "FC-VOR-01 FC-VOR-04", nullptr},
    {"cocircular", "More than three points of one circle: a Voronoi edge's polygon that is no triangle.",
     "FC-VOR-02 FC-VOR-04", nullptr},
    {"right-angle", "Right angles by construction.", "FC-SIGN-01 FC-SIGN-04", nullptr},
    {"rounded", "An exact configuration whose coordinates had to be rounded: nearly degenerate.", "FC-NUM-01", nullptr},
    {"single-precision", "Rounded to 32-bit floats.", "FC-IN-02 FC-NUM-01", nullptr},
    {"one-ulp", "An exact configuration with coordinates moved to the neighbouring double.", "FC-NUM-01", nullptr},
    {"exact-of-three", "The exact one of three cases: the next two have one coordinate one ulp up and down.",
     "FC-NUM-01", nullptr},
    {"extreme-scale", "Scaled by a power of two to an end of the range of doubles.", "FC-INV-04", nullptr},
    {"high-degree-facet", "An edge whose Voronoi facet has many sides.", "FC-VOR-03 FC-FLOW-01", nullptr},
    {"half-shell", "A sampled surface, open at the top: orbits run along its inside.", "FC-FLOW-05 FC-FLOW-07",
     nullptr},
    {"cascade", "Two combs between which the flow crosses facet after facet.", "FC-FLOW-05", nullptr},
    {"right-angle-chain", "Right triangles about one axis.", "FC-SIGN-04 FC-FLOW-01", nullptr},
    {"symmetric", "Points symmetric to an axis or to planes.", "FC-FLOW-06", nullptr},
    {"not-finite", "A coordinate is NaN or infinite.", "FC-IN-01", nullptr},
    {"overflow", "A number whose nearest double is infinite.", "FC-IN-01", nullptr},
    {"inexact-hex", "A hexadecimal float that is no double.", "FC-IN-02", nullptr},
    {"no-number", "A word where a number should be.", "FC-IN-05", nullptr},
    {"short-row", "A row with too few numbers.", "FC-IN-05", nullptr},
    {"nothing-to-read", "A file of nothing but white space.", "FC-IN-05", nullptr},
    {"bad-start", "The points are right, but the start of the orbit is no position.", "FC-FLOW-05", nullptr},
    {"start-not-finite", "A coordinate of the start is not finite, or beyond the doubles.", "FC-LOC-02", nullptr},
    {"no-points", "The start is right, but there are no points.", "FC-FLOW-10 FC-LOC-02", nullptr},
    {"mirror-image", "The case before it, but x has the other sign.", "FC-FLOW-11 FC-INV-04", nullptr},
    {"renamed", "The case before it, but its rows are in reversed order.", "FC-FLOW-11 FC-INV-04", nullptr},
    {"scaled-copy", "The case before it, times a power of two.", "FC-INV-04 FC-POCK-10", nullptr},
    // ---- Of the input
    {"empty", "No point.", "FC-IN-04", [](const Findings& found) { return found.rows.empty(); }},
    {"few-points", "One, two or three different points.", "FC-IN-04", is_few},
    {"many-points", "20 different points or more.", "FC-CRIT-05",
     [](const Findings& found) { return found.set.points.size() >= 20; }},
    {"collinear", "Three different points or more, on a line.", "FC-IN-04 FC-VOR-03",
     [](const Findings& found) { return spans(found, 1, 3); }},
    {"coplanar", "Four different points or more, in a plane.", "FC-IN-04 FC-VOR-02",
     [](const Findings& found) { return spans(found, 2, 4); }},
    {"one-tetrahedron", "Four different points that span space.", "FC-INV-03",
     [](const Findings& found) { return spans(found, 3, 4) && found.set.points.size() == 4; }},
    {"whole-lattice", "All of the lattice {1..k}^3 for some k, up to a translation and the scale.", "FC-INV-05",
     is_whole_lattice},
    {"duplicates", "Rows with equal coordinates.", "FC-IN-03",
     [](const Findings& found) { return found.answer.merged_duplicates > 0; }},
    {"negative-zero", "A coordinate is -0.", "FC-IN-02",
     [](const Findings& found) { return some_coordinate(found, is_negative_zero); }},
    {"subnormal", "A coordinate is subnormal.", "FC-IN-04",
     [](const Findings& found) { return some_coordinate(found, is_subnormal); }},
    {"near-overflow", "A coordinate is 2^1000 or more in magnitude.", "FC-IN-04 FC-NUM-02",
     [](const Findings& found) { return some_coordinate(found, is_huge); }},
    {"mixed-magnitudes", "Coordinates that differ by a factor of more than 2^100.", "FC-IN-04", has_mixed_magnitudes},
    {"far-away", "2^20 times as far from the origin as the points are from the first.", "FC-INV-04", is_far_away},
    // ---- Of the stationary points
    {"polygon-saddle", "A critical point of index 2 with more than three contact points.",
     "FC-CRIT-02 FC-SIGN-03 FC-CLAIM-02", [](const Findings& found) { return some_critical_cluster(found, 2); }},
    {"polytope-maximum", "A critical point of index 3 with more than four contact points.",
     "FC-CRIT-02 FC-SIGN-03 FC-CLAIM-02", [](const Findings& found) { return some_critical_cluster(found, 3); }},
    {"kind-1-2", "A regular stationary point of kind 1-2.", "FC-CRIT-03 FC-INV-02 FC-CLAIM-04",
     [](const Findings& found) { return some_kind(found, 1, 2); }},
    {"kind-2-3", "A regular stationary point of kind 2-3.", "FC-CRIT-03 FC-INV-02 FC-CLAIM-04",
     [](const Findings& found) { return some_kind(found, 2, 3); }},
    {"kind-1-3", "A regular stationary point of kind 1-3.", "FC-CRIT-03 FC-INV-02 FC-CLAIM-04",
     [](const Findings& found) { return some_kind(found, 1, 3); }},
    {"cluster-at-regular", "A regular stationary point with more contact points than a simplex has.",
     "FC-CRIT-03 FC-SIGN-04", some_regular_cluster},
    // ---- Of the orbits
    {"from-vertex", "An orbit that moves on from a Voronoi vertex.", "FC-FLOW-02 FC-STAB-09",
     [](const Findings& found) { return some_start(found, 'V'); }},
    {"from-edge", "An orbit from inside a Voronoi edge.", "FC-FLOW-02 FC-STAB-09",
     [](const Findings& found) { return some_start(found, 'E'); }},
    {"from-facet", "An orbit from inside a Voronoi facet.", "FC-FLOW-02 FC-STAB-09",
     [](const Findings& found) { return some_start(found, 'F'); }},
    {"from-cell", "An orbit from inside a Voronoi cell.", "FC-FLOW-02",
     [](const Findings& found) { return some_start(found, 'C'); }},
    {"stationary-start", "An orbit that stays.", "FC-FLOW-03", has_stationary_start},
    {"to-maximum", "An orbit that ends at a maximum.", "FC-FLOW-05",
     [](const Findings& found) { return some_orbit(found, goes_to_maximum); }},
    {"to-saddle", "An orbit that moves and ends at a critical point of index 1 or 2.", "FC-FLOW-05",
     [](const Findings& found) { return some_orbit(found, goes_to_saddle); }},
    {"to-regular", "An orbit that moves and ends at a regular stationary point.", "FC-FLOW-05",
     [](const Findings& found) { return some_orbit(found, goes_to_regular); }},
    {"to-infinity", "An orbit that ends at infinity.", "FC-FLOW-05",
     [](const Findings& found) { return some_orbit(found, goes_to_infinity); }},
    {"through-vertex", "An orbit that passes through a Voronoi vertex.", "FC-FLOW-02 FC-FLOW-08",
     [](const Findings& found) { return some_orbit(found, passes_a_vertex); }},
    {"along-edges", "An orbit that runs along two Voronoi edges or more, one after the other.", "FC-FLOW-01 FC-FLOW-02",
     [](const Findings& found) { return some_orbit(found, crosses_edges_in_a_row); }},
    {"across-facets", "An orbit that crosses three Voronoi facets or more, from edge to edge.", "FC-FLOW-01 FC-FLOW-05",
     [](const Findings& found) { return some_orbit(found, crosses_facets_in_a_row); }},
    {"driver-changes", "An orbit from a listed start that has two segments or more.", "FC-FLOW-05 FC-FLOW-09",
     has_changing_driver},
    {"start-inside-a-segment", "A start inside of a segment of the orbit from another start.", "FC-FLOW-04 FC-FLOW-08",
     has_start_inside_a_segment},
    {"one-limit", "A critical point of index 2 both of whose limits are the same.", "FC-FLOW-07",
     has_saddle_with_one_limit},
    // ---- Of stable sets
    {"edge-back", "A listed stable set in which a backward segment ends inside a Voronoi edge, where it branches.",
     "FC-STAB-04 FC-STAB-06", [](const Findings& found) { return some_stable_set(found, has_edge_back); }},
    {"regular-back", "A listed stable set in which a backward segment ends at a regular stationary point.",
     "FC-STAB-04 FC-CHAIN-02", [](const Findings& found) { return some_stable_set(found, has_regular_back); }},
    {"skeleton-vertex", "A listed stable set with a Voronoi vertex in its skeleton.",
     "FC-STAB-03 FC-STAB-06 FC-CHAIN-02", [](const Findings& found) { return some_stable_set(found, has_vertex); }},
    {"skeleton-interval", "A listed stable set with an interval in its skeleton: a part of it has dimension 3.",
     "FC-STAB-05 FC-STAB-06", [](const Findings& found) { return some_stable_set(found, has_interval); }},
    {"cut-sector", "A listed stable set with a sector that is no triangle: its rays leave the Voronoi facet.",
     "FC-STAB-05", [](const Findings& found) { return some_stable_set(found, has_cut_sector); }},
    {"uncounted-segment", "A listed stable set with a segment to which only intervals or sectors lead.",
     "FC-STAB-05 FC-STAB-11", has_uncounted_segment},
    {"walk", "A listed boundary walk.", "FC-STAB-07 FC-STAB-10",
     [](const Findings& found) { return some_stable_set(found, has_walk); }},
    {"determined-boundary", "A listed boundary of a critical point of index 2.", "FC-CHAIN-01 FC-CHAIN-03",
     has_determined_boundary},
    // ---- Of persistence pairs
    {"tunnel", "A listed persistence pair of dimension 1.", "FC-PERS-01 FC-PERS-05",
     [](const Findings& found) { return some_pair(found, 1); }},
    {"void", "A listed persistence pair of dimension 2.", "FC-PERS-01 FC-PERS-05",
     [](const Findings& found) { return some_pair(found, 2); }},
    {"equal-pairs", "Two listed persistence pairs of the same dimension, birth and death.", "FC-PERS-01 FC-PERS-04",
     has_equal_pairs},
    // ---- Of λ-lists, connections and volumes
    {"whole-circle", "A listed λ-list that is one arc: all directions have one limit.", "FC-UNST-02",
     [](const Findings& found) { return some_entry(found, is_whole_circle); }},
    {"arc-to-infinity", "A listed λ-list with an arc that leads to infinity.", "FC-UNST-02",
     [](const Findings& found) { return some_entry(found, is_arc_to_infinity); }},
    {"arc-to-no-maximum", "A listed λ-list with an arc that leads to a critical point of index 2 or a regular one.",
     "FC-UNST-02 FC-UNST-03", [](const Findings& found) { return some_entry(found, is_arc_to_no_maximum); }},
    {"end-of-arc", "A listed λ-list of kind 1-2 or 1-3 with a direction beside an arc of its own limit.",
     "FC-UNST-01 FC-UNST-02", has_closed_arc},
    {"morse-smale", "The case says that the input is Morse-Smale.", "FC-CONN-03",
     [](const Findings& found) { return found.morse_smale.value_or(false); }},
    {"saddle-to-saddle", "A listed connection from a critical point of index 2 to another one.", "FC-CONN-01",
     [](const Findings& found) { return some_connection(found, leads_between_saddles); }},
    {"connection-to-regular", "A listed connection to a regular stationary point.", "FC-CONN-01 FC-CONN-03",
     [](const Findings& found) { return some_connection(found, leads_to_regular); }},
    {"double-connection", "A listed connection in two ways or more, from one point to the same point or to infinity.",
     "FC-CONN-01 FC-CONN-02", [](const Findings& found) { return some_connection(found, leads_there_twice); }},
    {"maximum-volume", "A listed volume of a maximum.", "FC-VOL-01 FC-VOL-02",
     [](const Findings& found) { return some_volume(found, is_maximum); }},
    {"saddle-volume", "A listed volume of a critical point of index 2 that is positive.", "FC-VOL-01 FC-STAB-05",
     [](const Findings& found) { return some_volume(found, is_saddle); }},
    {"regular-volume", "A listed volume of a regular stationary point that is positive.", "FC-VOL-01 FC-STAB-05",
     [](const Findings& found) { return some_volume(found, is_regular); }},
    // ---- Of unstable sets
    {"fan", "A listed unstable set with two sheets or more.", "FC-UNST-04 FC-UNST-05", has_two_sheets},
    {"unbounded-sheet", "A listed sheet with a corner at infinity.", "FC-UNST-04",
     [](const Findings& found) { return some_part(found, &UnstableSurface::sheets, is_unbounded); }},
    {"run", "A listed run.", "FC-UNST-04 FC-UNST-05",
     [](const Findings& found) { return some_part(found, &UnstableSurface::runs, is_any_run); }},
    {"single-ray", "A listed segment: a single ray that crosses a facet.", "FC-UNST-04 FC-UNST-05",
     [](const Findings& found) { return some_part(found, &UnstableSurface::segments, is_any_ray); }},
    {"trace-of-a-point", "A listed trace that is one point.", "FC-UNST-04 FC-UNST-05",
     [](const Findings& found) { return some_part(found, &UnstableSurface::traces, is_single_point); }},
    // ---- Of locations
    {"own-location", "A listed position that is its own location.", "FC-LOC-01", has_location_at_start},
    {"located-at-regular", "A location that is regular stationary, of another position.", "FC-LOC-01",
     has_location_at_regular},
    {"located-at-infinity", "A location that is infinity.", "FC-LOC-01 FC-STAB-08", has_location_at_infinity},
    {"several-nearest", "A listed position with several nearest samples.", "FC-DIST-01 FC-LOC-01 FC-STAB-09",
     has_several_nearest},
    {"on-one-ray", "Two listed positions on one ray from a sample, in its closed Voronoi cell.", "FC-LOC-03",
     has_two_on_a_ray},
    // ---- Of merge trees
    {"three-pockets-join", "A node of the tree of pockets with three parts or more.", "FC-TREE-02 FC-TREE-05",
     joins_three_pockets},
    {"three-components-join", "A node of the tree of components with three parts or more.", "FC-TREE-06",
     joins_three_components},
    {"more-gates", "A node of the tree of pockets that as many gates join as it has parts, or more.", "FC-TREE-03",
     has_gates_beyond_need},
    {"nodes-of-one-value", "Two nodes of one tree and one value.", "FC-TREE-07", has_two_nodes_of_a_value},
    {"several-nodes", "Two nodes or more in the tree of pockets.", "FC-TREE-01 FC-TREE-02 FC-TREE-04",
     has_node_of_nodes},
    {"infinity-alone", "A tree of pockets whose only leaf is infinity.", "FC-TREE-02 FC-TREE-04", has_only_infinity},
    // ---- Of pockets
    {"listed-pocket", "A listed pocket.", "FC-POCK-01 FC-POCK-03 FC-POCK-04 FC-POCK-05 FC-POCK-07 FC-POCK-08",
     lists_pocket},
    {"no-pocket", "A persistence at which no pocket is listed.", "FC-POCK-07 FC-POCK-08", lists_no_pocket},
    {"merged-pocket", "A listed pocket with two maxima or more.", "FC-POCK-02", has_merged_pocket},
    {"merged-outside", "A maximum that belongs to the outside.", "FC-POCK-02 FC-POCK-08", has_merged_outside},
    {"stays-apart", "A listed pocket that is not deeper than the persistence.", "FC-POCK-02 FC-POCK-09",
     has_pocket_apart},
    {"several-peaks", "A listed pocket with two peaks or more.", "FC-POCK-05", has_several_peaks},
    {"wider-cell", "A listed cell to which more than its maxima belong.", "FC-POCK-01 FC-POCK-03", has_wider_cell},
    {"neighbour-pocket", "A listed pocket that has another pocket as its neighbour.", "FC-POCK-04",
     has_neighbour_pocket},
    {"several-gates", "A listed pocket whose widest path has two gates or more.", "FC-POCK-07", has_several_gates},
    {"several-largest-balls", "Two largest balls or more.", "FC-POCK-08", has_several_largest_balls},
    {"probe-cavity", "A pocket that is a cavity for a listed probe.", "FC-POCK-06", has_cavity},
    {"probe-pocket", "A pocket that is one in the narrow sense for a listed probe.", "FC-POCK-06", has_narrow_pocket},
    {"probe-channel", "A pocket that is a channel for a listed probe.", "FC-POCK-06", has_channel},
    {"passes-exactly", "A probe that is just as wide as the widest path of a pocket.", "FC-POCK-06", passes_exactly},
    // ---- Of the medial axis
    {"angle-at-bound", "A critical point of index 2 whose angle is just 120 or 180 degrees.", "FC-MED-02",
     has_angle_at_bound},
    {"angle-between", "Critical points of index 2 that some listed angles of 120 degrees and more tell apart.",
     "FC-MED-01 FC-MED-02", has_angle_between},
    {"open-choice", "A persistence above which some points of one index and value are, and others are not.",
     "FC-MED-03 FC-PERS-04", leaves_choice},
    // ---- Of infinity
    {"bounded-piece", "A listed skeleton of infinity with a segment or sector that has no end at infinity.",
     "FC-STAB-08", has_bounded_piece},
    {"two-far-corners", "A listed sector with two corners at infinity.", "FC-STAB-08", has_sector_of_two_ends},
    {"ray-from-regular", "A listed ray to infinity whose back is regular stationary.", "FC-STAB-08",
     has_ray_from_regular},
    // ---- Of statistics
    {"run-of-constructed", "A listed cascade.", "FC-STAT-01", has_cascade},
    {"long-connecting-orbit", "A connecting orbit of two segments or more.", "FC-STAT-01 FC-STAB-06",
     has_long_connecting_orbit},
};

}  // namespace

std::span<const Flag> all_flags() { return kFlags; }

std::vector<std::string> flags_of(const Findings& findings, const std::vector<std::string>& aims) {
  std::set<std::string> open(aims.begin(), aims.end());
  std::vector<std::string> flags;
  for (const Flag& flag : kFlags) {
    if (flag.holds ? flag.holds(findings) : open.erase(flag.name) > 0) flags.emplace_back(flag.name);
  }
  if (!open.empty()) throw std::logic_error(*open.begin() + " is no aim");
  return flags;
}

std::vector<std::string> clauses_of(const std::vector<std::string>& flags, std::vector<std::string> more) {
  for (const Flag& flag : kFlags) {
    if (std::find(flags.begin(), flags.end(), flag.name) == flags.end()) continue;
    for (const std::string& clause : fields(flag.clauses)) more.push_back(clause);
  }
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  return more;
}

}  // namespace oracle::vectors
