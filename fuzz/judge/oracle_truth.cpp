// The oracle computes both, except for what a vector says itself.
#include "fuzz/judge/oracle_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "geometry/contract.h"
#include "oracle/fast/point_set.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/stable_pieces.h"

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

BackwardSegment segment_of(const oracle::BackwardSegment& segment) {
  static constexpr std::array kKinds = {BackKind::kCritical, BackKind::kRegular, BackKind::kEdge,
                                        BackKind::kVertex};  // as the oracle's are ordered
  return {{static_cast<PointId>(segment.samples[0]), static_cast<PointId>(segment.samples[1])},
          segment.front,
          segment.back,
          names_of(segment.front_contact),
          names_of(segment.back_contact),
          kKinds.at(static_cast<std::size_t>(segment.back_kind))};
}

// Intervals that sectors come through are left out, because the sectors' corners tell them.
StableSet stable_set_of(const oracle::PointSet& points, const oracle::StableSet& set) {
  StableSet result;
  for (const auto& segment : set.segments) result.segments.push_back(segment_of(segment));
  for (const auto& interval : set.intervals) {
    if (interval.kind == oracle::IntervalKind::kCrossed) continue;
    result.intervals.push_back(
        {names_of(interval.polygon), interval.front, interval.back, !oracle::flow_segment(points, interval.back)});
  }
  for (const auto& sector : set.sectors) {
    result.sectors.push_back(
        {{static_cast<PointId>(sector.samples[0]), static_cast<PointId>(sector.samples[1])}, sector.polygon});
  }
  return result;
}

class OracleTruth final : public Truth {
 public:
  OracleTruth(const std::vector<std::array<double, 3>>& rows, oracle::Answer answer)
      : set_(rows), answer_(std::move(answer)) {
    for (const oracle::StationaryPoint& point : answer_.stationary) {
      record_at_[point.center] = contacts_.size();
      auto& contact = contacts_.emplace_back();
      for (const std::size_t name : point.contact) contact.push_back(static_cast<PointId>(name));
    }
  }

  [[nodiscard]] std::size_t size() const override { return contacts_.size(); }
  [[nodiscard]] StationaryIndex index(std::size_t i) const override {
    const oracle::StationaryPoint& point = answer_.stationary[i];
    return {static_cast<std::uint8_t>(point.face_dimension), static_cast<std::uint8_t>(point.hull_dimension)};
  }
  [[nodiscard]] std::span<const PointId> contact(std::size_t i) const override { return contacts_[i]; }
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
      if (segment.back_kind == oracle::BackKind::kCritical) is_odd[segment.back] ^= true;
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
  [[nodiscard]] StableSet stable_set(std::size_t i) override { return stable_set_of(set_, stable(i)); }

 private:
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

std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows, oracle::Answer answer) {
  return std::make_unique<OracleTruth>(triples(rows), std::move(answer));
}

// ---- Persistence pairs ----

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

namespace {

class VectorTruth final : public Truth {
 public:
  explicit VectorTruth(const VectorCase& one) : case_(one), oracle_(oracle_truth(one.rows, one.answer)) {}

  [[nodiscard]] std::size_t size() const override { return oracle_->size(); }
  [[nodiscard]] StationaryIndex index(std::size_t i) const override { return oracle_->index(i); }
  [[nodiscard]] std::span<const PointId> contact(std::size_t i) const override { return oracle_->contact(i); }
  [[nodiscard]] ExactSphere sphere(std::size_t i) override { return oracle_->sphere(i); }

  [[nodiscard]] std::array<std::optional<std::size_t>, 2> limits(std::size_t i) override {
    return case_.limits[i] ? *case_.limits[i] : oracle_->limits(i);
  }
  [[nodiscard]] std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) override {
    return oracle_->polyline(i, side);
  }
  [[nodiscard]] TruePath orbit(const RationalPoint& start) override { return oracle_->orbit(start); }
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) override {
    if (!case_.stable[i]) return oracle_->boundary(i);
    if (!case_.stable[i]->boundary) return std::nullopt;
    return std::vector<std::uint32_t>(case_.stable[i]->boundary->begin(), case_.stable[i]->boundary->end());
  }
  [[nodiscard]] StableSummary stable_summary(std::size_t i) override {
    if (!case_.stable[i]) return oracle_->stable_summary(i);
    return {case_.stable[i]->segments, case_.stable[i]->has_vertex, case_.stable[i]->has_interval};
  }
  [[nodiscard]] StableSet stable_set(std::size_t i) override { return oracle_->stable_set(i); }

 private:
  const VectorCase& case_;
  std::unique_ptr<Truth> oracle_;
};

}  // namespace

std::unique_ptr<Truth> vector_truth(const VectorCase& one) {
  FLOWCERT_REQUIRES(!one.is_invalid());
  return std::make_unique<VectorTruth>(one);
}

}  // namespace flowcert::judge
