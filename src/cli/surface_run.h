// What `flowcert surface` computes: the stable manifolds and, only where a selection asks for them, the
// persistence pairs, which take the unstable manifolds as well.
#pragma once

#include <vector>

#include "cli/layer.h"
#include "flowcert/persistence.h"

namespace flowcert::cli {

// The order of the members is that of their making: each refers to those before it.
struct SurfaceRun {
  // points must outlive it.
  explicit SurfaceRun(const PointSet& points);

  // By number in StableManifolds, of the critical points of index 2: death minus birth of the pair that it is
  // in, as the death of a tunnel or the birth of a void. Flows from all saddles.
  [[nodiscard]] std::vector<Rational> gaps() const;
  // Exact, of the critical point of index 2 of that number.
  [[nodiscard]] Rational squared_value(std::size_t number) const;
  [[nodiscard]] std::size_t size() const { return stationary.critical_counts()[2]; }

  const PointSet& points;
  VoronoiDiagram diagram;
  StationaryPoints stationary;
  StableManifolds stable;
};

}  // namespace flowcert::cli
