// The loops that stand for persistence pairs of dimension 1, and the surfaces that fill them.
//
// Guarantees: exact, on every input. A surface is a set of critical points of index 2, whose stable manifolds it is made
// of, and a loop a set of critical points of index 1: the boundary of the surface, mod 2. A surface at a level has the
// death point of the pair and earlier points of index 2 whose own pairs are born above the level; its loop lies in
// {d^2 <= level}. There is one such surface. Numbers of points are places in the list. Source: spec section 18 (clauses
// FC-CYC).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/persistence.h"
#include "flowcert/rational.h"
#include "flowcert/saddle_links.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

// Samples by name, each next to the one before, and the last one next to the first. No sample comes twice.
using LoopPolygon = std::vector<PointId>;

// What shows that a pair of dimension 1 occurs, without any other pair (FC-CYC-08). All lists ascend.
struct LoopWitness {
  std::vector<std::uint32_t> surface, loop;  // at birth
  std::vector<std::uint32_t> cocycle;        // points of index 1
  std::vector<std::uint32_t> met;            // index-2 points of values below the death's whose boundary meets it
};

// Const access is safe from several threads.
class Loops {
 public:
  // All are of one complex and must outlive this. O(critical points, and additions of the reduction).
  Loops(const StationaryPoints& stationary, const SaddleLinks& links, const Persistence& persistence);

  // The pair has dimension 1. The level is a squared distance, at least that of the birth and less than that of the
  // death. The surface ascends. O(k log k) for k additions that make it. Throws std::invalid_argument for a pair of
  // another dimension.
  [[nodiscard]] std::vector<std::uint32_t> surface(const PersistencePair& pair, const SquaredLevel& level) const;
  // All that the reduction of pairs adds to a death point of dimension 1, with the point itself: its boundary is the
  // reduced one, of which the point's partner is the latest. Ascending.
  [[nodiscard]] std::vector<std::uint32_t> whole_surface(std::uint32_t death) const;
  // The boundary of a surface. Ascending.
  [[nodiscard]] std::vector<std::uint32_t> boundary(std::span<const std::uint32_t> surface) const;
  // The pair has dimension 1. The reduction of coboundaries, as far as this pair needs it: cubic at worst. Throws
  // std::invalid_argument for a pair of another dimension.
  [[nodiscard]] LoopWitness witness(const PersistencePair& pair) const;
  // A loop as polygons without repetition (FC-CYC-05). Each begins with its least sample and goes to the lesser one of
  // that one's neighbours.
  [[nodiscard]] std::vector<LoopPolygon> polygons(std::span<const std::uint32_t> loop) const;

 private:
  [[nodiscard]] std::span<const std::uint32_t> added_to(std::uint32_t saddle) const {
    const std::size_t k = saddle - first_saddle_;
    return std::span(added_).subspan(first_added_[k], first_added_[k + 1] - first_added_[k]);
  }
  [[nodiscard]] std::vector<std::uint32_t> surface_of(std::uint32_t death, std::span<const std::uint32_t> added) const;

  const StationaryPoints* stationary_;
  const SaddleLinks* links_;
  const Persistence* persistence_;
  std::size_t first_saddle_;
  // Each index-2 point has here the points whose reduced columns were added to its own, in the order of adding.
  std::vector<std::uint32_t> first_added_, added_;
};

}  // namespace flowcert
