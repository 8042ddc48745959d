// The oracle computes both, except for what a vector says itself.
#include "fuzz/judge/oracle_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "flowcert/sphere.h"
#include "fuzz/judge/hull_volume.h"
#include "fuzz/judge/root_sum.h"
#include "fuzz/properties/stable_pieces.h"
#include "geometry/contract.h"
#include "geometry/difference_of_roots.h"
#include "oracle/fast/point_set.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/pockets.h"
#include "oracle/stable_pieces.h"
#include "oracle/stationary_points.h"
#include "oracle/unstable_set.h"

namespace flowcert::judge {

// ---- The oracle's ----

namespace {

std::vector<std::array<double, 3>> triples(const std::vector<Point>& rows) {
  std::vector<std::array<double, 3>> result;
  result.reserve(rows.size());
  for (const Point& p : rows) result.push_back({p.x, p.y, p.z});
  return result;
}

std::vector<PointId> names_of(const auto& names) {
  std::vector<PointId> result(std::size(names));
  std::ranges::transform(names, result.begin(), [](std::size_t name) { return static_cast<PointId>(name); });
  return result;
}

class OracleTruth : public Truth {
 public:
  OracleTruth(const std::vector<std::array<double, 3>>& rows, oracle::Answer answer)
      : set_(rows), answer_(std::move(answer)) {
    for (const oracle::StationaryPoint& point : answer_.stationary) {
      record_at_[point.center] = contacts_.size();
      contacts_.push_back(names_of(point.contact));
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const oracle::StationaryPoint& point = answer_.stationary[i];
      add({static_cast<std::uint8_t>(point.face_dimension), static_cast<std::uint8_t>(point.hull_dimension)},
          contacts_[i]);
    }
  }

  [[nodiscard]] ExactSphere sphere(std::size_t i) override {
    return {answer_.stationary[i].center, answer_.stationary[i].squared_distance};
  }

  [[nodiscard]] std::array<std::optional<std::size_t>, 2> limits(std::size_t i) override {
    return {path(i, 0).limit, path(i, 1).limit};
  }

  [[nodiscard]] std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) override {
    return true_segments(path(i, side));
  }

  [[nodiscard]] TruePath orbit(const RationalPoint& start) override {
    Path path;
    if (const auto record = record_at_.find(start); record != record_at_.end()) {
      path.limit = record->second;
    } else {
      path.segments.push_back(step_from(start));
      follow(path);
    }
    return {true_segments(path), path.limit};
  }

  // The oracle breaks no ties.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) override {
    const oracle::StableSet& set = stable(i);
    if (oracle::has_tie(set)) return std::nullopt;
    std::map<oracle::Point, bool> is_odd;
    for (const oracle::BackwardSegment& segment : set.segments) {
      if (segment.back_kind == oracle::BackKind::kCritical) is_odd[segment.back.position] ^= true;
    }
    std::vector<std::uint32_t> records;
    for (const auto& [midpoint, odd] : is_odd) {
      if (odd) records.push_back(static_cast<std::uint32_t>(record_at_.at(midpoint)));
    }
    std::ranges::sort(records);
    return records;
  }
  [[nodiscard]] StableSummary stable_summary(std::size_t i) override {
    const oracle::StableSet& set = stable(i);
    return {oracle::segments_without_intervals(answer_.stationary[i], set), set.has_vertex, !set.intervals.empty()};
  }
  [[nodiscard]] StableSet<> stable_set(std::optional<std::size_t> i) override {
    return property::to_fast(set_, i ? stable(*i) : oracle::stable_set_of_infinity(set_));
  }

  [[nodiscard]] LambdaList lambda_list(std::size_t i) override {
    LambdaList list;
    for (const oracle::UnstableEntry& entry : lambda(i)) {
      const auto limit = record_of(entry.limit);
      if (entry.is_arc) {
        list.arcs.push_back(limit);
        continue;
      }
      const auto exit = exit_of(answer_.stationary[i], *entry.from);
      list.directions.push_back({limit, exit.value_or(*entry.from), !exit});
    }
    return list;
  }
  [[nodiscard]] std::vector<FlowLimits::Entry> lambda_entries(std::size_t i) override {
    std::vector<FlowLimits::Entry> entries;
    for (const oracle::UnstableEntry& entry : lambda(i)) {
      const auto limit = record_of(entry.limit);
      entries.push_back({limit ? static_cast<std::uint32_t>(*limit) : FlowLimits::Entry::kInfinity, entry.is_arc});
    }
    return entries;
  }

