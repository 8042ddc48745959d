// The truth by the fast implementation.
#include <algorithm>
#include <optional>

#include "certify/layer.h"
#include "certify/truth.h"
#include "flowcert/flow_complex.h"
#include "flowcert/stable_manifolds.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace certify;

namespace {

class FastTruth final : public Truth {
 public:
  explicit FastTruth(const FlowComplex& complex) : complex_(complex), finder_(complex_.stationary()) {
    const StationaryPoints& points = complex_.stationary();
    for (std::size_t i = 0; i < points.size(); ++i) add(points.index(i), points.contact(i));
  }
  explicit FastTruth(std::unique_ptr<FlowComplex> complex) : FastTruth(*complex) { own_ = std::move(complex); }

  [[nodiscard]] ExactSphere sphere(std::size_t i) override { return complex_.sphere(i); }

  [[nodiscard]] std::array<std::optional<std::size_t>, 2> limits(std::size_t i) override {
    const std::size_t k = number_of(i);
    return {complex_.unstable().limit(k, 0), complex_.unstable().limit(k, 1)};
  }

  [[nodiscard]] std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) override {
    return true_segments(complex_.unstable().orbit(number_of(i), side));
  }

  [[nodiscard]] TruePath orbit(const RationalPoint& start) override {
    Orbit orbit = complex_.orbit(start);
    TruePath path;
    if (orbit.limit) path.limit = finder_.find(orbit.limit->index, orbit.limit->contact);
    path.segments = true_segments(std::move(orbit));
    return path;
  }

  [[nodiscard]] std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) override {
    const auto records = complex_.stable().boundary(number_of(i));
    return std::vector(records.begin(), records.end());
  }
  [[nodiscard]] StableSummary stable_summary(std::size_t i) override {
    const std::size_t k = number_of(i);
    return {complex_.stable().segment_count(k), complex_.stable().has_vertex(k), complex_.stable().has_interval(k)};
  }
  [[nodiscard]] StableSet<> stable_set(std::optional<std::size_t> i) override {
    return i ? complex_.stable().set_of_record(*i) : complex_.stable().set_of_infinity();
  }

  [[nodiscard]] LambdaList lambda_list(std::size_t i) override { return complex_.limits().list(number_of_list(i)); }
  [[nodiscard]] std::vector<FlowLimits::Entry> lambda_entries(std::size_t i) override {
    return complex_.limits().entries(number_of_list(i));
  }

  [[nodiscard]] Rational volume(std::size_t i) override { return complex_.volumes().exact(i); }
  [[nodiscard]] double nearest_sum(std::span<const std::uint32_t> records) override {
    return complex_.volumes().nearest_sum(records);
  }
  [[nodiscard]] std::vector<std::pair<PointId, Rational>> shares(std::size_t i) override {
    return complex_.volumes().shares(i);
  }
  [[nodiscard]] std::vector<std::pair<PointId, double>> nearest_shares(std::size_t i) override {
    return complex_.volumes().rounded_shares(i);
  }
  [[nodiscard]] Rational hull_volume() override { return complex_.volumes().hull(); }

  [[nodiscard]] UnstableSurface<> unstable_surface(std::size_t i) override {
    const UnstableSurfaces& sets = complex_.unstable_surfaces();
    return sets.set(number_in(sets, set_records_, i));
  }

  [[nodiscard]] TruePockets pockets(const Rational& squared_persistence) override {
    const Pockets all(complex_.merge_trees(), squared_persistence);
    TruePockets truth{{}, all.outside(), all.largest_balls(), all.widest_path(), {}};
    for (std::size_t number = 0; number < all.size(); ++number) {
      truth.pockets.push_back(all[number]);
      for (const std::uint32_t mouth : all[number].mouths) truth.above_mouths.try_emplace(mouth, all.above(mouth));
    }
    return truth;
  }
  [[nodiscard]] double area(std::size_t i) override {
    return surface_area(complex_.points(), complex_.stable(), number_of(i));
  }

 private:
  static std::vector<TrueSegment> true_segments(Orbit orbit) {
    std::vector<TrueSegment> line;
    line.reserve(orbit.segments.size());
    for (FlowSegment& segment : orbit.segments) {
      line.push_back({type_text(segment.type), std::move(segment.driver), std::move(segment.end)});
    }
    return line;
  }

  // The number in StableManifolds: index-2 critical points come first, then the regular stationary points.
  [[nodiscard]] std::size_t number_of(std::size_t i) const {
    const auto [first, last] = finder_.range({2, 2});
    return i < last ? i - first : last - first + i - finder_.range({3, 3}).second;
  }

  // The number in a part that has its records in ascending order. They are listed at the first call.
  template <class Part>
  [[nodiscard]] static std::size_t number_in(const Part& part, std::vector<std::size_t>& records, std::size_t i) {
    if (records.empty()) {
      for (std::size_t k = 0; k < part.size(); ++k) records.push_back(part.record(k));
    }
    return static_cast<std::size_t>(std::ranges::lower_bound(records, i) - records.begin());
  }
  [[nodiscard]] std::size_t number_of_list(std::size_t i) { return number_in(complex_.limits(), list_records_, i); }

  std::unique_ptr<FlowComplex> own_;
  const FlowComplex& complex_;
  RecordFinder finder_;
  // Both are made when they are first asked for.
  std::vector<std::size_t> list_records_, set_records_;
};

}  // namespace

std::unique_ptr<Truth> fast_truth(const PointSet& points, unsigned threads) {
  return std::make_unique<FastTruth>(std::make_unique<FlowComplex>(points, FlowOptions{.threads = threads}));
}
std::unique_ptr<Truth> fast_truth(const FlowComplex& complex) { return std::make_unique<FastTruth>(complex); }

}  // namespace flowcert
