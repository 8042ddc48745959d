// What `flowcert persistence` computes, with its times.
#pragma once

#include <cstdint>

#include "cli/layer.h"
#include "flowcert/persistence.h"

namespace flowcert::cli {

struct PersistenceSeconds {
  double delaunay = 0;
  double critical = 0;
  double u2 = 0;
  double s2 = 0;
  double pairs = 0;  // the chain complex, exact values and the pairs

  [[nodiscard]] double after_delaunay() const { return critical + u2 + s2 + pairs; }
};

// The order of the members is that of their making: each refers to those before it.
struct PersistenceRun {
  // seed: of all choices where ties are broken.
  PersistenceRun(const PointSet& points, std::uint64_t seed);

  PersistenceSeconds seconds;
  VoronoiDiagram diagram;
  StationaryPoints stationary;
  UnstableManifolds unstable;
  StableManifolds stable;
  ChainComplex complex;
  Persistence persistence;
};

}  // namespace flowcert::cli
