// What perturbations of the samples make of one stationary point (FC-CLAIM-04).
//
// Guarantees: exact. If the contact set is a simplex, all that perturbations make of the point is known. Otherwise a
// claim that breaks a necessary condition is found, and a claim that keeps all of them is not decided. The conditions
// are proved in spec/proofs.md.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "certify/check_run.h"
#include "flowcert/rational.h"

namespace flowcert::certify {

enum class MadeByPerturbation { kNo, kNotDecided, kYes };

class PerturbedPoint {
 public:
  // The run must outlive this. Takes time in proportion to the contact set, and to the cube of its size only if it is
  // a simplex.
  PerturbedPoint(CheckRun& run, std::size_t record);

  // Whether some perturbation makes this claimed critical point, perhaps together with others.
  [[nodiscard]] bool can_make(std::size_t claimed_point) const;
  // Whether two claimed points of one index are the same point. A position alone does not tell which of several
  // contact sets is meant. `same_index` has the claims of that index that are accepted so far.
  [[nodiscard]] bool is_again(std::size_t claimed_point, const std::vector<std::size_t>& same_index) const;
  // Whether one perturbation makes just these points. It must be able to make each, and none may be there again.
  [[nodiscard]] MadeByPerturbation makes(std::span<const std::size_t> claimed_points) const;

 private:
  using Names = std::vector<PointId>;

  [[nodiscard]] std::vector<std::vector<Names>> outcomes_of_simplex() const;
  [[nodiscard]] std::vector<std::vector<Names>> outcomes_of_kind_13(const Names& edge) const;
  [[nodiscard]] bool is_outcome(const std::vector<Names>& outcome, std::span<const std::size_t> claimed_points) const;
  [[nodiscard]] bool is_face(const Names& names, int dimension) const;
  [[nodiscard]] bool has_opposite_samples() const;
  [[nodiscard]] RationalPoint from_center(PointId name) const;

  CheckRun& run_;
  StationaryIndex index_;
  Names contact_;
  RationalPoint center_;
  bool is_simplex_;
  std::vector<std::vector<Names>> outcomes_;  // of a simplex; without the one that leaves nothing
};

}  // namespace flowcert::certify
