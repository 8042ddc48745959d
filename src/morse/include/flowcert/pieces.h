// The pieces of Voronoi faces that stable and unstable sets are made of: four shapes, and what sets of them are.
//
// Guarantees: a truth's positions are exact. X is the type of a position: RationalPoint in a truth, ClaimedPosition in
// a claim. A claim may leave out what a truth states. Source: spec clauses FC-STAB-03 to 05, 08, FC-UNST-04, 05.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert {

// A position. At infinity it is a vector in that direction. A truth's vector has 1 or -1 as its largest coordinate, so
// that equal directions have equal vectors. Positions come before vectors, each in lexicographic order.
template <class X = RationalPoint>
struct Corner {
  X position;
  bool at_infinity = false;

  friend bool operator==(const Corner&, const Corner&) = default;
  friend bool operator<(const Corner& a, const Corner& b) {
    return std::tie(a.at_infinity, a.position) < std::tie(b.at_infinity, b.position);
  }
};
// A part of the Voronoi edge of a polygon, whose names are ascending. The flow goes from `back` to `front`. Where it
// does not go along the edge, `front` is the lesser corner.
template <class X = RationalPoint>
struct EdgePart {
  std::vector<PointId> polygon;
  Corner<X> front, back;

  friend bool operator==(const EdgePart&, const EdgePart&) = default;
};
// The open segment or ray in which a ray from the midpoint of two samples crosses their Voronoi facet. The flow goes
// from `back` to `front`. The names are ascending.
template <class X = RationalPoint>
struct Crossing {
  std::array<PointId, 2> samples;
  Corner<X> front, back;

  friend bool operator==(const Crossing&, const Crossing&) = default;
};
// A convex region of the Voronoi facet of two samples, with its corners in cyclic order. In a truth the least one is
// first, and the lesser of its neighbours second. At most two corners are at infinity, and these are neighbours.
template <class X = RationalPoint>
struct Region {
  std::array<PointId, 2> samples;
  std::vector<Corner<X>> corners;

  friend bool operator==(const Region&, const Region&) = default;
};

template <class Piece>
[[nodiscard]] bool is_unbounded(const Piece& piece) {
  if constexpr (requires { piece.corners; }) {
    return std::ranges::any_of(piece.corners, [](const auto& corner) { return corner.at_infinity; });
  } else {
    return piece.front.at_infinity || piece.back.at_infinity;
  }
}

// A truth states it. A claim may leave it out.
template <class X, class T>
using Stated = std::conditional_t<std::is_same_v<X, RationalPoint>, T, std::optional<T>>;

// What a backward segment ends at (FC-STAB-04).
enum class BackKind : std::uint8_t { kCritical, kRegular, kEdge, kVertex };
// "critical", "regular", "edge", "vertex"
[[nodiscard]] const char* back_kind_text(BackKind kind);

// Contact sets are ascending names. A front at infinity has none.
template <class X = RationalPoint>
struct BackwardSegment : Crossing<X> {
  Stated<X, std::vector<PointId>> front_contact, back_contact;
  Stated<X, BackKind> back_kind = {};

  friend bool operator==(const BackwardSegment&, const BackwardSegment&) = default;
};
template <class X = RationalPoint>
struct BackwardInterval : EdgePart<X> {
  Stated<X, bool> back_is_stationary = {};

  friend bool operator==(const BackwardInterval&, const BackwardInterval&) = default;
};
// The skeleton of a stable set, from which all of it follows (FC-STAB-02), or of what flows to infinity (FC-STAB-08).
// Only the latter has corners at infinity. If the directions of a sector are a half circle or more, it is cut into
// quarters of a circle. In a truth the pieces are sorted by samples or polygon, then corners.
template <class X = RationalPoint>
struct StableSet {
  std::vector<BackwardSegment<X>> segments;
  std::vector<BackwardInterval<X>> intervals;
  std::vector<Region<X>> sectors;

  friend bool operator==(const StableSet&, const StableSet&) = default;
};

// An unstable set of dimension 2 (FC-UNST-04). A sheet has its sides, too. If P does not span space, a sheet is a whole
// facet, and has no corners. In a truth each list is sorted: by position, by polygon and lesser corner, by samples and
// corners, by samples and back.
template <class X = RationalPoint>
struct UnstableSurface {
  std::vector<X> vertices;          // Voronoi vertices
  std::vector<EdgePart<X>> traces;  // with those of their ends that lie on the edge; a point has equal ends
  std::vector<EdgePart<X>> runs;    // without their ends
  std::vector<Region<X>> sheets;
  std::vector<Crossing<X>> segments;  // of single rays

  friend bool operator==(const UnstableSurface&, const UnstableSurface&) = default;
};

}  // namespace flowcert
