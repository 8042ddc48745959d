// What `flowcert compute` computes, with its times.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "cli/layer.h"
#include "flowcert/flow_complex.h"
#include "io/json_fields.h"

namespace flowcert::cli {

struct Measured {
  std::optional<FlowComplex> last;
  unsigned runs = 0;
  // Medians, of the triangulation, the stationary points and the other parts. The pairs' has that of chains and links,
  // too.
  std::map<FlowComplexPart, double> seconds;
  double seconds_after_delaunay = 0;  // of all but the triangulation; a median
  bool has_ratios = false;            // to the triangulation; not for fewer than 4 points, or no measurable time

  [[nodiscard]] bool has_u2() const { return seconds.contains(FlowComplexPart::kUnstable); }
  [[nodiscard]] bool has_s2() const { return seconds.contains(FlowComplexPart::kStable); }
  [[nodiscard]] bool has_all() const { return seconds.contains(FlowComplexPart::kVolumes); }
};

// Called with what the last run has just made. It may take its time, which is not measured.
using PartMade = std::function<void(FlowComplex& complex, FlowComplexPart part)>;

// Computes everything `runs` times. Each run makes the triangulation, the stationary points and these parts in turn, so
// that all parts see the same state of the machine.
[[nodiscard]] Measured measure(const PointSet& points, unsigned runs, const FlowOptions& options,
                               const std::vector<FlowComplexPart>& parts, const PartMade& made = {});

// Rows of a table: how long each part took.
void print_times(const Measured& measured);
// A row: how long this took, and how many times as long as the triangulation.
void print_time(const Measured& measured, const char* name, double seconds);
// Appends `seconds` and `ratio_to_delaunay` to an object.
void add_times(Json& object, const Measured& measured);

}  // namespace flowcert::cli
