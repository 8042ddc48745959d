// See compute_run.h.
#include "cli/compute_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

#include "cli/progress_line.h"

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

// In seconds, an entry a run.
struct Times {
  std::vector<double> delaunay, critical, u2, s2, all;
};

std::string of_run(const std::string& what, unsigned run, unsigned runs) {
  return runs == 1 ? what : fmt::format("{}, run {} of {}", what, run + 1, runs);
}

std::unique_ptr<ComputeRun> run_once(const PointSet& points, const WantedManifolds& wanted, unsigned run,
                                     unsigned runs, Times& times) {
  std::optional<ProgressLine> progress(std::in_place, of_run("Delaunay triangulation", run, runs));
  const Clock::time_point start = Clock::now();
  std::optional<Delaunay> delaunay(std::in_place, points, std::ref(*progress));
  const Clock::time_point triangulated = Clock::now();
  auto result = std::make_unique<ComputeRun>(*delaunay);
  const Clock::time_point listed = Clock::now();
  times.delaunay.push_back(seconds_between(start, triangulated));
  times.critical.push_back(seconds_between(triangulated, listed));
  delaunay.reset();  // the diagram has all that is needed of it
  progress.reset();
  if (wanted.s2) {
    progress.emplace(of_run("stable manifolds", run, runs));
    const Clock::time_point flowing = Clock::now();
    result->s2.emplace(result->diagram, result->stationary, *wanted.s2, std::ref(*progress));
    times.s2.push_back(seconds_between(flowing, Clock::now()));
    progress.reset();
  }
  if (wanted.u2) {
    progress.emplace(of_run("unstable manifolds", run, runs));
    const Clock::time_point flowing = Clock::now();
    result->u2.emplace(result->diagram, result->stationary, *wanted.u2, std::ref(*progress));
    times.u2.push_back(seconds_between(flowing, Clock::now()));
  }
  return result;
}

}  // namespace

Measured measure(const PointSet& points, unsigned runs, const WantedManifolds& wanted) {
  Measured result;
  Times times;
  for (unsigned run = 0; run < runs; ++run) {
    result.last.reset();
    result.last = run_once(points, wanted, run, runs, times);
    times.all.push_back(times.critical.back() + (wanted.u2 ? times.u2.back() : 0) +
                        (wanted.s2 ? times.s2.back() : 0));
  }
  result.runs = runs;
  result.delaunay_seconds = median(times.delaunay);
  result.critical_seconds = median(times.critical);
  if (wanted.u2) result.u2_seconds = median(times.u2);
  if (wanted.s2) result.s2_seconds = median(times.s2);
  if (points.size() >= 4 && result.delaunay_seconds > 0) {
    result.ratios = {.critical = result.critical_seconds / result.delaunay_seconds,
                     .u2 = result.u2_seconds / result.delaunay_seconds,
                     .s2 = result.s2_seconds / result.delaunay_seconds,
                     .all = median(times.all) / result.delaunay_seconds};
  }
  return result;
}

}  // namespace flowcert::cli
