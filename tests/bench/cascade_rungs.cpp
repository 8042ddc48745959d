// Which precision decides the signs of orbits, and what is gained by those between doubles and exact integers: the
// paper's question whether "additional steps of increasing precision" are worth it (its conclusion).
//
// The unstable manifolds of all critical points of index 2 are flowed by the cascade kernel with some of its rungs, and
// with sharing, as `flowcert compute --manifolds u2` does. Prints one line: points, signs asked, those decided by
// doubles, doubled doubles, 256 bits and integers, seconds of U2 and of the triangulation, medians of up to five runs.
//
// usage: cascade_rungs none|doubled|extended|both INPUT
// INPUT is a file of points, grid:FILE (its coordinates rounded to 1/512 of the file's extent), half-sphere:POINTS
// (random points, rounded to doubles), noisy:POINTS (the same with 0.1 % noise in the radius), half-shell:POINTS (a
// paraboloid, rounded to integers), cascade:POINTS, or capsule:TEETH.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "flow/kernel_flow_operator.h"
#include "flow/kernels/cascade_kernel.h"
#include "flow/kernels/cascade_moving_point.h"
#include "flow/successor_forest.h"
#include "flowcert/read_points.h"
#include "flowcert/stationary_points.h"
#include "fuzz/inputs/capsule_sample.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/input_points.h"
#include "morse/along_the_curve.h"
#include "morse/record_finder.h"

namespace {

using namespace flowcert;
using namespace flowcert::morse;

// ---- Inputs ----

using property::rows_of;

// Uniform in [-1, 1], from 53 random bits.
double uniform(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1; }

std::vector<Point> half_sphere(std::size_t count, double noise) {
  std::mt19937_64 random(1);
  std::vector<Point> rows;
  while (rows.size() < count) {
    const double x = uniform(random), y = uniform(random), z = std::abs(uniform(random));
    const double norm = std::sqrt(x * x + y * y + z * z);
    if (norm > 1 || norm < 0.1) continue;
    const double radius = 1 + noise * uniform(random);
    rows.push_back({radius * x / norm, radius * y / norm, radius * z / norm});
  }
  return rows;
}

std::vector<Point> rounded_to_grid(std::vector<Point> rows) {
  double least = rows.at(0).x, most = least;
  for (const Point& p : rows) {
    least = std::min({least, p.x, p.y, p.z});
    most = std::max({most, p.x, p.y, p.z});
  }
  const double step = (most - least) / 512;
  for (Point& p : rows) p = {std::round(p.x / step), std::round(p.y / step), std::round(p.z / step)};
  return rows;
}

std::vector<Point> input_rows(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string kind = colon == std::string::npos ? "" : name.substr(0, colon);
  const std::string rest = name.substr(colon + 1);
  if (kind == "half-sphere") return half_sphere(std::stoul(rest), 0);
  if (kind == "noisy") return half_sphere(std::stoul(rest), 1e-3);
  if (kind == "half-shell") return rows_of(fuzz::half_shell(std::stoul(rest), 1));
  if (kind == "cascade") return rows_of(fuzz::long_cascade(std::stoul(rest), 1));
  if (kind == "capsule") return rows_of(fuzz::capsule_sample(std::stoul(rest)));
  if (kind == "grid") return rounded_to_grid(read_points(rest).rows);
  return read_points(name).rows;
}

// ---- The kernel ----

MiddleRungs chosen_rungs;
std::array<std::uint64_t, 4> decided{};  // by KernelRung; those of doubles are counted by the tally

// The operator makes its kernel itself, and keeps it to itself.
class CountedKernel : public CascadeKernel {
 public:
  explicit CountedKernel(KernelTally& tally) : CascadeKernel(tally, chosen_rungs) {}
  ~CountedKernel() {
    for (const KernelRung rung : {KernelRung::kDoubled, KernelRung::kExtended, KernelRung::kExact}) {
      decided[static_cast<std::size_t>(rung)] += decided_beyond_doubles(rung);
    }
  }
  CountedKernel(const CountedKernel&) = delete;
  CountedKernel& operator=(const CountedKernel&) = delete;
};

// ---- U2 ----

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

constexpr std::array kSigns = {FlowPrimitive::kSideOfRay, FlowPrimitive::kRayAtInfinity, FlowPrimitive::kAroundStart,
                               FlowPrimitive::kAlongEdge, FlowPrimitive::kNearerExit};

FilterCount signs_of_all_orbits(const VoronoiDiagram& diagram, const StationaryPoints& stationary) {
  VoronoiFaces faces(diagram);
  KernelFlowOperator<CountedKernel> flow(faces, FacetSearch::kBinary);
  SuccessorForest forest(faces.diagram(), true);
  const auto record_of = [](std::uint32_t record) { return record; };
  for (const std::uint32_t record : along_the_curve(stationary, stationary.size(), record_of)) {
    if (stationary.index(record) != StationaryIndex{2, 2}) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      const Location start = flow.end_of_edge(edge_of_record(stationary, record), side);
      if (start.place.kind == Place::Kind::kVertex) (void)forest.visit(start.place.vertex, flow);
    }
  }
  FilterCount signs;
  for (const FlowPrimitive primitive : kSigns) signs += flow.tally()[primitive];
  return signs;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Up to five times, until some seconds are over.
void run(const std::string& name) {
  constexpr double kLongEnough = 10;
  const PointSet points(input_rows(name));
  std::vector<double> triangulation, u2;
  FilterCount signs;
  const auto begin = std::chrono::steady_clock::now();
  do {
    decided = {};
    const auto before = std::chrono::steady_clock::now();
    const Delaunay delaunay(points);
    triangulation.push_back(seconds_since(before));
    const VoronoiDiagram diagram(delaunay);
    const StationaryPoints stationary = stationary_points(diagram);
    const auto start = std::chrono::steady_clock::now();
    signs = signs_of_all_orbits(diagram, stationary);
    u2.push_back(seconds_since(start));
  } while (u2.size() < 5 && seconds_since(begin) < kLongEnough);
  fmt::print("{} {} {} {} {} {} {:.5f} {:.5f}\n", points.size(), signs.calls, signs.calls - signs.failures, decided[1],
             decided[2], decided[3], median(u2), median(triangulation));
}

}  // namespace

int main(int argc, char** argv) {
  // Recipes of any length are asked for 256 bits here. As it is used, the kernel spares the short ones that.
  const std::map<std::string, MiddleRungs> choices = {
      {"none", {.doubled = false, .extended = false}},
      {"doubled", {.doubled = true, .extended = false}},
      {"extended", {.doubled = false, .extended = true, .extended_from = 0}},
      {"both", {.doubled = true, .extended = true, .extended_from = 0}}};
  const auto chosen = argc == 3 ? choices.find(argv[1]) : choices.end();
  if (chosen == choices.end()) {
    fmt::print(stderr, "usage: cascade_rungs none|doubled|extended|both INPUT\n");
    return 2;
  }
  chosen_rungs = chosen->second;
  try {
    run(argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "cascade_rungs: {}\n", error.what());
    return 2;
  }
}
