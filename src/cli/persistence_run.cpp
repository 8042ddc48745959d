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

}  // namespace

PersistenceRun::PersistenceRun(const PointSet& points, std::uint64_t seed)
    : delaunay(timed("Delaunay triangulation", seconds.delaunay,
                     [&](const auto& progress) { return Delaunay(points, progress); })),
      stationary(timed("critical points", seconds.critical,
                       [&](const auto&) { return stationary_points(delaunay); })),
      unstable(
          timed("unstable manifolds", seconds.u2,
                [&](const auto& progress) { return UnstableManifolds(delaunay, stationary, {}, progress); })),
      stable(timed("stable manifolds", seconds.s2,
                   [&](const auto& progress) {
                     return StableManifolds(delaunay, stationary, {.flow = {}, .seed = seed}, progress);
                   })),
      complex(timed("chain complex", seconds.pairs,
                    [&](const auto&) { return ChainComplex(points, stationary, unstable, stable, seed); })),
      persistence(timed("persistence", seconds.pairs,
                        [&](const auto&) { return Persistence(points, stationary, complex); })) {}

}  // namespace flowcert::cli
