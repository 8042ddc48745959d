// Clusters, polygons and chains are taken from the diagram itself, because no public interface shows them.
#include "fuzz/campaign/degeneracy_signature.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <span>

#include "fuzz/properties/subject.h"
#include "geometry/disjoint_sets.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::fuzz {

using namespace voronoi;
namespace {

// ---- Words and buckets ----

template <std::size_t kCount>
std::vector<std::string> texts_of(const std::array<const char*, kCount>& names) {
  return {names.begin(), names.end()};
}

// How many of the ascending bounds the count has reached.
std::uint8_t bucket(std::size_t count, std::initializer_list<std::size_t> bounds) {
  return static_cast<std::uint8_t>(
      std::count_if(bounds.begin(), bounds.end(), [count](std::size_t bound) { return count >= bound; }));
}
std::uint8_t some(std::size_t count) { return bucket(count, {1}); }
std::uint8_t few(std::size_t count) { return bucket(count, {1, 2}); }
std::uint8_t length(std::size_t count) { return bucket(count, {1, 2, 3, 5, 9}); }

// ---- The Voronoi diagram ----

struct Extent {
  std::size_t cluster = 0;
  std::size_t polygon = 0;
  std::size_t chain = 0;
};

std::size_t points_of_cluster(const VoronoiComplex& complex, std::span<const CellIndex> cells) {
  std::set<VertexIndex> points;
  for (const CellIndex cell : cells) {
    const auto& v = complex.delaunay().vertices(cell);
    points.insert(v.begin(), v.end());
  }
  return points.size();
}

// Sets of connected Voronoi vertices, each with its number of edges.
class Chains {
 public:
  explicit Chains(std::size_t vertices) : sets_(vertices), edges_(vertices) {}

  // Adds an edge, and returns the number of edges in its set. One end may be at infinity, but not both: in dimension
  // 3 no Voronoi edge is a line.
  std::size_t add(CellIndex from, CellIndex to) {
    const std::uint32_t a = sets_.find(from == kNoCell ? to : from);
    const std::uint32_t b = sets_.find(to == kNoCell ? from : to);
    const std::size_t edges = edges_[a] + (a == b ? 0 : edges_[b]) + 1;
    sets_.unite(a, b);
    return edges_[sets_.find(a)] = edges;
  }

 private:
  geometry::DisjointSets sets_;
  std::vector<std::size_t> edges_;
};

Extent spatial_extent(const VoronoiDiagram& diagram) {
  const VoronoiComplex& complex = diagram.complex();
  Extent extent{4, 3, 0};
  for (std::size_t k = 0; k < complex.large_cluster_count(); ++k) {
    extent.cluster = std::max(extent.cluster, points_of_cluster(complex, complex.large_cluster(k)));
  }
  // A polygon of k triangles has k + 2 corners.
  for (std::size_t k = 0; k < complex.large_polygon_count(); ++k) {
    extent.polygon = std::max(extent.polygon, complex.large_polygon(k).size() + 2);
  }
  Chains chains(diagram.delaunay().finite_count);
  for (CellIndex cell = 0; cell < diagram.delaunay().finite_count; ++cell) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const FacetRef facet{cell, i};
      if (complex.role(facet) == VoronoiComplex::FacetRole::kInterior) continue;
      if (diagram.polygon(facet) != facet || diagram.driver(facet).shape != Sign::kZero) continue;
      extent.chain = std::max(extent.chain, chains.add(diagram.end(facet, 0), diagram.end(facet, 1)));
    }
  }
  return extent;
}

// For coplanar points a polygon is the contact set of its centre. Its Voronoi edge is a line, and a chain by itself.
Extent planar_extent(const VoronoiDiagram& diagram) {
  Extent extent;
  for (CellIndex cell = 0; cell < diagram.delaunay().finite_count; ++cell) {
    const PolygonRef polygon = diagram.polygon({cell, 0});
    extent.polygon = std::max(extent.polygon, diagram.sides(polygon).size());
    if (diagram.driver(polygon).shape == Sign::kZero) extent.chain = 1;
  }
  return extent;
}

Extent extent_of(const VoronoiDiagram& diagram, const StationaryPoints& stationary) {
  Extent extent;
  if (diagram.dimension() >= 2) {
    extent = diagram.dimension() == 3 ? spatial_extent(diagram) : planar_extent(diagram);
  }
  for (std::size_t i = 0; i < stationary.size(); ++i) {
    extent.cluster = std::max(extent.cluster, stationary.contact(i).size());
  }
  return extent;
}

// ---- The rest ----

template <std::size_t kCount>
std::uint8_t failures_of(const std::array<FilterCount, kCount>& counts) {
  static_assert(kCount <= 8);
  std::uint8_t set = 0;
  for (std::size_t k = 0; k < kCount; ++k) {
    if (counts[k].failures > 0) set = static_cast<std::uint8_t>(set | 1U << k);
  }
  return set;
}

void add_unstable(const FlowStatistics& statistics, DegeneracySignature& signature) {
  std::size_t starts = 0;
  std::size_t hits = 0;
  for (const auto& [type, times] : statistics.census) {
    if (type[0] == 'V') starts += times;
    if (type[1] == 'F' && type[2] == 'V') hits += times;
  }
  signature[SignaturePart::kVertexStarts] = few(starts);
  signature[SignaturePart::kVertexHits] = few(hits);
  signature[SignaturePart::kEndsAtRegular] = some(statistics.to_regular);
  signature[SignaturePart::kEndsAtInfinity] = some(statistics.to_infinity);
  signature[SignaturePart::kCascade] = length(statistics.n_u2.max());
}

