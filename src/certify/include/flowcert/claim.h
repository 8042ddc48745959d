// A flow complex as some implementation claims it, whatever the format, and reading such claims.
//
// Guarantees: a claim is kept as it was made, right or wrong. Nothing is completed, sorted or rounded. What a format
// does not say is empty. A malformed file is refused as a whole. Readers do not know whether ids are rows of the
// input; require_rows() does. No number in a file can make a reader allocate more than a multiple of the file's
// (decompressed) size. Formats: spec/formats/claims.md.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/boxed.h"
#include "flowcert/claimed_number.h"
#include "flowcert/claimed_pockets.h"
#include "flowcert/pieces.h"
#include "flowcert/point_set.h"

namespace flowcert {

// Where an orbit is claimed to end, or what a critical point is claimed to be incident with.
struct ClaimedTarget {
  bool is_infinity = false;
  std::vector<PointId> contact;  // of the stationary point, as claimed, if it is not infinity
};

struct ClaimedSegment {
  std::string type;  // as claimed; empty where not claimed
  std::optional<ClaimedPosition> driver;
  std::optional<ClaimedPosition> end;  // none: infinity
};
using ClaimedPolyline = std::vector<ClaimedSegment>;

// What flows to infinity, as claimed (FC-STAB-08). A vector may have any length but 0.
struct ClaimedInfinity {
  std::size_t line = 0;  // of the file, 1-based
  StableSet<ClaimedPosition> bounded, unbounded;
};
// The claimed parts of the stable manifold of an index-2 point, or of the stable set of a regular one (FC-STAB).
struct ClaimedSurface {
  std::vector<ClaimedPosition> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;  // of vertices, which exist
};
struct ClaimedStable {
  std::optional<std::size_t> segments;
  std::optional<bool> has_vertex, has_interval;
  std::optional<std::vector<std::vector<PointId>>> boundary;  // contact sets of index-1 points, mod 2
  std::optional<std::vector<PointId>> walk;                   // closed; the first sample is not repeated
};

// Where the directions of a stationary point are claimed to lead (FC-UNST-02).
struct ClaimedDirection {
  ClaimedTarget limit;
  // Where the ray leaves the closed Voronoi face, or a vector along it if it never does; none: not claimed.
  std::optional<ClaimedPosition> exit;
  bool is_vector = false;
  // The doubles beside `exit`. One that has no value says that no double is near.
  std::optional<std::array<std::optional<ClaimedNumber>, 3>> rounded_exit;
};
struct ClaimedLambdaList {
  std::vector<ClaimedDirection> directions;
  std::vector<ClaimedTarget> arcs;
};
struct ClaimedConnection {
  ClaimedTarget to;
  std::size_t orbits = 0, families = 0;
};
// The part of a stable set's volume in the Voronoi cell of a sample (FC-VOL-02).
struct ClaimedShare {
  PointId sample = 0;
  std::optional<ClaimedNumber> volume;  // none: no double is near
};

// One critical (or regular stationary) point of a claim.
struct ClaimedPoint {
  std::size_t line = 0;  // of the file, 1-based; in a VTP file, the point's ordinal, 1-based
  // The index, 0 to 3. For a regular stationary point it is the first number of its kind.
  int index = 0;
  std::optional<int> hull_dimension;  // set: claimed to be regular, of kind (index, hull_dimension)
  std::vector<PointId> contact;       // rows of the input, as claimed; empty where not claimed
  Boxed<ClaimedPosition> center;
  Boxed<ClaimedNumber> squared_distance;  // not negative
  Boxed<ClaimedNumber> distance;          // the radius itself, for formats that give it
  // The doubles beside center and squared_distance. One that has no value says that no double is near.
  Boxed<std::array<std::optional<ClaimedNumber>, 3>> rounded_center;
  Boxed<ClaimedNumber> rounded_squared_distance;
  bool has_rounded_squared_distance = false;
  // The claimed incidences with critical points of one index more. Without a value, nothing is claimed about them.
  Boxed<std::vector<ClaimedTarget>> successors;
  // If true, the successors are two in order: the limits of side 0 and side 1 (FC-FLOW-07), possibly equal. Otherwise
  // they are a set.
  bool successors_by_side = false;
  Boxed<std::vector<PointId>> samples;     // of an index-1 point: the ends of its stable manifold
  Boxed<std::vector<ClaimedPolyline>> u2;  // of an index-2 point: two, one a side
  // For an index-2 point or a regular one.
  Boxed<ClaimedStable> stable;
  Boxed<StableSet<ClaimedPosition>> skeleton;
  // Connecting orbits, each a chain of places in the skeleton's segments, which exist.
  Boxed<std::vector<std::vector<std::size_t>>> orbits;
  Boxed<ClaimedSurface> surface;
  // For an index-1 or index-2 point or a regular one.
  Boxed<ClaimedLambdaList> lambda;
  Boxed<std::vector<ClaimedConnection>> connections;
  // Of the stable set; not negative.
  Boxed<ClaimedNumber> volume;
  // The double beside `volume`. Without a value it says that no double is near.
  Boxed<ClaimedNumber> rounded_volume;
  bool has_rounded_volume = false;
  Boxed<std::vector<ClaimedShare>> shares;
  // For an index-1 point or a regular one whose kind begins with 1.
  Boxed<UnstableSurface<ClaimedPosition>> u1;
};

// Whether the critical points of each index are claimed.
using ClaimedIndices = std::array<bool, 4>;

struct Claim {
  std::string format;  // "exchange", "pockets", "csv", "giesen-kuehne", "vtp"
  std::vector<ClaimedPoint> points;
  // The indices of the critical points that are claimed; without a value, all. Of others it says nothing
  // (FC-CLAIM-12).
  std::optional<ClaimedIndices> indices;
  // What the format says of the whole claim.
  std::optional<std::size_t> point_count;  // rows of the input
  std::optional<std::string> input_sha256;
  std::optional<std::size_t> merged_duplicates;
  std::optional<std::vector<std::vector<PointId>>> classes;  // of repeated rows
  std::optional<std::array<std::size_t, 4>> critical_counts;
  std::optional<std::array<std::size_t, 3>> regular_counts;  // of kinds 1-2, 1-3, 2-3
  std::optional<bool> morse_smale;
  std::optional<ClaimedNumber> hull_volume;  // not negative
  std::optional<ClaimedInfinity> infinity;   // what flows there
  std::optional<ClaimedPockets> pockets;     // then no points are claimed, and no indices
  // Keys that the format does not know, "skeleton.colour", ascending: the first hundred, and whether there are more.
  std::vector<std::string> unknown_keys;
  bool has_more_unknown_keys = false;
};

// Reads a claim of stationary points or pockets, in any format that Claim::format names, recognised by content,
// gzip-compressed or not; "-" is standard input. Claims of pairs, cycles and pores are not read.
// Throws InvalidInput, one line "FILE:LINE: reason" or "FILE: reason", for a file that cannot be opened, that is
// malformed, or that is compressed and grows to more than a hundred times its size, or 4 GB, unless it may.
[[nodiscard]] Claim read_claim(const std::string& path, bool unlimited = false);

// The same from memory; `name` is used in messages.
[[nodiscard]] Claim read_claim_from(std::string_view bytes, const std::string& name, bool unlimited = false);

// Throws InvalidInput, "FILE:LINE: reason", if the claim names a row that the input does not have. `name` is the
// file's. Linear in the claim.
void require_rows(const Claim& claim, const PointSet& points, const std::string& name);

}  // namespace flowcert
