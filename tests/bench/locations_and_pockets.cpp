// How many positions a second one thread locates, and what pockets take, against CGAL's Delaunay triangulation in the
// same run: locations_and_pockets INPUT...
//
// Positions are drawn evenly from the convex hull, by drawing a Delaunay cell in proportion to its volume, and evenly
// from the bounding box, apart. Each figure is the median of five runs; one thread.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "flow/layer.h"
#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "flowcert/read_points.h"
#include "flowcert/stable_manifolds.h"
#include "geometry/vector3.h"
#include "morse/flow_locator.h"
#include "voronoi/voronoi_faces.h"

namespace {

using namespace flowcert;
using namespace flowcert::flow;

constexpr int kRuns = 5;
constexpr std::size_t kPositions = 100000;

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

std::vector<Point> drawn_from_hull(const FlowComplex& complex) {
  const auto& faces = complex.diagram();
  std::vector<double> volumes;
  for (CellIndex cell = 0; cell < faces.delaunay().finite_count; ++cell) {
    const auto& v = faces.delaunay().vertices(cell);
    const auto from = [&](std::size_t k) { return vector_between(faces.point(v[0]), faces.point(v[k])); };
    volumes.push_back(std::fabs(dot(from(1), cross(from(2), from(3)))));
  }
  std::mt19937_64 random(1);
  std::discrete_distribution<std::size_t> cell_of(volumes.begin(), volumes.end());
  std::exponential_distribution<double> weight;
  std::vector<Point> drawn;
  for (std::size_t k = 0; k < kPositions; ++k) {
    const auto& v = faces.delaunay().vertices(static_cast<CellIndex>(cell_of(random)));
    Point x{0, 0, 0};
    double sum = 0;
    for (const VertexIndex vertex : v) {
      const Point& p = faces.point(vertex);
      const double w = weight(random);
      x = {x.x + w * p.x, x.y + w * p.y, x.z + w * p.z};
      sum += w;
    }
    drawn.push_back({x.x / sum, x.y / sum, x.z / sum});
  }
  return drawn;
}

std::vector<Point> drawn_from_box(const PointSet& points) {
  Point low = points[0], high = low;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Point& p = points[k];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Point> drawn;
  for (std::size_t k = 0; k < kPositions; ++k) {
    const double a = part(random), b = part(random), c = part(random);
    drawn.push_back({low.x + a * (high.x - low.x), low.y + b * (high.y - low.y), low.z + c * (high.z - low.z)});
  }
  return drawn;
}

struct Rates {
  double set_up, hull, box;
  std::size_t followed;
};
Rates locate(const FlowComplex& complex) {
  std::optional<FlowLocator> locator;
  const double set_up = seconds_of([&] { locator.emplace(complex.diagram(), complex.stationary(), complex.limits()); });
  const auto rate = [&](const std::vector<Point>& positions) {
    std::vector<double> times;
    times.reserve(kRuns);
    for (int run = 0; run < kRuns; ++run) {
      times.push_back(seconds_of([&] {
        for (const Point& x : positions) (void)locator->locate(x);
      }));
    }
    return static_cast<double>(positions.size()) / median(times);
  };
  const double hull = rate(drawn_from_hull(complex)), box = rate(drawn_from_box(complex.points()));
  return {set_up, hull, box, locator->followed()};
}

struct PocketTimes {
  double delaunay, critical, limits, trees, pockets, volumes, s2, areas;
  std::size_t count, mouths;
};
PocketTimes pockets_of(const std::vector<Point>& rows) {
  const FlowComplex complex(rows);
  const auto made = [&](FlowComplexPart part) { return seconds_of([&] { complex.make(part); }); };
  PocketTimes times{};
  times.delaunay = made(FlowComplexPart::kTriangulation);
  times.critical = made(FlowComplexPart::kStationary);
  times.limits = made(FlowComplexPart::kLimits);
  times.trees = made(FlowComplexPart::kMergeTrees);
  std::optional<Pockets> pockets;
  times.pockets = seconds_of([&] { pockets.emplace(complex.merge_trees(), Rational(0)); });
  times.volumes = made(FlowComplexPart::kVolumes);
  times.s2 = made(FlowComplexPart::kStable);
  const auto& counts = complex.stationary().critical_counts();
  times.areas = seconds_of([&] {
    for (std::size_t k = 0; k < pockets->size(); ++k) {
      (void)complex.volumes().nearest_sum((*pockets)[k].cell);
      for (const std::uint32_t mouth : (*pockets)[k].mouths) {
        (void)surface_area(complex.points(), complex.stable(), mouth - counts[0] - counts[1]);
        ++times.mouths;
      }
    }
  });
  times.count = pockets->size();
  return times;
}

void print(const std::string& path) {
  const std::vector<Point> rows = read_points(path).rows;
  std::vector<PocketTimes> runs;
  runs.reserve(kRuns);
  for (int run = 0; run < kRuns; ++run) runs.push_back(pockets_of(rows));
  const auto of = [&](double PocketTimes::* part) {
    std::vector<double> ratios;
    ratios.reserve(runs.size());
    for (const PocketTimes& times : runs) ratios.push_back(times.*part / times.delaunay);
    return median(ratios);
  };
  std::vector<double> sums;
  sums.reserve(runs.size());
  for (const PocketTimes& t : runs) {
    sums.push_back((t.critical + t.limits + t.trees + t.pockets + t.volumes + t.s2 + t.areas) / t.delaunay);
  }
  const FlowComplex complex(rows);
  complex.make(FlowComplexPart::kLimits);
  const Rates rates = locate(complex);
  fmt::print("{:<18} {:>8} points, Delaunay {:.1f} ms\n", path.substr(path.rfind('/') + 1), complex.points().size(),
             1000 * runs.front().delaunay);
  fmt::print(
      "  pockets, x Delaunay: critical {:.2f}, limits {:.2f}, trees {:.2f}, pockets {:.2f}, volumes {:.2f}, S2 "
      "{:.2f}, areas {:.2f}; all {:.2f}; {} pockets, {} mouths\n",
      of(&PocketTimes::critical), of(&PocketTimes::limits), of(&PocketTimes::trees), of(&PocketTimes::pockets),
      of(&PocketTimes::volumes), of(&PocketTimes::s2), of(&PocketTimes::areas), median(sums), runs.front().count,
      runs.front().mouths);
  fmt::print("  locate: set-up {:.2f} s; {:.0f} a second from the hull, {:.0f} from the box; {} orbits followed\n",
             rates.set_up, rates.hull, rates.box, rates.followed);
}

}  // namespace

int main(int argc, char** argv) {
  for (int k = 1; k < argc; ++k) print(argv[k]);
}
