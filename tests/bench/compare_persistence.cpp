// Persistence pairs of large inputs against those that GUDHI computes of the alpha complex: exactly, since
// the filtration that GUDHI gets is of exact ranks.
//
// Usage: compare_persistence INPUT... Prints a line an input: pairs by dimension, ties broken, how many pairs
// only one side has, and the times of our computation (everything after the triangulation), of GUDHI's
// complex and pairs, and of the exact values. Exit status 1 if there is a difference, 2 for unusable input.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "flowcert/flow_complex.h"
#include "flowcert/read_points.h"
#include "tests/property/alpha_persistence.h"

namespace {

using namespace flowcert;

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Own {
  Own(const PointSet& points, std::uint64_t seed) {
    const FlowComplex complex(points, {.seed = seed});
    complex.make(FlowComplexPart::kTriangulation);
    const Clock::time_point start = Clock::now();
    pairs = property::exact_pairs(complex.persistence());
    seconds = since(start);
    ties = complex.chains().broken_ties() + complex.stable().statistics().broken_ties;
  }

  std::vector<property::ExactPair> pairs;
  std::size_t ties = 0;
  double seconds = 0;  // after the triangulation
};

// Whether the pairs are the same, with ties broken in two ways.
bool compare(const std::string& path) {
  const PointSet points(read_points(path).rows);
  const Own own(points, 0), at_random(points, 1);
  property::AlphaTimes times;
  const std::vector<property::ExactPair> gudhi = property::alpha_persistence(points.points(), &times);
  std::array<std::size_t, 3> counts{};
  for (const property::ExactPair& pair : own.pairs) ++counts.at(static_cast<std::size_t>(pair.dimension));
  const std::size_t different = property::count_differences(own.pairs, gudhi);
  const std::size_t by_seed = property::count_differences(at_random.pairs, gudhi);
  fmt::print("{:<20} {:>8} {:>8} {:>8} {:>8} {:>7} {:>10} {:>11} {:>9.2f} {:>9.2f} {:>9.2f}\n",
             std::filesystem::path(path).filename().string(), points.size(), counts[0], counts[1], counts[2], own.ties,
             different, by_seed, own.seconds, times.gudhi, times.values);
  if (different > 0) fmt::print("  {}\n", property::difference(own.pairs, gudhi));
  std::fflush(stdout);
  return different == 0 && by_seed == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: compare_persistence INPUT...\n");
    return 2;
  }
  fmt::print("{:<20} {:>8} {:>8} {:>8} {:>8} {:>7} {:>10} {:>11} {:>9} {:>9} {:>9}\n", "input", "points", "dim. 0",
             "dim. 1", "dim. 2", "ties", "different", "with seed 1", "own [s]", "GUDHI [s]", "exact [s]");
  try {
    bool agree = true;
    for (int k = 1; k < argc; ++k) agree = compare(argv[k]) && agree;
    return agree ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "compare_persistence: {}\n", error.what());
    return 2;
  }
}
