// What `flowcert compute` computes, with its times.
#pragma once

#include <functional>
#include <optional>
#include <set>

#include "cli/layer.h"
#include "flowcert/flow_complex.h"

namespace flowcert::cli {

// Each is a time divided by the time of the triangulation.
struct DelaunayRatios {
  double critical = 0;
  double u2 = 0;
  double s2 = 0;
  double limits = 0;
  double volumes = 0;
  double all = 0;
};

struct Measured {
  std::optional<FlowComplex> last;
  // Parts beyond the stationary points: U2, S2, limits and volumes.
  std::set<FlowComplexPart> parts;
  [[nodiscard]] bool has_u2() const { return parts.contains(FlowComplexPart::kUnstable); }
  [[nodiscard]] bool has_s2() const { return parts.contains(FlowComplexPart::kStable); }
  [[nodiscard]] bool has_all() const { return parts.contains(FlowComplexPart::kVolumes); }
  unsigned runs = 0;
  double delaunay_seconds = 0;  // medians
  double critical_seconds = 0;
  double u2_seconds = 0;
  double s2_seconds = 0;
  double limits_seconds = 0;
  double volumes_seconds = 0;
  // None for fewer than 4 points, or no measurable time.
  std::optional<DelaunayRatios> ratios;
};

// Called with what the last run has just made. It may take its time, which is not measured.
using PartMade = std::function<void(const FlowComplex& complex, FlowComplexPart part)>;

// Computes everything `runs` times. Each run makes the triangulation, the critical points and these parts in turn, so
// that all parts see the same state of the machine.
[[nodiscard]] Measured measure(const PointSet& points, unsigned runs, const FlowOptions& options,
                               const std::set<FlowComplexPart>& parts, const PartMade& made = {});

}  // namespace flowcert::cli
