// The faces between cells, which pages draw (FC-STAB-05, FC-VOL-01), on all families.
//
// Guarantees: the triangles around each cell are closed, as counted by their directed edges, and no two of them have
// the same corners. By the divergence theorem they enclose the cell's exact volume, but for the rounding of their
// corners, which is bounded. Faces that are asked for alone are those of all cells.
#include "io/cell_faces.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/subject.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::cell_faces_test {
namespace {

using io::CellFace;
using io::CellFaces;
using Triangle = std::array<std::uint32_t, 3>;

constexpr int kInputsPerFamily = 300;

struct Totals {
  std::size_t inputs = 0, cells = 0, regular = 0, faces = 0, triangles = 0;
};

// Counterclockwise, seen from outside of the cell.
std::vector<Triangle> around(const CellFaces& all, std::uint32_t cell) {
  std::vector<Triangle> triangles;
  for (const CellFace& face : all.faces) {
    for (const Triangle& t : face.triangles) {
      if (face.limits[0] == cell) triangles.push_back(t);
      if (face.limits[1] == cell) triangles.push_back({t[1], t[0], t[2]});
    }
  }
  return triangles;
}

bool is_closed(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passed;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++passed[{t[k], t[(k + 1) % 3]}];
  }
  return std::ranges::all_of(passed, [&](const auto& edge) {
    const auto back = passed.find({edge.first.second, edge.first.first});
    return edge.first.first != edge.first.second && back != passed.end() && back->second == edge.second;
  });
}

bool has_twice(const std::vector<Triangle>& triangles) {
  std::set<Triangle> sorted;
  for (Triangle t : triangles) {
    std::ranges::sort(t);
    if (!sorted.insert(t).second) return true;
  }
  return false;
}

// In a unit in which no coordinate is greater than 1, so that each triangle has an error of less than 4 roundings: six
// products of three numbers, over 6, with an error of one half rounding in each.
bool has_volume(const std::vector<Triangle>& triangles, const std::vector<Point>& corners, const Rational& volume) {
  double largest = 0;
  for (const Point& p : corners) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const auto at = [&](std::uint32_t corner) {
    const Point& p = corners[corner];
    return std::array<long double, 3>{(long double){p.x} / largest, (long double){p.y} / largest,
                                      (long double){p.z} / largest};
  };
  long double six = 0;
  for (const Triangle& t : triangles) {
    const auto a = at(t[0]), b = at(t[1]), c = at(t[2]);
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  const Rational unit = Rational(largest) * Rational(largest) * Rational(largest);
  const auto expected = nearest_double(Rational(volume / unit));
  return std::abs(six / 6 - static_cast<long double>(*expected)) <=
         static_cast<long double>(triangles.size()) * 0x1p-51L;
}

std::size_t triangle_count(const CellFaces& all) {
  std::size_t count = 0;
  for (const CellFace& face : all.faces) count += face.triangles.size();
  return count;
}

void require_right_faces(const Subject& subject, Totals& totals) {
  const FlowComplex& complex = subject.complex;
  std::vector<bool> is_cell(complex.stationary().size());
  for (std::size_t i = 0; i < is_cell.size(); ++i) is_cell[i] = complex.volumes().nearest(i) > 0;
  const CellFaces all = io::cell_faces(complex, is_cell);
  const auto require = [&](bool holds, const std::string& complaint) {
    require_none(subject.input, holds ? "" : complaint, "");
  };
  for (std::uint32_t cell = 0; cell < is_cell.size(); ++cell) {
    if (!is_cell[cell]) continue;
    const std::vector<Triangle> triangles = around(all, cell);
    require(is_closed(triangles), "faces that are not closed");
    require(!has_twice(triangles), "a triangle twice");
    require(has_volume(triangles, all.corners, complex.volumes().exact(cell)), "faces around another volume");
    ++totals.cells;
    totals.regular += complex.stationary().index(cell).is_critical() ? 0 : 1;
    if (totals.cells % 5 != 0) continue;
    std::vector<bool> is_wanted(is_cell.size());
    is_wanted[cell] = true;
    require(triangle_count(io::cell_faces(complex, is_wanted)) == triangles.size(), "a cell alone has other faces");
  }
  totals.faces += all.faces.size();
  totals.triangles += triangle_count(all);
  ++totals.inputs;
}

TEST(CellFaces, AreClosedAroundTheVolumesOfCells) {
  CITES("FC-STAB-05", "FC-VOL-01");
  Totals totals;
  bool agreed = true;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds("faces of cells, " + family.name, parameters_of_run(kInputsPerFamily),
                          [&] {
                            const fuzz::Input input = *generator;
                            require_right_faces(Subject(input), totals);
                          }) &&
             agreed;
  }
  std::printf("%zu inputs, %zu cells, %zu of them of regular points, %zu faces of %zu triangles\n", totals.inputs,
              totals.cells, totals.regular, totals.faces, totals.triangles);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(totals.inputs, 10000U);
    EXPECT_GE(totals.cells, 4500U);
    EXPECT_GE(totals.regular, 1500U);
  }
}

}  // namespace
}  // namespace flowcert::property::cell_faces_test
