// The parts of a run are made in turn. The reported times of several runs are medians.
#include "cli/compute_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "cli/progress.h"

namespace flowcert::cli {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

// In seconds, with an entry for each run.
struct Times {
  std::vector<double> delaunay, critical, u2, s2, limits, volumes, all;
};

FlowComplex run_once(const PointSet& points, const Measured& wanted, const FlowOptions& options, unsigned run,
                     Times& times, const PartMade& made) {
  const unsigned runs = wanted.runs;
  FlowComplex complex(points, options, part_progress(runs == 1 ? "" : fmt::format(", run {} of {}", run + 1, runs)));
  const auto seconds_to_make = [&](FlowComplexPart part) {
    const Clock::time_point start = Clock::now();
    complex.make(part);
    const double seconds = seconds_between(start, Clock::now());
    if (made && run + 1 == runs) made(complex, part);
    return seconds;
  };
  times.delaunay.push_back(seconds_to_make(FlowComplexPart::kTriangulation));
  times.critical.push_back(seconds_to_make(FlowComplexPart::kStationary));
  if (wanted.has_s2()) times.s2.push_back(seconds_to_make(FlowComplexPart::kStable));
  if (wanted.has_u2()) times.u2.push_back(seconds_to_make(FlowComplexPart::kUnstable));
  if (wanted.has_all()) {
    times.limits.push_back(seconds_to_make(FlowComplexPart::kLimits));
    times.volumes.push_back(seconds_to_make(FlowComplexPart::kVolumes));
  }
  return complex;
}

}  // namespace

Measured measure(const PointSet& points, unsigned runs, const FlowOptions& options,
                 const std::set<FlowComplexPart>& parts, const PartMade& made) {
  const ProgressLine progress("computing");
  Measured result{.last = {}, .parts = parts, .runs = runs, .ratios = {}};
  Times times;
  for (unsigned run = 0; run < runs; ++run) {
    result.last.reset();
    result.last.emplace(run_once(points, result, options, run, times, made));
    times.all.push_back(times.critical.back() + (result.has_u2() ? times.u2.back() : 0) +
                        (result.has_s2() ? times.s2.back() : 0) +
                        (result.has_all() ? times.limits.back() + times.volumes.back() : 0));
  }
  result.delaunay_seconds = median(times.delaunay);
  result.critical_seconds = median(times.critical);
  if (result.has_u2()) result.u2_seconds = median(times.u2);
  if (result.has_s2()) result.s2_seconds = median(times.s2);
  if (result.has_all()) result.limits_seconds = median(times.limits);
  if (result.has_all()) result.volumes_seconds = median(times.volumes);
  if (points.size() >= 4 && result.delaunay_seconds > 0) {
    result.ratios = {.critical = result.critical_seconds / result.delaunay_seconds,
                     .u2 = result.u2_seconds / result.delaunay_seconds,
                     .s2 = result.s2_seconds / result.delaunay_seconds,
                     .limits = result.limits_seconds / result.delaunay_seconds,
                     .volumes = result.volumes_seconds / result.delaunay_seconds,
                     .all = median(times.all) / result.delaunay_seconds};
  }
  return result;
}

}  // namespace flowcert::cli
