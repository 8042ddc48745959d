// See flags.h.
#include "oracle/vectors/flags.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

namespace oracle::vectors {

namespace {

// Nothing to decide by: an aim.
using Holds = std::function<bool(const Rows&, const Findings&)>;

struct Definition {
  Flag flag;
  Holds holds;
};

// ---- Of the input

bool any_coordinate(const Rows& rows, const std::function<bool(double)>& holds) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const Row& row) { return std::any_of(row.begin(), row.end(), holds); });
}

Holds some_coordinate(const std::function<bool(double)>& holds) {
  return [holds](const Rows& rows, const Findings&) { return any_coordinate(rows, holds); };
}

Holds spans(int dimension, std::size_t least_points) {
  return [=](const Rows&, const Findings& found) {
    return found.set.points.size() >= least_points && affine_dimension(found.set.points) == dimension;
  };
}

bool has_mixed_magnitudes(const Rows& rows, const Findings&) {
  constexpr int kBinades = 100;
  int least = DBL_MAX_EXP, most = -DBL_MAX_EXP * 2;
  any_coordinate(rows, [&](double value) {
    if (value != 0) {
      least = std::min(least, std::ilogb(value));
      most = std::max(most, std::ilogb(value));
    }
    return false;
  });
  return most - least > kBinades;
}

// A million times as far from the origin as the points are from each other.
bool is_far_away(const Rows& rows, const Findings& found) {
  if (found.set.points.size() < 2) return false;
  double extent = 0, distance = 0;
  for (const Row& row : rows) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      extent = std::max(extent, std::abs(row[axis] - rows[0][axis]));
      distance = std::max(distance, std::abs(row[axis]));
    }
  }
  return distance >= std::ldexp(extent, 20);
}

// ---- Of the stationary points

Holds some_stationary(const std::function<bool(const StationaryPoint&)>& holds) {
  return [holds](const Rows&, const Findings& found) {
    return std::any_of(found.answer.stationary.begin(), found.answer.stationary.end(), holds);
  };
}

Holds some_kind(int face, int hull) {
  return some_stationary([=](const StationaryPoint& x) {
    return x.face_dimension == face && x.hull_dimension == hull && face != hull;
  });
}

// More points than an affinely independent set of their dimension has.
bool is_cluster(const StationaryPoint& x) {
  return x.contact.size() > static_cast<std::size_t>(x.hull_dimension) + 1;
}

Holds some_cluster(int hull) {
  return some_stationary([=](const StationaryPoint& x) {
    return x.face_dimension == hull && x.hull_dimension == hull && is_cluster(x);
  });
}

// ---- Of the orbits, those of U2 included

Holds some_orbit(const std::function<bool(const PointSet&, const Orbit&)>& holds) {
  return [holds](const Rows&, const Findings& found) {
    const auto right = [&](const Orbit& path) { return holds(found.set, path); };
    return std::any_of(found.orbits.begin(), found.orbits.end(), right) ||
           std::any_of(found.unstable.begin(), found.unstable.end(),
                       [&](const auto& two) { return right(two[0]) || right(two[1]); });
  };
}

