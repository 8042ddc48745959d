// Each part has a lock of its own, so that threads that ask for one at the same time wait for one another. A part
// locks only the parts below it, so that no two threads wait for each other. std::call_once does not serve, because
// with some C libraries it hangs after an exception.
#include "flowcert/flow_complex.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <tuple>
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

using enum FlowComplexPart;

// The others are not interrupted, and this file reports when they are made.
bool tells_by_itself(FlowComplexPart part) {
  return part == kTriangulation || part == kUnstable || part == kStable || part == kLimits || part == kVolumes;
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

  // What is made of a part.
  template <FlowComplexPart part>
  [[nodiscard]] auto& get() {
    return std::get<static_cast<std::size_t>(part)>(all_made);
  }

  template <FlowComplexPart part>
  void forget() {
    get<part>().reset();
    is_made[static_cast<std::size_t>(part)].store(false, std::memory_order_release);
  }

  std::array<std::mutex, kFlowComplexParts> making;
  std::array<std::atomic<bool>, kFlowComplexParts> is_made{};
  FilterTally tally;
  // In the order of FlowComplexPart. The triangulation is there until the diagram is made.
  std::tuple<std::optional<Delaunay>, std::optional<VoronoiDiagram>, std::optional<StationaryPoints>,
             std::optional<UnstableManifolds>, std::optional<StableManifolds>, std::optional<ChainComplex>,
             std::optional<SaddleLinks>, std::optional<Persistence>, std::optional<FlowLimits>,
             std::optional<StableVolumes>, std::optional<UnstableSurfaces>, std::optional<MergeTrees>>
      all_made;

  // All locators are copies of one, which share what does not change.
  auto with_locator(const FlowLimits& by_limits, const auto& use) {
    const auto make = [&] {
      const std::scoped_lock lock(making_locator);
      if (!locator) locator.emplace(*get<kDiagram>(), *get<kStationary>(), by_limits, options);
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
    case kTriangulation:
      all.get<kTriangulation>().emplace(all.points, progress, all.options.most_cells);
      break;
    case kDiagram:
      make(kTriangulation);
      all.tally = {};
      all.get<kDiagram>().emplace(*all.get<kTriangulation>(), &all.tally, all.options.threads, progress);
      break;
    case kStationary:
      all.get<kStationary>() = stationary_points(diagram(), all.options.threads, progress);
      break;
    case kUnstable:
      all.get<kUnstable>().emplace(diagram(), stationary(), all.options, progress);
      break;
    case kStable:
      all.get<kStable>().emplace(diagram(), stationary(), all.options, progress);
      break;
    case kChains:
      make(kUnstable);
      make(kStable);
      if (progress) progress(0, 1);
      all.get<kChains>().emplace(all.points, stationary(), unstable(), stable(), all.options.seed);
      break;
    case kLinks:
      make(kStable);
      if (progress) progress(0, 1);
      all.get<kLinks>().emplace(diagram(), stationary(), stable(), all.options.threads);
      break;
    case kPersistence:
      make(kLinks);
      if (progress) progress(0, 1);
      all.get<kPersistence>().emplace(all.points, stationary(), links(), all.options.threads);
      break;
    case kLimits:
      all.get<kLimits>().emplace(diagram(), stationary(), all.options, progress);
      break;
    case kVolumes:
      all.get<kVolumes>().emplace(diagram(), stationary(), limits(), all.options.threads, progress);
      break;
    case kUnstableSurfaces:
      make(kStationary);
      if (progress) progress(0, 1);
      all.get<kUnstableSurfaces>().emplace(diagram(), stationary(), all.options);
      break;
    case kMergeTrees:
      make(kLimits);
      if (progress) progress(0, 1);
      all.get<kMergeTrees>().emplace(all.points, stationary(), limits());
      break;
  }
  // From here on nothing throws but the last report, and then the part stays.
  // The triangulation is as large as all of the diagram, and nothing asks for it any more.
  if (part == kDiagram) all.get<kTriangulation>().reset();
  all.is_made[number].store(true, std::memory_order_release);
  if (progress && !tells_by_itself(part)) progress(1, 1);
}

// What refers to another part goes first.
void FlowComplex::forget_diagram() {
  FLOWCERT_REQUIRES(parts_ != nullptr);
  Parts& all = *parts_;
  all.locators.clear();
  all.locator.reset();
  all.flows.clear();
  all.forget<kMergeTrees>();
  all.forget<kUnstableSurfaces>();
  all.forget<kVolumes>();
  all.forget<kLimits>();
  all.forget<kStable>();
  all.forget<kUnstable>();
  all.forget<kDiagram>();
  all.forget<kTriangulation>();
}

namespace {

template <FlowComplexPart part>
const auto& made(const FlowComplex& complex, const auto& parts) {
  complex.make(part);
  return *parts->template get<part>();
}

}  // namespace

const PointSet& FlowComplex::points() const { return parts_->points; }
unsigned FlowComplex::threads() const { return parts_->options.threads; }

int FlowComplex::dimension() const { return diagram().dimension(); }
std::size_t FlowComplex::delaunay_cells() const { return diagram().delaunay().cells.size(); }
const FilterTally& FlowComplex::filter_tally() const {
  make(kDiagram);
  return parts_->tally;
}

const VoronoiDiagram& FlowComplex::diagram() const { return made<kDiagram>(*this, parts_); }
const StationaryPoints& FlowComplex::stationary() const { return made<kStationary>(*this, parts_); }
const UnstableManifolds& FlowComplex::unstable() const { return made<kUnstable>(*this, parts_); }
const StableManifolds& FlowComplex::stable() const { return made<kStable>(*this, parts_); }
const ChainComplex& FlowComplex::chains() const { return made<kChains>(*this, parts_); }
const SaddleLinks& FlowComplex::links() const { return made<kLinks>(*this, parts_); }
const Persistence& FlowComplex::persistence() const { return made<kPersistence>(*this, parts_); }
const FlowLimits& FlowComplex::limits() const { return made<kLimits>(*this, parts_); }
const StableVolumes& FlowComplex::volumes() const { return made<kVolumes>(*this, parts_); }
const UnstableSurfaces& FlowComplex::unstable_surfaces() const { return made<kUnstableSurfaces>(*this, parts_); }
const MergeTrees& FlowComplex::merge_trees() const { return made<kMergeTrees>(*this, parts_); }

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
