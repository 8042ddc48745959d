#include "tests/vectors/landscape.h"

#include <algorithm>
#include <set>

#include "oracle/connections.h"
#include "oracle/medial_axis.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/stable_set.h"

namespace oracle::vectors {

namespace {

bool has_index(const StationaryPoint& x, int index) { return x.is_critical() && x.hull_dimension == index; }

// 0; the lesser middle one of the lengths; halfway between the two greatest.
std::set<Rational> chosen_lengths(const std::set<Rational>& lengths) {
  const std::vector<Rational> sorted(lengths.begin(), lengths.end());
  std::set<Rational> chosen = {0};
  if (!sorted.empty()) chosen.insert(sorted[(sorted.size() - 1) / 2]);
  if (sorted.size() > 1) chosen.insert((sorted[sorted.size() - 1] + sorted[sorted.size() - 2]) / 2);
  return chosen;
}

}  // namespace

Trees trees_of(const PointSet& set, const std::vector<StationaryPoint>& all) {
  return {superlevel_tree(set, all), sublevel_tree(set, all)};
}

// ---- Pockets ----

namespace {

// The lengths of the pairs of dimension 2 (FC-TREE-05), rounded up.
std::set<Rational> void_lengths(const std::vector<StationaryPoint>& all, const MergeTree& tree) {
  const std::vector<std::size_t> maxima = maxima_places(all);
  std::set<Rational> lengths;
  for (const MergeNode& node : tree.nodes) {
    std::vector<Rational> greatest;  // of each part without infinity
    for (const std::size_t part : node.parts) {
      const std::vector<std::size_t> leaves = leaves_of(tree, part);
      if (leaves.back() == maxima.size()) continue;
      Rational most = 0;
      for (const std::size_t leaf : leaves) most = std::max(most, all[maxima[leaf]].squared_distance);
      greatest.push_back(most);
    }
    std::sort(greatest.begin(), greatest.end());
    if (greatest.size() == node.parts.size()) greatest.pop_back();
    for (const Rational& value : greatest) lengths.insert(short_length(value, node.value));
  }
  return lengths;
}

void add_between(const std::vector<StationaryPoint>& all, const PeaksAbove& above, PocketAnswer& answer) {
  const std::vector<std::size_t> maxima = maxima_places(all);
  std::vector<std::size_t> number_of(maxima.size() + 1, answer.found.pockets.size());
  for (std::size_t number = 0; number < answer.found.pockets.size(); ++number) {
    for (const std::size_t maximum : answer.found.pockets[number].maxima) {
      const auto leaf = std::find(maxima.begin(), maxima.end(), maximum) - maxima.begin();
      number_of[static_cast<std::size_t>(leaf)] = number;
    }
  }
  for (std::size_t place = 0; place < all.size(); ++place) {
    if (!has_index(all[place], 2)) continue;
    std::set<std::size_t> numbers;
    for (const std::size_t leaf : above.of[place]) numbers.insert(number_of[leaf]);
    answer.between[place].assign(numbers.begin(), numbers.end());
  }
}

std::set<Rational> chosen_radii(const std::vector<StationaryPoint>& all, const Pockets& found) {
  std::set<Rational> mouths, paths, radii;
  for (const Pocket& pocket : found.pockets) {
    for (const std::size_t mouth : pocket.mouths) mouths.insert(all[mouth].squared_distance);
    paths.insert(pocket.to_infinity.value);
  }
  if (mouths.empty()) return radii;
  radii.insert(short_root(*std::next(mouths.begin(), static_cast<std::ptrdiff_t>((mouths.size() - 1) / 2)), false));
  radii.insert(short_root(*paths.begin(), true));
  return radii;
}

}  // namespace

Rational short_root(const Rational& square, bool rounds_up) {
  constexpr unsigned kBits = 12;
  Rational unit = 1;  // the power of two with unit <= root < 2 unit
  while (unit * unit > square) unit /= 2;
  while (4 * unit * unit <= square) unit *= 2;
  unit /= 1U << (kBits - 1);
  const Rational in_units = square / (unit * unit);
  Integer root = sqrt(Integer(numerator(in_units) / denominator(in_units)));
  if (rounds_up && Rational(root) * root < in_units) ++root;
  return root * unit;
}

Rational short_length(const Rational& death, const Rational& birth) {
  constexpr unsigned kBits = 12;
  const auto is_enough = [&](const Rational& length) {
    return is_root_difference_up_to(death, birth, length * length);
  };
  Rational unit = 1;  // the length is greater than half of it, and not greater than all
  while (is_enough(unit / 2)) unit /= 2;
  while (!is_enough(unit)) unit *= 2;
  unit /= 1U << kBits;
  unsigned low = 1U << (kBits - 1), high = 1U << kBits;  // in units: not enough, and enough
  while (high - low > 1) {
    const unsigned middle = (low + high) / 2;
    (is_enough(middle * unit) ? high : low) = middle;
  }
  return high * unit;
}

std::vector<PocketAnswer> pocket_answers(const PointSet& set, const std::vector<StationaryPoint>& all) {
  const PeaksAbove above = peaks_above(set, all);
  std::vector<PocketAnswer> answers;
  for (const Rational& persistence : chosen_lengths(void_lengths(all, superlevel_tree(set, all)))) {
    PocketAnswer& answer =
        answers.emplace_back(PocketAnswer{persistence, pockets(set, all, persistence * persistence), {}, {}});
    add_between(all, above, answer);
    for (const Rational& radius : chosen_radii(all, answer.found)) {
      ProbeAnswer& probe = answer.probes.emplace_back(ProbeAnswer{radius, {}});
      for (const Pocket& pocket : answer.found.pockets) probe.passages.push_back(passage(all, pocket, radius * radius));
    }
  }
  return answers;
}

// ---- The medial axis ----

namespace {

// The cosine's sign, and its square, which is rational for these angles.
struct Bound {
  int degrees;
  int sign;
  Rational square;
};

const std::vector<Bound>& bounds() {
  static const std::vector<Bound> all = {{60, 1, Rational(1, 4)},   {90, 0, 0},
                                         {120, -1, Rational(1, 4)}, {135, -1, Rational(1, 2)},
                                         {150, -1, Rational(3, 4)}, {180, -1, 1}};
  return all;
}

// Angles of critical points are 120 degrees at least, so that their cosines are negative (FC-MED-02).
bool is_above(const Rational& cosine, const Bound& bound) {
  return cosine < 0 && (bound.sign >= 0 || cosine * cosine > bound.square);
}

std::vector<LevelCount> levels_of(const std::vector<StationaryPoint>& all, const std::vector<PersistencePair>& pairs,
                                  const Rational& persistence) {
  std::vector<LevelCount> levels;
  for (const int index : {1, 2}) {
    std::map<Rational, std::size_t> points;
    for (const StationaryPoint& x : all) {
      if (has_index(x, index)) ++points[x.squared_distance];
    }
    for (const auto& [value, count] : points) {
      levels.push_back({index, value, count, count_above_persistence(pairs, index, value, persistence * persistence)});
    }
  }
  return levels;
}

}  // namespace

MedialAnswer medial_answer(const PointSet& set, const std::vector<StationaryPoint>& all) {
  MedialAnswer answer;
  for (const Bound& bound : bounds()) {
    AngleAnswer& angle = answer.angles.emplace_back(AngleAnswer{bound.degrees, {}});
    for (std::size_t place = 0; place < all.size(); ++place) {
      const bool is_saddle = has_index(all[place], 1) || has_index(all[place], 2);
      if (is_saddle && is_above(contact_cosine(set, all[place]), bound)) angle.above.push_back(place);
    }
  }
  const std::vector<PersistencePair> pairs = persistence_pairs(set);
  std::set<Rational> lengths;
  for (const PersistencePair& pair : pairs) {
    if (pair.death) lengths.insert(short_length(*pair.death, pair.birth));
  }
  std::set<Rational> chosen = chosen_lengths(lengths);
  if (!lengths.empty()) chosen.insert(*lengths.begin());
  for (const Rational& persistence : chosen) {
    answer.lengths.push_back({persistence, levels_of(all, pairs, persistence)});
  }
  return answer;
}

// ---- Statistics ----

namespace {

// Inside of a Voronoi edge, by a segment that crosses a facet.
bool ends_at_constructed(const PointSet& set, const FlowSegment& segment) {
  const std::string type = segment_type(set, segment);
  return type == "V-F-E" || type == "E-F-E";
}

void add_orbit(const PointSet& set, const Orbit& path, StatisticsAnswer& answer) {
  ++answer.n_u2[path.segments.size()];
  std::size_t run = 0;
  const auto end_run = [&] {
    if (run > 0) ++answer.n_wcc[run];
    run = 0;
  };
  for (const FlowSegment& segment : path.segments) {
    if (ends_at_constructed(set, segment)) {
      ++run;
    } else {
      end_run();
    }
  }
  end_run();
}

// The chains of segments that begin at `front`, against the flow.
void add_connecting_orbits(const StableSet& stable, const Corner& front, std::size_t length, StatisticsAnswer& answer) {
  for (const BackwardSegment& segment : stable.segments) {
    if (segment.front != front) continue;
    if (segment.back_kind == BackKind::kCritical) ++answer.n_s2[length + 1];
    add_connecting_orbits(stable, segment.back, length + 1, answer);
  }
}

}  // namespace

StatisticsAnswer statistics_answer(const PointSet& set, const std::vector<StationaryPoint>& all) {
  StatisticsAnswer answer;
  for (const StationaryPoint& x : all) {
    if (!has_index(x, 2)) continue;
    for (const Orbit& path : unstable_orbits(set, x)) add_orbit(set, path, answer);
    add_connecting_orbits(stable_set(set, x), x.center, 0, answer);
  }
  return answer;
}

}  // namespace oracle::vectors
