// See oracle_truth.h.
#include "cli/oracle_truth.h"

#include <fmt/format.h>

#include <map>

#include "oracle/orbit.h"
#include "oracle/stationary_points.h"

namespace flowcert {

namespace {

std::vector<std::array<double, 3>> triples(const std::vector<Point>& rows) {
  std::vector<std::array<double, 3>> result;
  for (const Point& p : rows) result.push_back({p.x, p.y, p.z});
  return result;
}

class OracleTruth final : public Truth {
 public:
  explicit OracleTruth(const std::vector<std::array<double, 3>>& rows)
      : set_(rows), answer_(oracle::stationary_points(rows)) {
    for (const oracle::StationaryPoint& point : answer_.stationary) {
      record_of_[point.contact] = contacts_.size();
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
    std::array<std::optional<std::size_t>, 2> result;
    for (int side = 0; side < 2; ++side) {
      const oracle::Orbit orbit = oracle::unstable_orbit(set_, answer_.stationary[i], side);
      if (orbit.limit) result[static_cast<std::size_t>(side)] = record_of_.at(orbit.limit->contact);
    }
    return result;
  }

  [[nodiscard]] std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) override {
    std::vector<TrueSegment> line;
    const oracle::Orbit orbit = oracle::unstable_orbit(set_, answer_.stationary[i], static_cast<int>(side));
    for (const oracle::FlowSegment& segment : orbit.segments) {
      line.push_back({oracle::segment_type(set_, segment), segment.driver, segment.end});
    }
    return line;
  }

 private:
  oracle::PointSet set_;
  oracle::Answer answer_;
  std::vector<std::vector<PointId>> contacts_;
  std::map<std::vector<std::size_t>, std::size_t> record_of_;
};

}  // namespace

std::unique_ptr<Truth> oracle_truth(const std::vector<Point>& rows) {
  if (rows.size() > kMostPointsForOracle) {
    throw InvalidInput(fmt::format("--oracle: {} points; the oracle's search takes time n^5, and serves {}",
                                   rows.size(), kMostPointsForOracle));
  }
  return std::make_unique<OracleTruth>(triples(rows));
}

}  // namespace flowcert