  [[nodiscard]] Rational volume(std::size_t i) override {
    return has_volume(i) ? oracle::volume(set_, stable(i)) : Rational(0);
  }
  [[nodiscard]] double nearest_sum(std::span<const std::uint32_t> records) override {
    Rational sum = 0;
    for (const std::uint32_t record : records) sum += volume(record);
    return nearest_or_infinity(sum);
  }
  [[nodiscard]] std::vector<std::pair<PointId, Rational>> shares(std::size_t i) override {
    std::vector<std::pair<PointId, Rational>> shares;
    if (!has_volume(i)) return shares;
    const std::vector<Rational> all = oracle::shares(set_, stable(i));
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k] != 0) shares.emplace_back(static_cast<PointId>(set_.names[k]), all[k]);
    }
    return shares;
  }
  [[nodiscard]] std::vector<std::pair<PointId, double>> nearest_shares(std::size_t i) override {
    std::vector<std::pair<PointId, double>> rounded;
    for (const auto& [name, share] : shares(i)) {
      rounded.emplace_back(name, nearest_double(share).value_or(std::numeric_limits<double>::infinity()));
    }
    return rounded;
  }
  [[nodiscard]] Rational hull_volume() override { return oracle_hull_volume(set_.points); }

  [[nodiscard]] UnstableSurface<> unstable_surface(std::size_t i) override {
    return property::to_fast(oracle::unstable_surface(set_, answer_.stationary[i]));
  }

  // It takes the oracle seconds, so that they are made once.
  [[nodiscard]] TruePockets pockets(const Rational& squared_persistence) override {
    const auto known = pockets_.find(squared_persistence);
    if (known != pockets_.end()) return known->second;
    return pockets_.emplace(squared_persistence, pockets_at(squared_persistence)).first->second;
  }
  [[nodiscard]] double area(std::size_t i) override {
    double sum = 0;
    const std::vector<Rational> squares = oracle::squared_areas(set_, stable(i));
    for (const Rational& square : squares) sum += geometry::nearest_difference_of_roots(square, 0);
    // The oracle says whether this sum is right, where it is no subnormal number and no infinity.
    const bool is_plain = std::isnormal(sum);
    if (is_plain && !is_root_sum(sum, squares)) throw std::logic_error("an area that the oracle denies");
    return sum;
  }

 private:
  static std::vector<std::uint32_t> records_of(const std::vector<std::size_t>& places) {
    return {places.begin(), places.end()};
  }
  [[nodiscard]] Pocket pocket_of(const oracle::Pocket& pocket) const {
    const auto value = [&](std::size_t mouth) { return answer_.stationary[mouth].squared_distance; };
    return {records_of(pocket.maxima),
            records_of(pocket.peaks),
            records_of(pocket.cell),
            records_of(pocket.mouths),
            records_of(pocket.neighbours),
            static_cast<std::uint32_t>(*std::ranges::max_element(pocket.mouths, {}, value)),
            {records_of(pocket.to_infinity.gates)}};
  }

  [[nodiscard]] TruePockets pockets_at(const Rational& squared_persistence) const {
    const oracle::Pockets all = oracle::pockets(set_, answer_.stationary, squared_persistence);
    TruePockets truth{{}, records_of(all.outside), records_of(largest_balls(answer_.stationary, all)), {}, {}};
    if (const auto widest = oracle::widest_path(all)) truth.widest = WidestPath{records_of(widest->gates)};
    for (const oracle::Pocket& pocket : all.pockets) {
      truth.pockets.push_back(pocket_of(pocket));
      for (const std::size_t mouth : pocket.mouths) {
        truth.above_mouths[static_cast<std::uint32_t>(mouth)] =
            records_of(oracle::pockets_above(set_, answer_.stationary, all, answer_.stationary[mouth]));
      }
    }
    return truth;
  }

  [[nodiscard]] bool has_volume(std::size_t i) const { return index(i).hull_dimension >= 2; }

  [[nodiscard]] std::optional<std::size_t> record_of(const std::optional<oracle::StationaryPoint>& limit) const {
    return limit ? std::optional(record_at_.at(limit->center)) : std::nullopt;
  }

  const std::vector<oracle::UnstableEntry>& lambda(std::size_t i) {
    const auto known = lambda_.find(i);
    if (known != lambda_.end()) return known->second;
    return lambda_.emplace(i, oracle::lambda_list(set_, answer_.stationary[i])).first->second;
  }

  // Where the ray along u leaves the closed Voronoi face of y's directions.
  [[nodiscard]] std::optional<oracle::Point> exit_of(const oracle::StationaryPoint& y, const oracle::Point& u) const {
    const oracle::Places contact = oracle::places_of(set_, y.contact);
    const auto along = [&](std::size_t k) { return oracle::dot(set_.points[k], u); };
    const std::size_t p = *std::ranges::max_element(contact, {}, along);
    const std::optional<Rational> time = set_.first_meeting(p, y.center, u);
    return time ? std::optional(oracle::moved(y.center, *time, u)) : std::nullopt;
  }

  const oracle::StableSet& stable(std::size_t i) {
    const auto known = stable_.find(i);
    if (known != stable_.end()) return known->second;
    return stable_.emplace(i, oracle::stable_set(set_, answer_.stationary[i])).first->second;
  }

  struct Path {
    std::vector<oracle::FlowSegment> segments;
    std::optional<std::size_t> limit;  // none: infinity
  };

  // What follows a position depends on it alone (FC-FLOW-08). At a vertex of many cospherical samples one step takes
  // the oracle seconds. So each step is taken once, and an orbit is not followed beyond a stationary point.
  Path path(std::size_t i, std::size_t side) {
    Path path;
    path.segments.push_back(oracle::unstable_segment(set_, answer_.stationary[i], static_cast<int>(side)));
    follow(path);
    return path;
  }

  // Goes on from the end of the last segment.
  void follow(Path& path) {
    while (path.segments.back().end) {
      const oracle::Point& reached = *path.segments.back().end;
      const auto record = record_at_.find(reached);
      if (record != record_at_.end()) {
        path.limit = record->second;
        break;
      }
      path.segments.push_back(step_from(reached));
    }
  }

  [[nodiscard]] std::vector<TrueSegment> true_segments(const Path& path) const {
    std::vector<TrueSegment> line;
    line.reserve(path.segments.size());
    for (const oracle::FlowSegment& segment : path.segments) {
      line.push_back({oracle::segment_type(set_, segment), segment.driver, segment.end});
    }
    return line;
  }

  const oracle::FlowSegment& step_from(const oracle::Point& x) {
    const auto known = step_from_.find(x);
    if (known != step_from_.end()) return known->second;
    const auto segment = oracle::flow_segment(set_, x);
    if (!segment) throw std::logic_error("a stationary point that is not among those that are known");
    return step_from_.emplace(x, *segment).first->second;
  }

  oracle::fast::PointSet set_;
  oracle::Answer answer_;
  std::vector<std::vector<PointId>> contacts_;
  std::map<oracle::Point, std::size_t> record_at_;
  std::map<oracle::Point, oracle::FlowSegment> step_from_;
  std::map<std::size_t, oracle::StableSet> stable_;
  std::map<std::size_t, std::vector<oracle::UnstableEntry>> lambda_;
  std::map<Rational, TruePockets> pockets_;  // by squared persistence
};

}  // namespace

