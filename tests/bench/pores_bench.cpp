// What pores take, against one 3-dimensional regular triangulation of CGAL's in the same run: pores_bench INPUT...
//
// The rows of an XYZ file get the radii 1.70, 1.55, 1.52 and 1.20 in turn. Each round has all three: the triangulation
// of the atoms with the weights r^2, all of Pores at the depth 0.1, and the cavities of the probe 1.4. Times are those
// of the processor, in one thread; what is printed are medians of the rounds' ratios. What makes a
// BallSet of the atoms is in both.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/ball_cavities.h"
#include "flowcert/pores.h"
#include "flowcert/read_balls.h"

namespace {

using namespace flowcert;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr int kRounds = 9;
constexpr std::array kRadii = {"1.70", "1.55", "1.52", "1.20"};

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
double seconds_of(const std::function<void()>& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}
double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

std::vector<Ball> balls_of(const std::string& path) {
  std::ifstream file(path);
  std::string text;
  std::size_t row = 0;
  for (std::string line; std::getline(file, line); ++row) text += fmt::format("{} {}\n", line, kRadii[row % 4]);
  return read_balls_from(text, path, {}, AtomRadii("column:4")).balls;
}

void print(const std::string& path) {
  const std::vector<Ball> atoms = balls_of(path);
  std::vector<Kernel::Weighted_point_3> sites;
  for (const Ball& atom : atoms) {
    const auto& [x, y, z] = atom.center;
    const double r = nearest_or_infinity(atom.radius);
    sites.emplace_back(Kernel::Point_3(nearest_or_infinity(x), nearest_or_infinity(y), nearest_or_infinity(z)), r * r);
  }
  std::vector<double> one, all, probe;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Ball> copies[] = {atoms, atoms};
    one.push_back(seconds_of([&] { CGAL::Regular_triangulation_3<Kernel>(sites.begin(), sites.end()); }));
    const double pores = seconds_of([&] {
      const BallSet balls(std::move(copies[0]));
      Pores(balls, Rational(1) / 10);
    });
    const double cavities = seconds_of([&] {
      const BallSet balls(std::move(copies[1]));
      (void)ball_cavities(balls, Rational(7) / 5);
    });
    all.push_back(pores / one.back());
    probe.push_back(cavities / one.back());
  }
  fmt::print("{:<18} {:>8} atoms, triangulation {:.1f} ms; pores x {:.1f}, one probe x {:.2f}\n",
             path.substr(path.rfind('/') + 1), atoms.size(), 1000 * median(one), median(all), median(probe));
}

}  // namespace

int main(int argc, char** argv) {
  for (int k = 1; k < argc; ++k) print(argv[k]);
}
