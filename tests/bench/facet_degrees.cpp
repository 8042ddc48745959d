// How many signs a query of a Voronoi facet takes, by the facet's degree: binary search against linear scan
// (paper, Proposition 1).
//
// The facets are those of fuzz::high_degree_facet, exactly cocircular and perturbed. Queries start where
// orbits do: on an obtuse Voronoi edge (E-F), at a Voronoi vertex between two of them (V-F), inside the facet
// (F-F). Both searches get the same starts and must reach the same face. Prints a line for each degree, and
// the least-squares fits of signs = a + b log2 n and of log(signs) = c + d log(n).
//
// usage: facet_degrees [LARGEST-DEGREE [cascade|lazy|exact]]
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string_view>
#include <vector>

#include "flow/flow_operator.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/input_points.h"

namespace {

using namespace flowcert;
using namespace flowcert::flow;

constexpr std::size_t kQueries = 50;

struct Mean {
  double signs = 0;
  double microseconds = 0;
  std::size_t most = 0;
};

std::size_t signs_asked(const FlowOperator& flow) {
  std::size_t asked = 0;
  for (const FlowPrimitive primitive :
       {FlowPrimitive::kSideOfRay, FlowPrimitive::kRayAtInfinity, FlowPrimitive::kAroundStart}) {
    asked += flow.tally()[primitive].calls;
  }
  return asked;
}

Mean measure(FlowOperator& flow, const std::vector<Location>& starts, std::vector<Place>& reached) {
  Mean mean;
  // The first round constructs the facet's vertices.
  for (const Location& start : starts) reached.push_back(flow.step(start).end.place);
  for (const Location& start : starts) {
    const std::size_t before = signs_asked(flow);
    const auto then = std::chrono::steady_clock::now();
    (void)flow.step(start);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - then;
    const std::size_t signs = signs_asked(flow) - before;
    mean.signs += static_cast<double>(signs) / static_cast<double>(starts.size());
    mean.microseconds += time.count() / static_cast<double>(starts.size());
    mean.most = std::max(mean.most, signs);
  }
  return mean;
}

// A facet of one input, with the two flows that search it.
struct Subject {
  Subject(const fuzz::Input& input, ConstructionKernel kernel)
      : points(property::point_set_of(input)), diagram(Delaunay(points)), faces(diagram) {
    VertexIndex v[2] = {0, 0};
    for (VertexIndex k = 0; k < faces.diagram().delaunay().ordinals.size(); ++k) {
      if (faces.diagram().delaunay().ordinals[k] < 2) v[faces.diagram().delaunay().ordinals[k]] = k;
    }
    name = {std::min(v[0], v[1]), std::max(v[0], v[1])};
    ring = faces.ring(name);
    for (const FacetSearch search : {FacetSearch::kBinary, FacetSearch::kLinear}) {
      flows.push_back(make_flow_operator(faces, {kernel, search}));
    }
  }

  RationalPoint vertex(std::size_t element) {
    return flows[0]->exact({Place::at_vertex(ring.pieces[element].vertex), kNoPoint});
  }

  PointSet points;
  VoronoiDiagram diagram;
  VoronoiFaces faces;
  FacetName name;
  FacetRing ring;
  std::vector<std::unique_ptr<FlowOperator>> flows;
};

RationalPoint between(const RationalPoint& a, const RationalPoint& b, int part, int whole) {
  RationalPoint x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = a[k] + (b[k] - a[k]) * part / whole;
  return x;
}

bool enters_here(Subject& subject, std::size_t piece) {
  const PolygonDriver driver = subject.faces.diagram().driver(subject.ring.pieces[piece].polygon());
  return driver.shape == Sign::kNegative && driver.side == subject.name;
}

// A start of one kind, as a point that can be added to either flow.
struct Start {
  Place place;
  RationalPoint x;
};

std::vector<Start> draw(Subject& subject, char kind, std::mt19937& random) {
  const std::size_t n = subject.ring.size();
  std::vector<std::size_t> entries;  // pieces through which the flow enters
  for (std::size_t k = 0; k < n; ++k) {
    if (enters_here(subject, k)) entries.push_back(k);
  }
  std::vector<Start> starts;
  for (std::size_t tries = 0; starts.size() < kQueries && tries < 20 * kQueries; ++tries) {
    const std::size_t k = entries[random() % entries.size()];
    const auto part = static_cast<int>(random() % 99) + 1;
    const RationalPoint a = subject.vertex(k);
    if (kind == 'V') {
      const VertexFlow flow = vertex_flow(subject.diagram, subject.ring.pieces[k].vertex);
      if (flow.way == VertexFlow::Way::kAcrossFacet && flow.facet == subject.name) {
        starts.push_back({Place::at_vertex(subject.ring.pieces[k].vertex), a});
      }
    } else if (kind == 'E') {
      starts.push_back(
          {Place::on_edge(subject.ring.pieces[k].polygon()), between(a, subject.vertex((k + 1) % n), part, 100)});
    } else {
      // The start lies between two vertices that are not neighbours.
      const RationalPoint b = subject.vertex((k + 2 + random() % (n - 3)) % n);
      starts.push_back({Place::on_facet(subject.name), between(a, b, part, 100)});
    }
  }
  return starts;
}

// Least squares of y against x: intercept, slope and the share of the variance that they explain.
struct Fit {
  double intercept = 0, slope = 0, r2 = 0;
};
Fit fit(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sx += x[k], sy += y[k], sxx += x[k] * x[k], sxy += x[k] * y[k], syy += y[k] * y[k];
  }
  Fit line;
  line.slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  line.intercept = (sy - line.slope * sx) / n;
  const double spread = syy - sy * sy / n;
  line.r2 = spread == 0 ? 1 : line.slope * (sxy - sx * sy / n) / spread;
  return line;
}

