#include "morse/facet_sides.h"

#include <algorithm>

#include "morse/polygon_turn.h"

namespace flowcert::morse {

FacetSides::FacetSides(const VoronoiDiagram& diagram, const FacetRing& ring)
    : diagram_(&diagram), ring_(ring), chain_(obtuse_chain(diagram, ring)) {}

// A Voronoi edge before the element goes there, and one behind it comes from there.
EdgeEnd FacetSides::end_at_infinity(std::size_t k) const {
  const std::size_t here = k % size(), before = ring_.before(here);
  const bool is_far_end = ring_.pieces[before].is_finite();
  const std::size_t edge = is_far_end ? before : here;
  return {ring_.pieces[edge].polygon(), is_forward(edge) == is_far_end ? 1u : 0u};
}

bool FacetSides::is_forward(std::size_t k) const {
  return has_turn(*diagram_, piece(k).polygon(), {ring_.facet.v0, ring_.facet.v1, piece(k).apex});
}

Sign FacetSides::angle(std::size_t k) const {
  if (!piece(k).is_finite()) return Sign::kPositive;
  const PolygonSides sides = diagram_->sides(piece(k).polygon());
  return std::ranges::find_if(sides, [&](const PolygonSide& side) { return side.facet() == ring_.facet; })->angle;
}

PieceRun FacetSides::far() const {
  const auto n = static_cast<std::uint32_t>(size());
  if (chain_.count == 0) {
    if (chain_.right_count == 0) return {0, n};
    return {(chain_.right + 1) % n, n - chain_.right_count};
  }
  PieceRun run{(chain_.first + chain_.count) % n, n - chain_.count};
  if (chain_.right_count == 0) return run;
  if (angle(run.first) == Sign::kZero) run = {(run.first + 1) % n, run.count - 1};
  if (run.count > 0 && angle(run.first + run.count - 1) == Sign::kZero) --run.count;
  return run;
}

}  // namespace flowcert::morse