void add_stable(const StableStatistics& statistics, DegeneracySignature& signature) {
  signature[SignaturePart::kDescent] = length(statistics.n_s2.max());
  signature[SignaturePart::kStableVertex] = some(statistics.with_vertex);
  signature[SignaturePart::kStableInterval] = some(statistics.with_interval);
  signature[SignaturePart::kTies] = some(statistics.broken_ties);
}

}  // namespace

const std::vector<SignatureComponent>& signature_components() {
  static const std::vector<std::string> yes_or_no{"0", "1+"};
  static const std::vector<std::string> few{"0", "1", "2+"};
  static const std::vector<std::string> lengths{"0", "1", "2", "3-4", "5-8", "9+"};
  static const std::vector<SignatureComponent> components = {
      {"dimension", "Of the affine hull of the points.", {"none", "0", "1", "2", "3"}},
      {"duplicates", "Rows that repeat another one.", yes_or_no},
      {"cluster",
       "Points of the largest contact set of a stationary point or a Voronoi vertex.",
       {"0-4", "5", "6", "7-8", "9+"}},
      {"polygon", "Corners of the largest polygon of a Voronoi edge.", {"0-3", "4", "5-6", "7+"}},
      {"12", "Regular stationary points of kind 1-2.", few},
      {"23", "Regular stationary points of kind 2-3.", few},
      {"13", "Regular stationary points of kind 1-3.", few},
      {"chain",
       "Voronoi edges of right-angled polygons that hang together at Voronoi vertices, most of them.",
       {"0", "1", "2", "3+"}},
      {"vertex-starts", "Segments of unstable manifolds that start at a Voronoi vertex.", few},
      {"vertex-hits", "Segments of unstable manifolds that cross a facet and meet a Voronoi vertex.", few},
      {"ends-regular", "Orbits of unstable manifolds that end at a regular stationary point.", yes_or_no},
      {"ends-infinity", "Orbits of unstable manifolds that go to infinity.", yes_or_no},
      {"cascade", "Segments of the longest orbit of an unstable manifold.", lengths},
      {"descent", "Segments of the longest connecting orbit down to a point of index 1.", lengths},
      {"s2-vertex", "Stable manifolds of index 2 with a Voronoi vertex in their skeleton.", yes_or_no},
      {"s2-interval", "Stable manifolds of index 2 with a part of dimension 3.", yes_or_no},
      {"ties", "Points of index 2 whose boundary a tie leaves open.", yes_or_no},
      {"exact", "Predicates of the stationary points that exact arithmetic had to decide.", texts_of(kPredicateNames),
       true, false},
      {"exact-flow", "Signs and constructions of the flow that the usual filter left open.",
       texts_of(kFlowPrimitiveNames), true, false},
  };
  return components;
}

DegeneracySignature signature_of(const Input& input) {
  const FlowComplex& complex = property::subject_of(input).complex;
  const VoronoiDiagram& diagram = complex.diagram();
  const StationaryPoints& stationary = complex.stationary();
  const UnstableManifolds& unstable = complex.unstable();
  const StableManifolds& stable = complex.stable();
  const Extent extent = extent_of(diagram, stationary);

  DegeneracySignature signature;
  signature[SignaturePart::kDimension] = static_cast<std::uint8_t>(diagram.dimension() + 1);
  signature[SignaturePart::kDuplicates] = some(complex.points().merged_duplicates());
  signature[SignaturePart::kCluster] = bucket(extent.cluster, {5, 6, 7, 9});
  signature[SignaturePart::kPolygon] = bucket(extent.polygon, {4, 5, 7});
  signature[SignaturePart::kKind12] = few(stationary.regular_counts().kind12);
  signature[SignaturePart::kKind23] = few(stationary.regular_counts().kind23);
  signature[SignaturePart::kKind13] = few(stationary.regular_counts().kind13);
  signature[SignaturePart::kChain] = bucket(extent.chain, {1, 2, 3});
  add_unstable(unstable.statistics(), signature);
  add_stable(stable.statistics(), signature);
  signature[SignaturePart::kExact] = failures_of(complex.filter_tally().counts);
  signature[SignaturePart::kExactFlow] = static_cast<std::uint8_t>(failures_of(unstable.statistics().tally.counts) |
                                                                   failures_of(stable.statistics().tally.counts));
  return signature;
}

DegeneracySignature combinatorial_part(DegeneracySignature signature) {
  for (std::size_t k = 0; k < kSignatureSize; ++k) {
    if (!signature_components()[k].is_combinatorial) signature.values[k] = 0;
  }
  return signature;
}

std::size_t value_count(std::size_t component) {
  const SignatureComponent& words = signature_components().at(component);
  return words.is_set ? std::size_t{1} << words.texts.size() : words.texts.size();
}

std::string value_text(std::size_t component, std::uint8_t value) {
  const SignatureComponent& words = signature_components().at(component);
  if (!words.is_set) return words.texts.at(value);
  std::string text;
  for (std::size_t bit = 0; bit < words.texts.size(); ++bit) {
    if ((value >> bit & 1U) != 0) text += (text.empty() ? "" : ",") + words.texts[bit];
  }
  return text.empty() ? "none" : text;
}

std::string to_text(const DegeneracySignature& signature) {
  std::string text;
  for (std::size_t k = 0; k < kSignatureSize; ++k) {
    text += (k > 0 ? " " : "") + signature_components()[k].name + '=' + value_text(k, signature.values[k]);
  }
  return text;
}

}  // namespace flowcert::fuzz