// What one kind of start took, over all degrees.
struct Series {
  std::vector<double> log_degree, binary, log_linear;
};

bool run(std::size_t degree, bool perturbed, char kind, Subject& subject, Series& series) {
  std::mt19937 random(static_cast<unsigned>(degree));
  const std::vector<Start> starts = draw(subject, kind, random);
  if (starts.empty()) return true;
  std::vector<Mean> means;
  std::vector<std::vector<Place>> reached(2);
  for (std::size_t m = 0; m < 2; ++m) {
    std::vector<Location> locations;
    locations.reserve(starts.size());
    for (const Start& start : starts) {
      locations.push_back({start.place, kind == 'V' ? kNoPoint : subject.flows[m]->add(start.x)});
    }
    means.push_back(measure(*subject.flows[m], locations, reached[m]));
  }
  const double log_degree = std::log2(static_cast<double>(degree));
  fmt::print("{:>8} {:>11} {:>6} {:>8} {:>8.2f} {:>9.2f} {:>5} {:>11.1f} {:>13.1f} {:>13.1f}\n", degree,
             perturbed ? "perturbed" : "cocircular", fmt::format("{}-F", kind), starts.size(), log_degree,
             means[0].signs, means[0].most, means[1].signs, means[0].microseconds, means[1].microseconds);
  series.log_degree.push_back(log_degree);
  series.binary.push_back(means[0].signs);
  series.log_linear.push_back(std::log2(means[1].signs));
  return reached[0] == reached[1];
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t largest = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100000;
  const std::string_view name = argc > 2 ? argv[2] : "cascade";
  const std::map<std::string_view, ConstructionKernel> kernels = {{"cascade", ConstructionKernel::kCascade},
                                                                  {"lazy", ConstructionKernel::kLazy},
                                                                  {"exact", ConstructionKernel::kExact}};
  if (!kernels.contains(name)) {
    fmt::print(stderr, "no kernel '{}'\n", name);
    return 2;
  }
  const ConstructionKernel kernel = kernels.at(name);
  fmt::print("{:>8} {:>11} {:>6} {:>8} {:>8} {:>9} {:>5} {:>11} {:>13} {:>13}\n", "degree", "neighbours", "start",
             "queries", "log2 n", "binary", "most", "linear", "binary [us]", "linear [us]");
  bool agree = true;
  std::vector<Series> all(3);
  const std::string kinds = "EVF";
  for (const std::size_t degree : {10U, 30U, 100U, 300U, 1000U, 3000U, 10000U, 30000U, 100000U}) {
    if (degree > largest) break;
    for (const bool perturbed : {false, true}) {
      Subject subject(fuzz::high_degree_facet(degree, perturbed, 1), kernel);
      if (subject.ring.size() != degree) return 1;
      for (std::size_t k = 0; k < kinds.size(); ++k) {
        agree = run(degree, perturbed, kinds[k], subject, all[k]) && agree;
      }
    }
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const Fit binary = fit(all[k].log_degree, all[k].binary);
    const Fit linear = fit(all[k].log_degree, all[k].log_linear);
    fmt::print(
        "{}-F: binary search, signs = {:.2f} + {:.2f} log2 n (R^2 {:.4f}); linear scan, signs ~ n^{:.2f} "
        "(R^2 {:.4f})\n",
        kinds[k], binary.intercept, binary.slope, binary.r2, linear.slope, linear.r2);
  }
  fmt::print("{}\n", agree ? "both searches reached the same faces" : "THE SEARCHES DISAGREE");
  return agree ? 0 : 1;
}
