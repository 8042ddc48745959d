// The truth by the fast implementation (flowcert/check.h).
#include <optional>

#include "certify/layer.h"
#include "flowcert/check.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/unstable_manifolds.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace certify;

namespace {

class FastTruth final : public Truth {
 public:
  explicit FastTruth(const PointSet& points)
      : points_(points),
        diagram_(Delaunay(points)),
        stationary_(stationary_points(diagram_)),
        finder_(stationary_) {}

  [[nodiscard]] std::size_t size() const override { return stationary_.size(); }
  [[nodiscard]] StationaryIndex index(std::size_t i) const override { return stationary_.index(i); }
  [[nodiscard]] std::span<const PointId> contact(std::size_t i) const override {
    return stationary_.contact(i);
  }
  [[nodiscard]] ExactSphere sphere(std::size_t i) override {
    return exact_sphere(points_, stationary_.contact(i));
  }

  [[nodiscard]] std::array<std::optional<std::size_t>, 2> limits(std::size_t i) override {
    const std::size_t k = unstable(i);
    return {u2_->limit(k, 0), u2_->limit(k, 1)};
  }

  [[nodiscard]] std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) override {
    const std::size_t k = unstable(i);
    std::vector<TrueSegment> line;
    for (FlowSegment& segment : u2_->orbit(k, side).segments) {
      line.push_back({type_text(segment.type), std::move(segment.driver), std::move(segment.end)});
    }
    return line;
  }

  [[nodiscard]] std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) override {
    const auto records = stable().boundary(ordinal(i));
    return std::vector(records.begin(), records.end());
  }
  [[nodiscard]] StableSummary stable_summary(std::size_t i) override {
    const std::size_t k = ordinal(i);
    return {stable().segment_count(k), stable().has_vertex(k), stable().has_interval(k)};
  }
  [[nodiscard]] StableSet stable_set(std::size_t i) override { return stable().set(ordinal(i)); }

 private:
  // Among the index-2 critical points, or after them among the regular ones.
  [[nodiscard]] std::size_t ordinal(std::size_t i) const {
    const auto [first, last] = finder_.range({2, 2});
    return i < last ? i - first : last - first + i - finder_.range({3, 3}).second;
  }
  std::size_t unstable(std::size_t i) {
    if (!u2_) u2_.emplace(diagram_, stationary_);
    return ordinal(i);
  }
  StableManifolds& stable() {
    if (!s2_) s2_.emplace(diagram_, stationary_);
    return *s2_;
  }

  const PointSet& points_;
  VoronoiDiagram diagram_;
  StationaryPoints stationary_;
  RecordFinder finder_;
  std::optional<UnstableManifolds> u2_;
  std::optional<StableManifolds> s2_;
};

}  // namespace

std::unique_ptr<Truth> fast_truth(const PointSet& points) { return std::make_unique<FastTruth>(points); }

}  // namespace flowcert
