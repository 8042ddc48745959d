// See surface_run.h.
#include "cli/surface_run.h"

#include "cli/with_progress.h"

namespace flowcert::cli {

SurfaceRun::SurfaceRun(const PointSet& points_)
    : points(points_),
      diagram(with_progress("Delaunay triangulation",
                            [&](const auto& progress) { return Delaunay(points, progress); })),
      stationary(stationary_points(diagram)),
      stable(with_progress("stable manifolds", [&](const auto& progress) {
        return StableManifolds(diagram, stationary, {}, progress);
      })) {}

std::vector<Rational> SurfaceRun::gaps() const {
  std::vector<Rational> gaps(size());
  if (gaps.empty()) return gaps;
  UnstableManifolds unstable = with_progress("unstable manifolds", [&](const auto& progress) {
    return UnstableManifolds(diagram, stationary, {}, progress);
  });
  const ChainComplex complex(points, stationary, unstable, stable);
  const Persistence persistence(points, stationary, complex);
  const std::size_t first = stable.record(0);
  // Every critical point of index 2 is in a pair that does not last (FC-PERS-02).
  for (const PersistencePair& pair : persistence.pairs()) {
    if (pair.dimension == 0 || !pair.death) continue;
    const std::size_t saddle = pair.dimension == 1 ? *pair.death : pair.birth;
    gaps.at(saddle - first) = persistence.squared_value(*pair.death) - persistence.squared_value(pair.birth);
  }
  return gaps;
}

Rational SurfaceRun::squared_value(std::size_t number) const {
  return exact_sphere(points, stationary.contact(stable.record(number))).squared_radius;
}

}  // namespace flowcert::cli
