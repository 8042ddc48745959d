// What `flowcert compute` computes, with its times.
#pragma once

#include <memory>
#include <optional>

#include "cli/layer.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/unstable_manifolds.h"

namespace flowcert::cli {

// The order of the members is that of their making: each refers to those before it.
struct ComputeRun {
  explicit ComputeRun(const Delaunay& delaunay)
      : diagram(delaunay, &tally), stationary(stationary_points(diagram)) {}

  FilterTally tally;
  VoronoiDiagram diagram;
  StationaryPoints stationary;
  std::optional<UnstableManifolds> u2;  // where wanted
  std::optional<StableManifolds> s2;    // likewise
};

// Nothing where a manifold is not wanted.
struct WantedManifolds {
  std::optional<UnstableOptions> u2;
  std::optional<StableOptions> s2;
};

// Of a time to that of the triangulation.
struct DelaunayRatios {
  double critical = 0;
  double u2 = 0;
  double s2 = 0;
  double all = 0;
};

struct Measured {
  std::unique_ptr<ComputeRun> last;
  unsigned runs = 0;
  double delaunay_seconds = 0;  // medians
  double critical_seconds = 0;
  double u2_seconds = 0;
  double s2_seconds = 0;
  // None for fewer than 4 points, or no measurable time.
  std::optional<DelaunayRatios> ratios;
};

// As often as `runs` says: triangulation, critical points and what is wanted of manifolds in turn, so that
// all see the same machine.
[[nodiscard]] Measured measure(const PointSet& points, unsigned runs, const WantedManifolds& wanted);

}  // namespace flowcert::cli
