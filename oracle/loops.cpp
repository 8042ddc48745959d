// A reduced column is a cycle that is born with its latest edge and dies with its triangle. Cycles whose edges come up
// to a value are sums of columns whose latest edges do; they bound where the latest of these columns dies. So the columns
// of one birth and one death stand for the quotient of FC-CYC-02, and those of one death, up to a level, for that of
// FC-CYC-03: a loop's class is told by which of these its sum has.
#include "oracle/loops.h"

#include <algorithm>
#include <tuple>

namespace oracle {

namespace {

struct Valued {
  Rational value;
  Places places;

  friend bool operator<(const Valued& a, const Valued& b) {
    return std::tie(a.value, a.places) < std::tie(b.value, b.places);
  }
};

Rational edge_value(const PointSet& set, std::size_t a, std::size_t b) {
  return squared_distance(set.points[a], set.points[b]) / 4;
}

// The smallest ball of a triangle is its circle's if the centre is inside, and that of its longest edge if not.
Rational triangle_value(const PointSet& set, const Places& t) {
  if (const auto center = set.inner_circumcentre(t)) return squared_distance(*center, set.points[t[0]]);
  return std::max({edge_value(set, t[0], t[1]), edge_value(set, t[0], t[2]), edge_value(set, t[1], t[2])});
}

// Whether these columns are independent.
bool are_independent(std::vector<Column> columns) {
  std::map<std::size_t, Column> kept;
  for (Column& column : columns) {
    while (!column.empty() && kept.contains(column.back())) column = sum_mod_2(column, kept.at(column.back()));
    if (column.empty()) return false;
    kept[column.back()] = column;
  }
  return true;
}

}  // namespace

CechTunnels::CechTunnels(const PointSet& set) {
  std::vector<Valued> edges, triangles;
  for_each_subset(set.points.size(), 3, [&](const Places& simplex) {
    if (simplex.size() == 2) edges.push_back({edge_value(set, simplex[0], simplex[1]), simplex});
    if (simplex.size() == 3) triangles.push_back({triangle_value(set, simplex), simplex});
  });
  std::sort(edges.begin(), edges.end());
  std::sort(triangles.begin(), triangles.end());
  for (const Valued& edge : edges) {
    edge_place[{edge.places[0], edge.places[1]}] = values.size();
    values.push_back(edge.value);
  }
  for (const auto& [value, t] : triangles) {
    Column column = {edge_place.at({t[0], t[1]}), edge_place.at({t[0], t[2]}), edge_place.at({t[1], t[2]})};
    std::sort(column.begin(), column.end());
    while (!column.empty() && columns.contains(column.back())) {
      column = sum_mod_2(column, columns.at(column.back()).edges);
    }
    if (!column.empty()) columns[column.back()] = {value, column};
  }
}

std::optional<Column> CechTunnels::columns_of(const Loop& loop) const {
  Column rest, found;
  for (const Edge& edge : loop) rest.push_back(edge_place.at(edge));
  std::sort(rest.begin(), rest.end());
  while (!rest.empty()) {
    const auto column = columns.find(rest.back());
    if (column == columns.end()) return std::nullopt;
    found.push_back(column->first);
    rest = sum_mod_2(rest, column->second.edges);
  }
  return found;
}

std::string CechTunnels::fault(const std::vector<Loop>& loops, const std::optional<Rational>& birth,
                               const Rational& level, const Rational& death) const {
  const auto is_meant = [&](std::size_t place) {
    return columns.at(place).death == death && values[place] <= level && values[place] < death &&
           (!birth || values[place] == *birth);
  };
  std::vector<Column> classes;
  for (const Loop& loop : loops) {
    const auto sum = columns_of(loop);
    if (!sum) return "not-a-cycle";
    for (const Edge& edge : loop) {
      if (values[edge_place.at(edge)] > level) return "edge-too-long";
    }
    Column meant;
    bool dies_then = false;
    for (const std::size_t place : *sum) {
      if (columns.at(place).death > death) return "dies-later";
      dies_then = dies_then || columns.at(place).death == death;
      if (is_meant(place)) meant.push_back(place);
    }
    if (!dies_then) return "dies-earlier";
    if (meant.empty()) return "born-earlier";
    std::sort(meant.begin(), meant.end());
    classes.push_back(meant);
  }
  if (!are_independent(classes)) return "dependent";
  std::size_t pairs = 0;
  for (const auto& [place, column] : columns) pairs += is_meant(place) ? 1 : 0;
  return classes.size() < pairs ? "too-few" : "";
}

std::string CechTunnels::fault_at_birth(const std::vector<Loop>& loops, const Rational& birth,
                                        const Rational& death) const {
  return fault(loops, birth, birth, death);
}

std::string CechTunnels::fault_at_level(const std::vector<Loop>& loops, const Rational& level,
                                        const Rational& death) const {
  return fault(loops, std::nullopt, level, death);
}

}  // namespace oracle
