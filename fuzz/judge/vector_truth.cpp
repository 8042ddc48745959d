// See vector_truth.h.
#include "fuzz/judge/vector_truth.h"

#include "fuzz/judge/oracle_truth.h"

namespace flowcert::judge {

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

std::unique_ptr<Truth> vector_truth(const VectorCase& one) { return std::make_unique<VectorTruth>(one); }

}  // namespace flowcert::judge
