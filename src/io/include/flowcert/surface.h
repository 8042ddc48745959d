// Stable manifolds S2 as one surface: which of them, their triangles with shared vertices, and the files.
//
// Guarantees: a selection is decided exactly. Vertices are one iff their exact positions are equal, whatever their
// doubles; coordinates are the doubles nearest to the exact ones. Two triangles for each backward segment (spec
// clause FC-STAB-04), none for parts of dimension 3. Triangles have no common orientation: surfaces of several S2
// are no manifold in general.
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

// Which critical points of index 2 a surface is made of. All conditions have to hold; of several alike the sharpest.
class SurfaceSelection {
 public:
  // Expressions: "persistence>X" (death minus birth of the pair that it is in, a difference of squared distances),
  // "index2-radius<R" (its distance, not squared), "largest-gaps=N" (the N most persistent ones; of equal ones the
  // first in the list). X and R are read exactly. Throws InvalidInput for anything else.
  explicit SurfaceSelection(const std::vector<std::string>& expressions);

  // By their numbers in StableManifolds, ascending. Conditions on persistence need the whole complex.
  [[nodiscard]] std::vector<std::size_t> sets(const FlowComplex& complex) const;

 private:
  // option: the how manieth expression it is, for messages.
  void add(const std::string& expression, std::size_t option);

  std::optional<Rational> persistence_above_;
  std::optional<Rational> radius_below_;
  std::optional<std::size_t> largest_gaps_;
};

struct SurfaceMesh {
  std::vector<Point> vertices;
  // Of each vertex, to the samples nearest to it; none beyond the doubles.
  std::vector<std::optional<double>> squared_distances;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> set_of_triangle;  // its number in StableManifolds
};

// sets: critical points of index 2, by their numbers in StableManifolds, each once. Throws InvalidInput for a
// coordinate beyond the doubles. Flows once more.
[[nodiscard]] SurfaceMesh surface_mesh(const FlowComplex& complex, std::span<const std::size_t> sets,
                                       const std::function<void(std::size_t, std::size_t)>& progress = {});

// PLY (binary, little endian, double coordinates) and OFF (text). Coordinates read back to the same doubles;
// triangles keep their order. comment: one line.
void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);
void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment);

}  // namespace flowcert
