// What the oracle finds for the groups about merge trees, pockets, the medial axis and statistics.
//
// Guarantees: exact. Persistences and probes are chosen by rule from the values of the case, so that something just
// passes, or just does not. Stationary points are told by their places in the list of all.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "oracle/merge_tree.h"
#include "oracle/pockets.h"

namespace oracle::vectors {

struct Trees {
  MergeTree pockets, components;
};
Trees trees_of(const PointSet& set, const std::vector<StationaryPoint>& all);

// What each pocket is for one radius.
struct ProbeAnswer {
  Rational radius;
  std::vector<Passage> passages;
};
struct PocketAnswer {
  Rational persistence;  // a difference of distances
  Pockets found;
  // By stationary point: the numbers of the pockets above it, where it is an index-2 point.
  std::map<std::size_t, std::vector<std::size_t>> between;
  std::vector<ProbeAnswer> probes;
};
// Lengths of pairs are rounded up to 12 bits, which those that have no more are not. At the persistence 0, at the
// lesser middle one of the different lengths of pairs of dimension 2, and halfway between the two greatest. Probes are
// the roots of the lesser middle value of mouths, rounded down, and of the least value of a widest path, rounded up.
std::vector<PocketAnswer> pocket_answers(const PointSet& set, const std::vector<StationaryPoint>& all);

// The root of a positive value to 12 bits, rounded down or up. A root that has no more bits is exact.
Rational short_root(const Rational& square, bool rounds_up);

// The root of a value less that of another one, rounded up to 12 bits.
Rational short_length(const Rational& death, const Rational& birth);

struct AngleAnswer {
  int degrees = 0;
  std::vector<std::size_t> above;
};
// Of the critical points of one index and value: how many there are, and how many are in longer pairs.
struct LevelCount {
  int index = 0;
  Rational value;
  std::size_t points = 0, above = 0;
};
struct LengthAnswer {
  Rational persistence;  // a difference of distances
  std::vector<LevelCount> levels;
};
struct MedialAnswer {
  std::vector<AngleAnswer> angles;
  std::vector<LengthAnswer> lengths;
};
// Persistences are 0, the least length of all pairs, the lesser middle one, and halfway between the two greatest.
MedialAnswer medial_answer(const PointSet& set, const std::vector<StationaryPoint>& all);

// How often each number comes (FC-STAT-01).
struct StatisticsAnswer {
  std::map<std::size_t, std::size_t> n_u2, n_s2, n_wcc;
};
StatisticsAnswer statistics_answer(const PointSet& set, const std::vector<StationaryPoint>& all);

}  // namespace oracle::vectors
