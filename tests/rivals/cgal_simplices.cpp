// CGAL's answers to the cases of `flowcert generate`: which Delaunay simplices are critical points.
//
//   cgal_simplices KIND            answers a stream of cases (src/cli/manual/cases.md)
//   cgal_simplices KIND IN OUT     answers one file of points, for `flowcert fuzz --against`
//
// KIND is gabriel-epick or gabriel-epeck (a simplex is claimed if CGAL's is_Gabriel says so and its circumcentre is
// inside of it), or alpha-epick or alpha-epeck (a simplex is claimed if its value in Alpha_shape_3's filtration is more
// than those of its facets and less than those of its cofacets).
// It is a small program as any user of CGAL may write it: nothing is done about ties and rounding. CGAL has both in
// three dimensions alone, so flat inputs are refused.
// KIND cells-epick and cells-epeck: the cells of the Delaunay triangulation, a line of ids each, for triangulations.py.
// Flat inputs have triangles or edges. Each case is answered by a process of its own, so that one that crashes is one
// refusal.
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/tuple.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Row = std::array<double, 3>;
using Ids = std::vector<std::size_t>;
constexpr unsigned kMostSeconds = 3;

struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string claim_line(Ids ids, const std::string& squared_distance = "") {
  std::sort(ids.begin(), ids.end());
  std::string line = std::to_string(ids.size() - 1) + ",,,," + squared_distance;
  for (const std::size_t id : ids) line += "," + std::to_string(id);
  return line + "\n";
}

