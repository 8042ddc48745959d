// Simplices are sorted by their balls. A face comes before each simplex that contains it. Columns are reduced from
// left to right.
#include "oracle/persistence.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

namespace oracle {

namespace {

struct EnclosingBall {
  Point center;
  Rational squared_radius;
};

std::vector<Places> facets_of(const Places& simplex) {
  std::vector<Places> facets;
  for (std::size_t i = 0; i < simplex.size() && simplex.size() > 1; ++i) {
    facets.push_back(simplex);
    facets.back().erase(facets.back().begin() + static_cast<std::ptrdiff_t>(i));
  }
  return facets;
}

// The smallest enclosing ball of each set of at most four samples. If the ball of a facet contains the point that the
// facet lacks, it is also the ball of the whole set. If no facet's ball does, every point is needed. Then the points
// are affinely independent and on the ball's sphere, and the centre is in the interior of their simplex.
std::map<Places, EnclosingBall> enclosing_balls(const PointSet& set) {
  std::map<Places, EnclosingBall> balls;
  const auto ball_of = [&](const Places& simplex) -> EnclosingBall {
    for (const Places& facet : facets_of(simplex)) {
      const EnclosingBall& ball = balls.at(facet);
      const bool encloses = std::all_of(simplex.begin(), simplex.end(), [&](std::size_t place) {
        return squared_distance(ball.center, set.points[place]) <= ball.squared_radius;
      });
      if (encloses) return ball;
    }
    const auto center = set.inner_circumcentre(simplex);
    if (!center) throw std::logic_error("points that hold a ball without its centre between them");
    return {*center, squared_distance(*center, set.points[simplex[0]])};
  };
  for (std::size_t size = 1; size <= 4; ++size) {  // facets first
    for_each_subset(set.points.size(), size, [&](const Places& simplex) {
      if (simplex.size() == size) balls.emplace(simplex, ball_of(simplex));
    });
  }
  return balls;
}

// A simplex, and the value at which it enters the filtration. They are ordered member by member, so that a simplex
// comes after its facets.
struct Cell {
  Rational value;
  std::size_t size = 0;
  Places simplex;

  friend bool operator<(const Cell& a, const Cell& b) {
    return std::tie(a.value, a.size, a.simplex) < std::tie(b.value, b.size, b.simplex);
  }
};

std::vector<Cell> filtration(const PointSet& set) {
  std::vector<Cell> cells;
  for (const auto& [simplex, ball] : enclosing_balls(set)) {
    cells.push_back({ball.squared_radius, simplex.size(), simplex});
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<Column> boundary_matrix(const std::vector<Cell>& cells) {
  std::map<Places, std::size_t> place_of;
  std::vector<Column> columns;
  for (const Cell& cell : cells) {
    place_of.emplace(cell.simplex, place_of.size());
    Column column;
    for (const Places& facet : facets_of(cell.simplex)) column.push_back(place_of.at(facet));
    std::sort(column.begin(), column.end());
    columns.push_back(column);
  }
  return columns;
}

// Columns are reduced from left to right. As long as an earlier column has the same last place, it is added. A column
// that is not zero in the end is kept by its last place. The cell there is a birth, and the column's cell its death.
struct Reduced {
  std::vector<std::size_t> births;              // the cells whose column has become zero
  std::map<std::size_t, std::size_t> death_of;  // of a birth, if it dies
};

Reduced reduced(std::vector<Column> columns) {
  Reduced result;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    while (!columns[k].empty() && result.death_of.contains(columns[k].back())) {
      columns[k] = sum_mod_2(columns[k], columns[result.death_of.at(columns[k].back())]);
    }
    if (columns[k].empty()) result.births.push_back(k);
    if (!columns[k].empty()) result.death_of[columns[k].back()] = k;
  }
  return result;
}

}  // namespace

Column sum_mod_2(const Column& a, const Column& b) {
  Column sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  return sum;
}

// sqrt(a) <= sqrt(b) + sqrt(c): the squares of both sides differ by a - b - c and twice the root of bc.
bool is_root_difference_up_to(const Rational& a, const Rational& b, const Rational& c) {
  const Rational rest = a - b - c;
  return rest <= 0 || rest * rest <= 4 * b * c;
}

bool operator<(const PersistencePair& a, const PersistencePair& b) {
  if (a.dimension != b.dimension) return a.dimension < b.dimension;
  if (a.birth != b.birth) return a.birth < b.birth;
  return a.death && (!b.death || *a.death < *b.death);
}

std::vector<PersistencePair> persistence_pairs(const PointSet& set) {
  const std::vector<Cell> cells = filtration(set);
  const Reduced matrix = reduced(boundary_matrix(cells));
  std::vector<PersistencePair> pairs;
  for (const std::size_t birth : matrix.births) {
    const int dimension = static_cast<int>(cells[birth].size) - 1;
    if (dimension == 3) continue;  // the sets of five samples, which would fill these, are not listed
    PersistencePair pair{dimension, cells[birth].value, std::nullopt};
    const auto death = matrix.death_of.find(birth);
    if (death != matrix.death_of.end()) pair.death = cells[death->second].value;
    if (pair.death != pair.birth) pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace oracle
