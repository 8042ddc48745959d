// Each part has a lock of its own, so that threads that ask for one at the same time wait for one another. A part
// locks only the parts below it, so that no two threads wait for each other. std::call_once does not serve, because
// with some C libraries it hangs after an exception.
#include "flowcert/flow_complex.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "flow/worker_pool.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "morse/flow_locator.h"
#include "morse/layer.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert {

using namespace morse;

namespace {

// The others are not interrupted, and this file reports when they are made.
bool tells_by_itself(FlowComplexPart part) {
  return part == FlowComplexPart::kTriangulation || part == FlowComplexPart::kUnstable ||
         part == FlowComplexPart::kStable || part == FlowComplexPart::kLimits || part == FlowComplexPart::kVolumes;
}

}  // namespace

std::size_t usual_most_cells(std::size_t points) { return std::max<std::size_t>(100 * points, 2'000'000); }

struct FlowComplex::Parts {
  Parts(PointSet all, FlowOptions how, Progress told)
      : points(std::move(all)), options(how), progress(std::move(told)) {
    if (options.threads == 0) throw std::invalid_argument("a flow complex takes at least one thread");
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  // For the constructor of a part.
  [[nodiscard]] flowcert::Progress progress_of(FlowComplexPart part) const {
    if (!progress) return {};
    return [this, part](std::size_t done, std::size_t total) { progress(part, done, total); };
  }

  auto with_flow(const VoronoiDiagram& faces, const auto& use) {
    return flows.with([&] { return std::make_unique<Flow>(faces, options); }, use);
  }

  PointSet points;
  FlowOptions options;
  Progress progress;

  std::array<std::mutex, kFlowComplexParts> making;
  std::array<std::atomic<bool>, kFlowComplexParts> is_made{};
  std::optional<Delaunay> triangulation;  // until the diagram is made
  FilterTally tally;
  std::optional<VoronoiDiagram> diagram;
  std::optional<StationaryPoints> stationary;
  std::optional<UnstableManifolds> unstable;
  std::optional<StableManifolds> stable;
  std::optional<ChainComplex> chains;
  std::optional<Persistence> persistence;
  std::optional<FlowLimits> limits;
  std::optional<StableVolumes> volumes;
  std::optional<UnstableSurfaces> unstable_surfaces;
  std::optional<MergeTrees> merge_trees;

  // All locators are copies of one, which share what does not change.
  auto with_locator(const FlowLimits& by_limits, const auto& use) {
    const auto make = [&] {
      const std::scoped_lock lock(making_locator);
      if (!locator) locator.emplace(*diagram, *stationary, by_limits, options);
      return std::make_unique<FlowLocator>(*locator);
    };
    return locators.with(make, use);
  }

  WorkerPool<Flow> flows;
  std::mutex making_locator;
  std::optional<FlowLocator> locator;
  WorkerPool<FlowLocator> locators;
};

FlowComplex::FlowComplex(PointSet points, FlowOptions options, Progress progress)
    : parts_(std::make_unique<Parts>(std::move(points), options, std::move(progress))) {}
FlowComplex::FlowComplex(std::span<const Point> rows, FlowOptions options, Progress progress)
    : FlowComplex(PointSet(rows), options, std::move(progress)) {}
FlowComplex::~FlowComplex() = default;
FlowComplex::FlowComplex(FlowComplex&&) noexcept = default;
FlowComplex& FlowComplex::operator=(FlowComplex&&) noexcept = default;

void FlowComplex::make(FlowComplexPart part) const {
  FLOWCERT_REQUIRES(parts_ != nullptr);
  Parts& all = *parts_;
  const auto number = static_cast<std::size_t>(part);
  if (all.is_made[number].load(std::memory_order_acquire)) return;
  const geometry::IeeeDoubles ieee;
  const std::scoped_lock lock(all.making[number]);
  if (all.is_made[number].load(std::memory_order_relaxed)) return;
  const auto progress = all.progress_of(part);
  switch (part) {
    case FlowComplexPart::kTriangulation:
      all.triangulation.emplace(all.points, progress, all.options.most_cells);
      break;
    case FlowComplexPart::kDiagram:
      make(FlowComplexPart::kTriangulation);
      all.tally = {};
      all.diagram.emplace(*all.triangulation, &all.tally, all.options.threads, progress);
      break;
    case FlowComplexPart::kStationary:
      make(FlowComplexPart::kDiagram);
      all.stationary = stationary_points(*all.diagram, all.options.threads, progress);
      break;
    case FlowComplexPart::kUnstable:
      make(FlowComplexPart::kStationary);
      all.unstable.emplace(*all.diagram, *all.stationary, all.options, progress);
      break;
    case FlowComplexPart::kStable:
      make(FlowComplexPart::kStationary);
      all.stable.emplace(*all.diagram, *all.stationary, all.options, progress);
      break;
    case FlowComplexPart::kChains:
      make(FlowComplexPart::kUnstable);
      make(FlowComplexPart::kStable);
      if (progress) progress(0, 1);
      all.chains.emplace(all.points, *all.stationary, *all.unstable, *all.stable, all.options.seed);
      break;
    case FlowComplexPart::kPersistence:
      make(FlowComplexPart::kChains);
      if (progress) progress(0, 1);
      all.persistence.emplace(all.points, *all.stationary, *all.chains);
      break;
    case FlowComplexPart::kLimits:
      make(FlowComplexPart::kStationary);
      all.limits.emplace(*all.diagram, *all.stationary, all.options, progress);
      break;
    case FlowComplexPart::kVolumes:
      make(FlowComplexPart::kLimits);
      all.volumes.emplace(*all.diagram, *all.stationary, *all.limits, all.options.threads, progress);
      break;
    case FlowComplexPart::kUnstableSurfaces:
      make(FlowComplexPart::kStationary);
      if (progress) progress(0, 1);
      all.unstable_surfaces.emplace(*all.diagram, *all.stationary, all.options);
      break;
    case FlowComplexPart::kMergeTrees:
      make(FlowComplexPart::kLimits);
      if (progress) progress(0, 1);
      all.merge_trees.emplace(all.points, *all.stationary, *all.limits);
      break;
  }
  // From here on nothing throws but the last report, and then the part stays.
  // The triangulation is as large as all of the diagram, and nothing asks for it any more.
  if (part == FlowComplexPart::kDiagram) all.triangulation.reset();
  all.is_made[number].store(true, std::memory_order_release);
  if (progress && !tells_by_itself(part)) progress(1, 1);
}

const PointSet& FlowComplex::points() const { return parts_->points; }
unsigned FlowComplex::threads() const { return parts_->options.threads; }

int FlowComplex::dimension() const { return diagram().dimension(); }
std::size_t FlowComplex::delaunay_cells() const { return diagram().delaunay().cells.size(); }
const VoronoiDiagram& FlowComplex::diagram() const {
  make(FlowComplexPart::kDiagram);
  return *parts_->diagram;
}

const FilterTally& FlowComplex::filter_tally() const {
  make(FlowComplexPart::kDiagram);
  return parts_->tally;
}

const StationaryPoints& FlowComplex::stationary() const {
  make(FlowComplexPart::kStationary);
  return *parts_->stationary;
}

const UnstableManifolds& FlowComplex::unstable() const {
  make(FlowComplexPart::kUnstable);
  return *parts_->unstable;
}

const StableManifolds& FlowComplex::stable() const {
  make(FlowComplexPart::kStable);
  return *parts_->stable;
}

const ChainComplex& FlowComplex::chains() const {
  make(FlowComplexPart::kChains);
  return *parts_->chains;
}

const Persistence& FlowComplex::persistence() const {
  make(FlowComplexPart::kPersistence);
  return *parts_->persistence;
}

const FlowLimits& FlowComplex::limits() const {
  make(FlowComplexPart::kLimits);
  return *parts_->limits;
}

const StableVolumes& FlowComplex::volumes() const {
  make(FlowComplexPart::kVolumes);
  return *parts_->volumes;
}

const UnstableSurfaces& FlowComplex::unstable_surfaces() const {
  make(FlowComplexPart::kUnstableSurfaces);
  return *parts_->unstable_surfaces;
}

const MergeTrees& FlowComplex::merge_trees() const {
  make(FlowComplexPart::kMergeTrees);
  return *parts_->merge_trees;
}

ExactSphere FlowComplex::sphere(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  return exact_sphere(points(), stationary().contact(record));
}

std::array<PointId, 2> FlowComplex::samples_of(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  const auto contact = stationary().contact(record);
  FLOWCERT_REQUIRES(stationary().index(record).face_dimension == 1);
  if (contact.size() == 2) return {contact[0], contact[1]};
  const RationalPoint center = sphere(record).center;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    for (std::size_t j = i + 1; j < contact.size(); ++j) {
      const Point &a = points().at_row(contact[i]), &b = points().at_row(contact[j]);
      if (geometry::exact_midpoint(a, b) == center) return {contact[i], contact[j]};
    }
  }
  throw std::logic_error("a stationary point on an edge is no midpoint of two samples");
}

