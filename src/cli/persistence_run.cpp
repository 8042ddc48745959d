// See persistence_run.h.
#include "cli/persistence_run.h"

#include <chrono>

#include "cli/with_progress.h"

namespace flowcert::cli {

namespace {

// Adds the time of its life.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;

  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

// with_progress(), timed.
template <typename Make>
auto timed(const char* what, double& seconds, const Make& make) {
  const Stopwatch watch(seconds);
  return with_progress(what, make);
}

VoronoiDiagram diagram_of(const PointSet& points, PersistenceSeconds& seconds) {
  const Delaunay delaunay = timed("Delaunay triangulation", seconds.delaunay,
                                  [&](const auto& progress) { return Delaunay(points, progress); });
  return timed("critical points", seconds.critical, [&](const auto&) { return VoronoiDiagram(delaunay); });
}

}  // namespace

PersistenceRun::PersistenceRun(const PointSet& points, std::uint64_t seed)
    : diagram(diagram_of(points, seconds)),
      stationary(timed("critical points", seconds.critical,
                       [&](const auto&) { return stationary_points(diagram); })),
      unstable(
          timed("unstable manifolds", seconds.u2,
                [&](const auto& progress) { return UnstableManifolds(diagram, stationary, {}, progress); })),
      stable(timed("stable manifolds", seconds.s2,
                   [&](const auto& progress) {
                     return StableManifolds(diagram, stationary, {.flow = {}, .seed = seed}, progress);
                   })),
      complex(timed("chain complex", seconds.pairs,
                    [&](const auto&) { return ChainComplex(points, stationary, unstable, stable, seed); })),
      persistence(timed("persistence", seconds.pairs,
                        [&](const auto&) { return Persistence(points, stationary, complex); })) {}

}  // namespace flowcert::cli