std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows) {
  if (rows.size() > kMostPointsForOracle) {
    throw InvalidInput(fmt::format("--oracle: {} points; the oracle's search takes time n^5, and serves {}",
                                   rows.size(), kMostPointsForOracle));
  }
  const auto coordinates = triples(rows);
  return std::make_unique<OracleTruth>(coordinates, oracle::stationary_points(oracle::fast::PointSet(coordinates)));
}

// ---- Persistence pairs ----

namespace {

// The oracle's homology takes the cube of time n^4.
constexpr std::size_t kMostPointsForOraclePairs = 12;

std::vector<ListedPair> oracle_pairs(const std::vector<Point>& rows) {
  if (rows.size() > kMostPointsForOraclePairs) {
    throw InvalidInput(fmt::format("the oracle pairs critical points of up to {} points", kMostPointsForOraclePairs));
  }
  std::vector<ListedPair> pairs;
  for (const oracle::PersistencePair& pair : oracle::persistence_pairs(oracle::PointSet(triples(rows)))) {
    pairs.push_back({pair.dimension, pair.birth, pair.death});
  }
  return pairs;
}

// ---- A vector's ----

oracle::Answer answer_of(const VectorCase& one) {
  oracle::Answer answer{one.rows.size(), one.merged_duplicates, {}};
  for (const auto& [index, contact, sphere] : one.stationary) {
    answer.stationary.push_back({sphere.center,
                                 sphere.squared_radius,
                                 {contact.begin(), contact.end()},
                                 index.face_dimension,
                                 index.hull_dimension});
  }
  return answer;
}

class VectorTruth final : public OracleTruth {
 public:
  explicit VectorTruth(const VectorCase& one) : OracleTruth(triples(one.rows), answer_of(one)), case_(one) {}

  [[nodiscard]] std::array<std::optional<std::size_t>, 2> limits(std::size_t i) override {
    return case_.limits[i] ? *case_.limits[i] : OracleTruth::limits(i);
  }
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) override {
    if (!case_.stable[i]) return OracleTruth::boundary(i);
    if (!case_.stable[i]->boundary) return std::nullopt;
    return std::vector<std::uint32_t>(case_.stable[i]->boundary->begin(), case_.stable[i]->boundary->end());
  }
  [[nodiscard]] StableSummary stable_summary(std::size_t i) override {
    if (!case_.stable[i]) return OracleTruth::stable_summary(i);
    return {case_.stable[i]->segments, case_.stable[i]->has_vertex, case_.stable[i]->has_interval};
  }

 private:
  const VectorCase& case_;
};

}  // namespace

std::unique_ptr<Truth> vector_truth(const VectorCase& one) {
  FLOWCERT_REQUIRES(!one.is_invalid());
  return std::make_unique<VectorTruth>(one);
}

OtherTruth truth_of_oracle() {
  return {kMostPointsForOracle, [](const std::vector<Point>& rows) { return oracle_truth(rows); },
          kMostPointsForOraclePairs, oracle_pairs, vector_truth};
}

}  // namespace flowcert::judge