// The longest run of segments of which all are so.
std::size_t longest_run(const Orbit& path, const std::function<bool(const FlowSegment&)>& holds) {
  std::size_t longest = 0, run = 0;
  for (const FlowSegment& segment : path.segments) {
    run = holds(segment) ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

bool passes_a_vertex(const PointSet& set, const Orbit& path) {
  for (std::size_t k = 1; k < path.segments.size(); ++k) {
    if (face_letter(set, path.segments[k].start_contact) == 'V') return true;
  }
  return false;
}

bool crosses_edges_in_a_row(const PointSet& set, const Orbit& path) {
  return longest_run(path, [&](const FlowSegment& segment) {
           return face_letter(set, segment.crossed_contact) == 'E';
         }) >= 2;
}

bool crosses_facets_in_a_row(const PointSet& set, const Orbit& path) {
  constexpr std::size_t kCascade = 3;
  return longest_run(path, [&](const FlowSegment& segment) {
           return face_letter(set, segment.crossed_contact) == 'F' && segment.end &&
                  face_letter(set, segment.end_contact) == 'E';
         }) >= kCascade;
}

bool ends_at(const Orbit& path, const std::function<bool(const StationaryPoint&)>& holds) {
  return !path.segments.empty() && path.limit && holds(*path.limit);
}

Holds some_limit(const std::function<bool(const StationaryPoint&)>& holds) {
  return some_orbit([holds](const PointSet&, const Orbit& path) { return ends_at(path, holds); });
}

Holds some_start(char letter) {
  return [letter](const Rows&, const Findings& found) {
    for (std::size_t k = 0; k < found.starts.size(); ++k) {
      if (!found.orbits[k].segments.empty() &&
          face_letter(found.set, contact_set(found.set, found.starts[k])) == letter) {
        return true;
      }
    }
    return false;
  };
}

bool has_stationary_start(const Rows&, const Findings& found) {
  return std::any_of(found.orbits.begin(), found.orbits.end(),
                     [](const Orbit& path) { return path.segments.empty(); });
}

bool has_saddle_with_one_limit(const Rows&, const Findings& found) {
  return std::any_of(found.unstable.begin(), found.unstable.end(),
                     [](const auto& two) { return two[0].limit == two[1].limit; });
}

// ---- Of stable sets, and of persistence pairs

Holds some_stable_set(const std::function<bool(const StableSet&)>& holds) {
  return [holds](const Rows&, const Findings& found) {
    return std::any_of(found.stable.begin(), found.stable.end(),
                       [&](const auto& set) { return holds(set.second); });
  };
}

Holds some_back(BackKind kind) {
  return some_stable_set([kind](const StableSet& set) {
    return std::any_of(set.segments.begin(), set.segments.end(),
                       [&](const BackwardSegment& segment) { return segment.back_kind == kind; });
  });
}

Holds some_class(int dimension) {
  return [dimension](const Rows&, const Findings& found) {
    return found.persistence &&
           std::any_of(found.persistence->begin(), found.persistence->end(),
                       [&](const PersistencePair& pair) { return pair.dimension == dimension; });
  };
}

bool has_equal_pairs(const Rows&, const Findings& found) {
  return found.persistence &&
         std::adjacent_find(found.persistence->begin(), found.persistence->end()) != found.persistence->end();
}

bool is_regular(const StationaryPoint& x) { return x.face_dimension != x.hull_dimension; }

std::vector<Definition> aims() {
  return {
      {{"general-position", "Random coordinates of 53 bits: no ties by intention.", {"FC-CRIT-05"}}, {}},
      {{"lattice",
        "Points of a small integer lattice, where ties of all sorts are common.",
        {"FC-CRIT-03", "FC-VOR-01"}},
       {}},
      {{"scan", "A surface rounded to a grid, as scanners and depth images are.", {"FC-VOR-01"}}, {}},
      {{"cospherical",
        "More than four points of one sphere, of which a Delaunay triangulation has several.",
        {"FC-VOR-01", "FC-VOR-04"}},
       {}},
      {{"cocircular",
        "More than three points of one circle: a Voronoi edge's polygon that is no triangle.",
        {"FC-VOR-02", "FC-VOR-04"}},
       {}},
      {{"right-angle", "Right angles by construction.", {"FC-SIGN-01", "FC-SIGN-04"}}, {}},
      {{"rounded",
        "An exact configuration whose coordinates had to be rounded: nearly degenerate.",
        {"FC-NUM-01"}},
       {}},
      {{"single-precision", "Rounded to 32-bit floats.", {"FC-IN-02", "FC-NUM-01"}}, {}},
      {{"one-ulp",
        "An exact configuration with coordinates moved to the neighbouring double.",
        {"FC-NUM-01"}},
       {}},
      {{"exact-of-three",
        "The exact one of three cases: the next two have one coordinate one ulp up and down.",
        {"FC-NUM-01"}},
       {}},
      {{"extreme-scale", "Scaled by a power of two to an end of the range of doubles.", {"FC-INV-04"}}, {}},
      {{"high-degree-facet", "An edge whose Voronoi facet has many sides.", {"FC-VOR-03", "FC-FLOW-01"}}, {}},
      {{"half-shell",
        "A sampled surface, open at the top: orbits run along its inside.",
        {"FC-FLOW-05", "FC-FLOW-07"}},
       {}},
      {{"cascade", "Two combs between which the flow crosses facet after facet.", {"FC-FLOW-05"}}, {}},
      {{"right-angle-chain", "Right triangles about one axis.", {"FC-SIGN-04", "FC-FLOW-01"}}, {}},
      {{"symmetric", "Points symmetric to an axis or to planes.", {"FC-FLOW-06"}}, {}},
      {{"not-finite", "A coordinate is NaN or infinite.", {"FC-IN-01"}}, {}},
      {{"overflow", "A number whose nearest double is infinite.", {"FC-IN-01"}}, {}},
      {{"inexact-hex", "A hexadecimal float that is no double.", {"FC-IN-02"}}, {}},
      {{"no-number", "A word where a number should be.", {"FC-IN-05"}}, {}},
      {{"short-row", "A row with too few numbers.", {"FC-IN-05"}}, {}},
      {{"nothing-to-read", "A file of nothing but white space.", {"FC-IN-05"}}, {}},
      {{"bad-start", "The points are right, but the start of the orbit is no position.", {"FC-FLOW-05"}}, {}},
  };
}

std::vector<Definition> facts_of_inputs() {
  const auto is_empty = [](const Rows& rows, const Findings&) { return rows.empty(); };
  const auto has_duplicates = [](const Rows&, const Findings& found) {
    return found.answer.merged_duplicates > 0;
  };
  const auto is_few = [](const Rows&, const Findings& found) {
    return !found.set.points.empty() && found.set.points.size() < 4;
  };
  const auto is_many = [](const Rows&, const Findings& found) { return found.set.points.size() >= 20; };
  return {
      {{"empty", "No point.", {"FC-IN-04"}}, is_empty},
      {{"few-points", "One, two or three different points.", {"FC-IN-04"}}, is_few},
      {{"many-points", "20 different points or more.", {"FC-CRIT-05"}}, is_many},
      {{"collinear", "Three different points or more, on a line.", {"FC-IN-04", "FC-VOR-03"}}, spans(1, 3)},
      {{"coplanar", "Four different points or more, in a plane.", {"FC-IN-04", "FC-VOR-02"}}, spans(2, 4)},
      {{"duplicates", "Rows with equal coordinates.", {"FC-IN-03"}}, has_duplicates},
      {{"negative-zero", "A coordinate is -0.", {"FC-IN-02"}},
       some_coordinate([](double value) { return value == 0 && std::signbit(value); })},
      {{"subnormal", "A coordinate is subnormal.", {"FC-IN-04"}},
       some_coordinate([](double value) { return value != 0 && std::abs(value) < DBL_MIN; })},
      {{"near-overflow", "A coordinate is 2^1000 or more in magnitude.", {"FC-IN-04", "FC-NUM-02"}},
       some_coordinate([](double value) { return std::abs(value) >= 0x1p+1000; })},
      {{"mixed-magnitudes", "Coordinates that differ by a factor of more than 2^100.", {"FC-IN-04"}},
       has_mixed_magnitudes},
      {{"far-away", "2^20 times as far from the origin as the points are from the first.", {"FC-INV-04"}},
       is_far_away},
  };
}

std::vector<Definition> facts_of_stationary_points() {
  return {
      {{"polygon-saddle",
        "A critical point of index 2 with more than three contact points.",
        {"FC-CRIT-02", "FC-SIGN-03", "FC-CLAIM-02"}},
       some_cluster(2)},
      {{"polytope-maximum",
        "A critical point of index 3 with more than four contact points.",
        {"FC-CRIT-02", "FC-SIGN-03", "FC-CLAIM-02"}},
       some_cluster(3)},
      {{"kind-1-2", "A regular stationary point of kind 1-2.", {"FC-CRIT-03", "FC-INV-02", "FC-CLAIM-04"}},
       some_kind(1, 2)},
      {{"kind-2-3", "A regular stationary point of kind 2-3.", {"FC-CRIT-03", "FC-INV-02", "FC-CLAIM-04"}},
       some_kind(2, 3)},
      {{"kind-1-3", "A regular stationary point of kind 1-3.", {"FC-CRIT-03", "FC-INV-02", "FC-CLAIM-04"}},
       some_kind(1, 3)},
      {{"cluster-at-regular",
        "A regular stationary point with more contact points than a simplex has.",
        {"FC-CRIT-03", "FC-SIGN-04"}},
       some_stationary([](const StationaryPoint& x) { return is_regular(x) && is_cluster(x); })},
  };
}

std::vector<Definition> facts_of_orbits() {
  const auto is_maximum = [](const StationaryPoint& x) { return !is_regular(x) && x.hull_dimension == 3; };
  const auto is_saddle = [](const StationaryPoint& x) { return !is_regular(x) && x.hull_dimension < 3; };
  const auto to_infinity = [](const PointSet&, const Orbit& path) { return !path.limit; };
  return {
      {{"from-vertex", "An orbit that moves on from a Voronoi vertex.", {"FC-FLOW-02"}}, some_start('V')},
      {{"from-edge", "An orbit from inside a Voronoi edge.", {"FC-FLOW-02"}}, some_start('E')},
      {{"from-facet", "An orbit from inside a Voronoi facet.", {"FC-FLOW-02"}}, some_start('F')},
      {{"from-cell", "An orbit from inside a Voronoi cell.", {"FC-FLOW-02"}}, some_start('C')},
      {{"stationary-start", "An orbit that stays.", {"FC-FLOW-03"}}, has_stationary_start},
      {{"to-maximum", "An orbit that ends at a maximum.", {"FC-FLOW-05"}}, some_limit(is_maximum)},
      {{"to-saddle", "An orbit that moves and ends at a critical point of index 1 or 2.", {"FC-FLOW-05"}},
       some_limit(is_saddle)},
      {{"to-regular", "An orbit that moves and ends at a regular stationary point.", {"FC-FLOW-05"}},
       some_limit(is_regular)},
      {{"to-infinity", "An orbit that ends at infinity.", {"FC-FLOW-05"}}, some_orbit(to_infinity)},
      {{"through-vertex", "An orbit that passes through a Voronoi vertex.", {"FC-FLOW-02", "FC-FLOW-08"}},
       some_orbit(passes_a_vertex)},
      {{"along-edges",
        "An orbit that runs along two Voronoi edges or more, one after the other.",
        {"FC-FLOW-01", "FC-FLOW-02"}},
       some_orbit(crosses_edges_in_a_row)},
      {{"across-facets",
        "An orbit that crosses three Voronoi facets or more, from edge to edge.",
        {"FC-FLOW-01", "FC-FLOW-05"}},
       some_orbit(crosses_facets_in_a_row)},
      {{"one-limit", "A critical point of index 2 both of whose limits are the same.", {"FC-FLOW-07"}},
       has_saddle_with_one_limit},
  };
}

std::vector<Definition> facts_of_stable_sets() {
  const auto has_cut_sector = [](const StableSet& set) {
    return std::any_of(set.sectors.begin(), set.sectors.end(),
                       [](const Sector& sector) { return sector.polygon.size() > 3; });
  };
  return {
      {{"edge-back",
        "A listed stable set in which a backward segment ends inside a Voronoi edge, where it branches.",
        {"FC-STAB-04", "FC-STAB-06"}},
       some_back(BackKind::kEdge)},
      {{"regular-back",
        "A listed stable set in which a backward segment ends at a regular stationary point.",
        {"FC-STAB-04", "FC-CHAIN-02"}},
       some_back(BackKind::kRegular)},
      {{"skeleton-vertex",
        "A listed stable set with a Voronoi vertex in its skeleton.",
        {"FC-STAB-03", "FC-STAB-06", "FC-CHAIN-02"}},
       some_stable_set([](const StableSet& set) { return set.has_vertex; })},
      {{"skeleton-interval",
        "A listed stable set with an interval in its skeleton: a part of it has dimension 3.",
        {"FC-STAB-05", "FC-STAB-06"}},
       some_stable_set([](const StableSet& set) { return !set.intervals.empty(); })},
      {{"cut-sector",
        "A listed stable set with a sector that is no triangle: its rays leave the Voronoi facet.",
        {"FC-STAB-05"}},
       some_stable_set(has_cut_sector)},
  };
}

std::vector<Definition> facts_of_persistence() {
  return {
      {{"tunnel", "A listed persistence pair of dimension 1.", {"FC-PERS-01", "FC-PERS-05"}}, some_class(1)},
      {{"void", "A listed persistence pair of dimension 2.", {"FC-PERS-01", "FC-PERS-05"}}, some_class(2)},
      {{"equal-pairs",
        "Two listed persistence pairs of the same dimension, birth and death.",
        {"FC-PERS-01", "FC-PERS-04"}},
       has_equal_pairs},
  };
}

const std::vector<Definition>& definitions() {
  static const std::vector<Definition> all = [] {
    std::vector<Definition> table;
    for (auto* part : {aims, facts_of_inputs, facts_of_stationary_points, facts_of_orbits,
                       facts_of_stable_sets, facts_of_persistence}) {
      for (Definition& definition : part()) table.push_back(definition);
    }
    return table;
  }();
  return all;
}

}  // namespace

const std::vector<Flag>& all_flags() {
  static const std::vector<Flag> flags = [] {
    std::vector<Flag> list;
    for (const Definition& definition : definitions()) list.push_back(definition.flag);
    return list;
  }();
  return flags;
}

std::vector<std::string> flags_of(const Rows& rows, const Findings& findings,
                                  const std::vector<std::string>& aims) {
  std::set<std::string> open(aims.begin(), aims.end());
  std::vector<std::string> flags;
  for (const Definition& definition : definitions()) {
    const std::string& name = definition.flag.name;
    const bool is_aim = !definition.holds;
    if (is_aim ? open.erase(name) > 0 : definition.holds(rows, findings)) flags.push_back(name);
  }
  if (!open.empty()) throw std::logic_error(*open.begin() + " is no aim");
  return flags;
}

std::vector<std::string> clauses_of(const std::vector<std::string>& flags, std::vector<std::string> more) {
  for (const Flag& flag : all_flags()) {
    if (std::find(flags.begin(), flags.end(), flag.name) == flags.end()) continue;
    more.insert(more.end(), flag.clauses.begin(), flag.clauses.end());
  }
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  return more;
}

}  // namespace oracle::vectors
