#include "tests/property/alpha_persistence.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "oracle/exact_geometry.h"
#include "tests/property/gudhi_alpha.h"

namespace flowcert::property {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

class AlphaValues {
 public:
  AlphaValues(std::span<const Point> points, const std::vector<GudhiSimplex>& simplices)
      : simplices_(simplices), cofacets_(simplices.size()), values_(simplices.size()) {
    for (const Point& p : points) points_.push_back(oracle::exact({p.x, p.y, p.z}));
    for (std::size_t k = 0; k < simplices.size(); ++k) {
      for (const std::size_t facet : simplices[k].facets) cofacets_[facet].push_back(k);
    }
    // Faces are listed before what they are faces of, so cofaces get their values first.
    for (std::size_t k = simplices.size(); k-- > 0;) values_[k] = value(k);
  }

  std::vector<Rational> take() { return std::move(values_); }

 private:
  Rational value(std::size_t k) const {
    const std::vector<std::size_t>& vertices = simplices_[k].vertices;
    if (vertices.size() == 1) return 0;
    const auto sphere = oracle::circumcentre(oracle::select(points_, vertices));
    if (!sphere) throw std::runtime_error("GUDHI's complex has a flat simplex");
    const Rational own = oracle::squared_distance(sphere->center, points_[vertices[0]]);
    std::optional<Rational> least;
    bool is_empty = true;
    for (const std::size_t cofacet : cofacets_[k]) {
      if (!least || values_[cofacet] < *least) least = values_[cofacet];
      is_empty = is_empty && oracle::squared_distance(sphere->center, points_[apex(cofacet, k)]) >= own;
    }
    return is_empty ? own : *least;
  }

  // The vertex of a cofacet that is not one of the simplex.
  std::size_t apex(std::size_t cofacet, std::size_t k) const {
    for (const std::size_t vertex : simplices_[cofacet].vertices) {
      if (!std::ranges::binary_search(simplices_[k].vertices, vertex)) return vertex;
    }
    throw std::logic_error("a cofacet without a further vertex");
  }

  std::vector<oracle::Point> points_;
  const std::vector<GudhiSimplex>& simplices_;
  std::vector<std::vector<std::size_t>> cofacets_;
  std::vector<Rational> values_;
};

// GUDHI rounds its exact values to doubles, to within some ulps. Out of the range of doubles there is nothing
// to compare.
void require_value(const GudhiSimplex& simplex, const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  if (!nearest || !std::isnormal(*nearest) || !std::isnormal(simplex.filtration)) return;
  if (std::abs(*nearest - simplex.filtration) > 1e-12 * *nearest) {
    throw std::runtime_error("GUDHI's filtration value is " + std::to_string(simplex.filtration) + ", the exact one " +
                             flowcert::to_text(value));
  }
}

// Equal values have equal ranks.
std::vector<std::size_t> ranks(const std::vector<Rational>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::size_t> rank(values.size(), 0);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const bool is_larger = values[order[k - 1]] < values[order[k]];
    rank[order[k]] = rank[order[k - 1]] + (is_larger ? 1 : 0);
  }
  return rank;
}

}  // namespace

bool operator<(const ExactPair& a, const ExactPair& b) {
  if (a.dimension != b.dimension) return a.dimension < b.dimension;
  if (a.birth != b.birth) return a.birth < b.birth;
  return a.death && (!b.death || *a.death < *b.death);
}

std::string to_text(const ExactPair& pair) {
  return "dimension " + std::to_string(pair.dimension) + ": " + flowcert::to_text(pair.birth) + " to " +
         (pair.death ? flowcert::to_text(*pair.death) : "infinity");
}

std::vector<ExactPair> alpha_persistence(std::span<const Point> points, AlphaTimes* times) {
  const Clock::time_point start = Clock::now();
  GudhiAlpha alpha(points);
  const std::vector<GudhiSimplex>& simplices = alpha.simplices();
  const Clock::time_point built = Clock::now();
  const std::vector<Rational> values = AlphaValues(points, simplices).take();
  for (std::size_t k = 0; k < simplices.size(); ++k) require_value(simplices[k], values[k]);
  const std::vector<std::size_t> rank = ranks(values);
  const Clock::time_point ranked = Clock::now();
  const std::vector<GudhiPair> found = alpha.persistence(rank);
  if (times) {
    times->values = Seconds(ranked - built).count();
    times->gudhi = Seconds(built - start + (Clock::now() - ranked)).count();
  }
  std::vector<ExactPair> pairs;
  for (const GudhiPair& pair : found) {
    if (pair.death && rank[pair.birth] == rank[*pair.death]) continue;
    const std::size_t vertices = simplices[pair.birth].vertices.size();
    pairs.push_back({static_cast<int>(vertices) - 1, values[pair.birth], std::nullopt});
    if (pair.death) pairs.back().death = values[*pair.death];
  }
  std::ranges::sort(pairs, std::less<>());
  return pairs;
}

std::vector<ExactPair> exact_pairs(const Persistence& persistence) {
  std::vector<ExactPair> pairs;
  for (const PersistencePair& pair : persistence.pairs()) {
    pairs.push_back({pair.dimension, persistence.squared_value(pair.birth), std::nullopt});
    if (pair.death) pairs.back().death = persistence.squared_value(*pair.death);
  }
  std::ranges::sort(pairs, std::less<>());
  return pairs;
}

std::string difference(const std::vector<ExactPair>& own, const std::vector<ExactPair>& gudhi) {
  const auto [a, b] = std::ranges::mismatch(own, gudhi);
  if (a == own.end() && b == gudhi.end()) return {};
  if (b == gudhi.end() || (a != own.end() && *a < *b)) return "only the flow complex has " + to_text(*a);
  return "only the alpha complex has " + to_text(*b);
}

std::size_t count_differences(const std::vector<ExactPair>& own, const std::vector<ExactPair>& gudhi) {
  std::vector<ExactPair> differing;
  std::ranges::set_symmetric_difference(own, gudhi, std::back_inserter(differing), std::less<>());
  return differing.size();
}

}  // namespace flowcert::property