// A value beyond the doubles is not claimed.
std::string number_text(double value) {
  if (!std::isfinite(value)) return "";
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

template <typename Triangulation>
void insert_rows(Triangulation& triangulation, const std::vector<Row>& rows) {
  std::vector<std::pair<typename Triangulation::Point, std::size_t>> points;
  points.reserve(rows.size());
  for (const Row& row : rows) points.emplace_back(typename Triangulation::Point(row[0], row[1], row[2]), points.size());
  triangulation.insert(points.begin(), points.end());
}

template <typename Triangulation>
void refuse_flat(const Triangulation& triangulation) {
  if (triangulation.dimension() < 3) throw Refusal("flat: CGAL has this in three dimensions alone");
}

template <typename Facet>
auto corners_of(const Facet& facet) {
  std::vector<std::decay_t<decltype(facet.first->vertex(0))>> corners;
  for (int k = 0; k < 4; ++k) {
    if (k != facet.second) corners.push_back(facet.first->vertex(k));
  }
  return corners;
}

template <typename Kernel>
struct Plain {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
};

// ---- Cells ----

template <typename Kernel>
std::string cell_lines(const std::vector<Row>& rows) {
  typename Plain<Kernel>::Delaunay delaunay;
  insert_rows(delaunay, rows);
  std::ostringstream lines;
  const auto add = [&](const auto cell) {
    for (int k = 0; k <= delaunay.dimension(); ++k) lines << (k > 0 ? " " : "") << cell->vertex(k)->info();
    lines << "\n";
  };
  // A facet of dimension 2 and an edge of dimension 1 have all vertices of the cell they are given with.
  if (delaunay.dimension() == 3) {
    for (const auto cell : delaunay.finite_cell_handles()) add(cell);
  } else if (delaunay.dimension() == 2) {
    for (const auto& facet : delaunay.finite_facets()) add(facet.first);
  } else if (delaunay.dimension() == 1) {
    for (const auto& edge : delaunay.finite_edges()) add(edge.first);
  }
  return lines.str();
}

// ---- Gabriel tests ----

template <typename Kernel>
bool is_acute(const typename Kernel::Point_3& p, const typename Kernel::Point_3& q, const typename Kernel::Point_3& r) {
  return CGAL::angle(p, q, r) == CGAL::ACUTE && CGAL::angle(q, r, p) == CGAL::ACUTE &&
         CGAL::angle(r, p, q) == CGAL::ACUTE;
}

template <typename Kernel>
std::string gabriel_claims(const std::vector<Row>& rows) {
  typename Plain<Kernel>::Delaunay delaunay;
  insert_rows(delaunay, rows);
  refuse_flat(delaunay);
  std::string claims;
  for (const auto vertex : delaunay.finite_vertex_handles()) claims += claim_line({vertex->info()});
  for (const auto& edge : delaunay.finite_edges()) {
    const auto& [cell, i, j] = edge;
    if (delaunay.is_Gabriel(edge)) claims += claim_line({cell->vertex(i)->info(), cell->vertex(j)->info()});
  }
  for (const auto& facet : delaunay.finite_facets()) {
    const auto corners = corners_of(facet);
    if (!is_acute<Kernel>(corners[0]->point(), corners[1]->point(), corners[2]->point())) continue;
    if (delaunay.is_Gabriel(facet)) claims += claim_line({corners[0]->info(), corners[1]->info(), corners[2]->info()});
  }
  for (const auto cell : delaunay.finite_cell_handles()) {
    if (delaunay.tetrahedron(cell).has_on_bounded_side(delaunay.dual(cell))) {
      claims += claim_line(
          {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()});
    }
  }
  return claims;
}

// ---- The filtration of alpha shapes ----

// The corners of what the filtration lists: a cell, a facet, an edge or a vertex.
template <typename Shape>
Ids ids_of(const CGAL::Object& object) {
  Ids ids;
  if (const auto* const cell = CGAL::object_cast<typename Shape::Cell_handle>(&object)) {
    for (int k = 0; k < 4; ++k) ids.push_back((*cell)->vertex(k)->info());
  } else if (const auto* const facet = CGAL::object_cast<typename Shape::Facet>(&object)) {
    for (int k = 0; k < 4; ++k) {
      if (k != facet->second) ids.push_back(facet->first->vertex(k)->info());
    }
  } else if (const auto* const edge = CGAL::object_cast<typename Shape::Edge>(&object)) {
    ids = {edge->first->vertex(edge->second)->info(), edge->first->vertex(edge->third)->info()};
  } else if (const auto* const vertex = CGAL::object_cast<typename Shape::Vertex_handle>(&object)) {
    ids = {(*vertex)->info()};
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

template <typename Kernel>
std::string alpha_claims(const std::vector<Row>& rows) {
  using Number = typename Kernel::FT;
  using Vertex =
      CGAL::Alpha_shape_vertex_base_3<Kernel, CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>>;
  using Cell = CGAL::Alpha_shape_cell_base_3<Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
  using Shape = CGAL::Alpha_shape_3<Delaunay>;
  Delaunay delaunay;
  insert_rows(delaunay, rows);
  refuse_flat(delaunay);
  const Shape shape(delaunay, 0, Shape::GENERAL);
  std::vector<CGAL::Object> objects;
  std::vector<Number> numbers;
  shape.filtration_with_alpha_values(
      CGAL::dispatch_output<CGAL::Object, Number>(std::back_inserter(objects), std::back_inserter(numbers)));
  std::map<Ids, Number> value_of;
  for (std::size_t k = 0; k < objects.size(); ++k) value_of.emplace(ids_of<Shape>(objects[k]), numbers.at(k));
  std::map<Ids, bool> is_paired;
  for (const auto& [ids, value] : value_of) {
    for (std::size_t left_out = 0; ids.size() > 1 && left_out < ids.size(); ++left_out) {
      Ids facet = ids;
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(left_out));
      if (value_of.at(facet) >= value) is_paired[ids] = is_paired[facet] = true;
    }
  }
  std::string claims;
  for (const auto& [ids, value] : value_of) {
    if (!is_paired[ids]) claims += claim_line(ids, number_text(CGAL::to_double(CGAL::exact(value))));
  }
  return claims;
}

// ---- Cases ----

std::string claims_of(const std::string& kind, const std::vector<Row>& rows) {
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  if (kind == "gabriel-epick") return gabriel_claims<Epick>(rows);
  if (kind == "gabriel-epeck") return gabriel_claims<Epeck>(rows);
  if (kind == "alpha-epick") return alpha_claims<Epick>(rows);
  if (kind == "alpha-epeck") return alpha_claims<Epeck>(rows);
  if (kind == "cells-epick") return cell_lines<Epick>(rows);
  if (kind == "cells-epeck") return cell_lines<Epeck>(rows);
  throw std::invalid_argument("no kind: " + kind);
}

Row row_of(const std::string& line) {
  Row row{};
  const char* text = line.c_str();
  for (double& coordinate : row) {
    char* end = nullptr;
    coordinate = std::strtod(text, &end);
    text = end;
  }
  return row;
}

// A refusal's reason is one line.
std::string answer_text(const std::string& kind, const std::string& id, const std::vector<Row>& rows) {
  try {
    return "answer " + id + "\n" + claims_of(kind, rows) + "end\n";
  } catch (const std::exception& error) {
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    return "refused " + id + " " + reason + "\n";
  }
}

void answer_case(const std::string& kind, const std::string& id, const std::vector<Row>& rows) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(kMostSeconds);
    std::cout << answer_text(kind, id, rows) << std::flush;
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFEXITED(status)) std::cout << "refused " << id << " crashed: signal " << WTERMSIG(status) << std::endl;
}

void answer_stream(const std::string& kind) {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word, id;
    std::size_t count = 0;
    if (!(words >> word >> id >> count) || word != "case") continue;
    std::vector<Row> rows;
    while (count-- > 0 && std::getline(std::cin, line)) rows.push_back(row_of(line));
    answer_case(kind, id, rows);
  }
}

int answer_file(const std::string& kind, const char* in, const char* out) {
  std::ifstream points(in);
  std::vector<Row> rows;
  for (std::string line; std::getline(points, line);) {
    if (!line.empty() && line.front() != '#') rows.push_back(row_of(line));
  }
  try {
    std::ofstream(out) << "# by CGAL\n" << claims_of(kind, rows);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) return 2;
  if (argc == 4) return answer_file(argv[1], argv[2], argv[3]);
  answer_stream(argv[1]);
  return 0;
}