RoundedSphere FlowComplex::rounded_sphere(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  return flowcert::rounded_sphere(points(), stationary().contact(record), stationary().index(record).hull_dimension);
}

std::vector<std::array<double, 3>> FlowComplex::centers() const {
  const geometry::IeeeDoubles ieee;
  std::vector<std::array<double, 3>> centers;
  centers.reserve(stationary().size());
  for (std::size_t record = 0; record < stationary().size(); ++record) {
    const auto [x, y, z] = rounded_sphere(record).center;
    centers.push_back({x, y, z});
  }
  return centers;
}

std::optional<StationaryLimit> FlowComplex::limit(const RationalPoint& start) const {
  const geometry::IeeeDoubles ieee;
  return parts_->with_flow(diagram(), [&](Flow& flow) { return flow.limit(start); });
}

Orbit FlowComplex::orbit(const RationalPoint& start) const {
  const geometry::IeeeDoubles ieee;
  return parts_->with_flow(diagram(), [&](Flow& flow) { return flow.orbit(start); });
}

FlowPlace FlowComplex::locate(const RationalPoint& x) const {
  const geometry::IeeeDoubles ieee;
  return parts_->with_locator(limits(), [&](FlowLocator& locator) { return locator.locate(x); });
}

FlowPlace FlowComplex::locate(const Point& x) const {
  const geometry::IeeeDoubles ieee;
  return parts_->with_locator(limits(), [&](FlowLocator& locator) { return locator.locate(x); });
}

FlowSegment FlowComplex::step(const RationalPoint& start) const {
  const geometry::IeeeDoubles ieee;
  return parts_->with_flow(diagram(), [&](Flow& flow) { return flow.step(start); });
}

}  // namespace flowcert
