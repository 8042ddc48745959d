// Stable manifolds S2 as one surface: which of them, their triangles with shared vertices, and the files.
//
// Guarantees: a selection is decided exactly. Two triangles share a vertex iff the exact positions are equal,
// whatever the doubles. Coordinates are the doubles nearest to the exact ones. Each backward segment gives two
// triangles (spec clause FC-STAB-04); parts of dimension 3 give none. Triangles have no common orientation, because a
// surface of several S2 is no manifold in general.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"

namespace flowcert {

// Chooses the critical points of index 2 that make a surface. All conditions have to hold, so of several alike
// the sharpest one decides.
class SurfaceSelection {
 public:
  // Expressions: "persistence>X" (death minus birth of the pair that it is in, a difference of squared distances),
  // "index2-radius<R" (its distance, not squared), "largest-gaps=N" (the N most persistent ones; of equal ones the
  // first in the list). X and R are read exactly. Throws InvalidInput for anything else.
  explicit SurfaceSelection(const std::vector<std::string>& expressions);

  // The chosen points, by number in StableManifolds, ascending. Conditions on persistence need the whole complex.
  [[nodiscard]] std::vector<std::size_t> sets(const FlowComplex& complex) const;

 private:
  // option: the ordinal of the expression, from 1, for messages.
  void add(const std::string& expression, std::size_t option);

  std::optional<Rational> persistence_above_;
  std::optional<Rational> radius_below_;
  std::optional<std::size_t> largest_gaps_;
};

struct SurfaceMesh {
  std::vector<Point> vertices;
  // From each vertex to its nearest samples. A value beyond the doubles is left out.
  std::vector<std::optional<double>> squared_distances;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> set_of_triangle;  // its number in StableManifolds
};

// sets: critical points of index 2, by their numbers in StableManifolds, each once. The stable sets are computed once
// more. Throws InvalidInput for a coordinate beyond the doubles.
[[nodiscard]] SurfaceMesh surface_mesh(const FlowComplex& complex, std::span<const std::size_t> sets,
                                       const std::function<void(std::size_t, std::size_t)>& progress = {});

// PLY (binary, little endian, double coordinates) and OFF (text). Coordinates read back to the same doubles;
// triangles keep their order. comment: one line.
void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);
void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);

}  // namespace flowcert
