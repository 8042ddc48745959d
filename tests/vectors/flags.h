// The flags of conformance vectors: what a case aims at, or has.
//
// Guarantees: most flags follow from input and answer, and are set iff they hold; the others, *aims*, say how
// the input was made. Each is defined once, here, and written to spec/vectors/flags.json.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracle/connections.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/stable_set.h"
#include "oracle/stationary_points.h"
#include "oracle/unstable_surface.h"
#include "tests/vectors/cycle_claims.h"
#include "tests/vectors/landscape.h"
#include "tests/vectors/shapes.h"

namespace oracle::vectors {

// Of a stable set: FC-VOL-01, and FC-VOL-02 in the order of the set's points.
struct VolumeAndShares {
  Rational volume;
  std::vector<Rational> shares;
};

// What the oracle found out for one case.
struct Findings {
  Rows rows;
  PointSet set;
  Answer answer;
  std::vector<std::array<Orbit, 2>> unstable;  // of the index-2 points, in order; if asked for
  std::vector<Point> starts;
  std::vector<Orbit> orbits;  // one for each start, unless locations are asked for
  // The stable sets of points that are critical of index 2 or regular, by place in the list, if asked for.
  std::map<std::size_t, StableSet> stable;
  std::vector<PersistencePair> persistence;  // ascending; if asked for
  // λ-lists by place in the list, where there are any, if asked for.
  std::map<std::size_t, std::vector<UnstableEntry>> lambda = {};
  std::vector<Connection> connections = {};  // if asked for, and then also:
  std::optional<bool> morse_smale = {};
  std::vector<VolumeAndShares> volumes = {};  // by place in the list, if asked for
  // The unstable sets of points with dim F = 1, by place in the list, if asked for.
  std::map<std::size_t, UnstableSurface> surfaces = {};
  // If asked for:
  std::vector<Location> locations = {};  // one for each start, instead of orbits
  std::optional<Trees> trees = {};
  std::vector<PocketAnswer> pockets = {};
  std::optional<MedialAnswer> medial = {};
  std::optional<StableSet> infinity = {};
  std::optional<StatisticsAnswer> statistics = {};
  std::vector<CycleClaim> cycle_claims = {};
};

struct Flag {
  const char* name;
  const char* meaning;
  const char* clauses;             // parted by blanks
  bool (*holds)(const Findings&);  // null for an aim
};

// All flags, in the order in which cases list them.
std::span<const Flag> all_flags();

// The aims, and what follows from the findings. Throws std::logic_error for an aim that is no flag.
std::vector<std::string> flags_of(const Findings& findings, const std::vector<std::string>& aims);

// The clauses of the flags and of the group, ascending, once each.
std::vector<std::string> clauses_of(const std::vector<std::string>& flags, std::vector<std::string> more);

}  // namespace oracle::vectors
