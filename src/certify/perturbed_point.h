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
#include "geometry/vector3.h"

namespace flowcert::certify {

enum class MadeByPerturbation { kNo, kNotDecided, kYes };

class PerturbedPoint {
 public:
  // The run must outlive this. O(n log n) for a contact set of n samples.
  PerturbedPoint(CheckRun& run, std::size_t record);

  // For a simplex, whether some perturbation makes this claimed critical point, perhaps together with others.
  // Otherwise, whether no condition on it alone forbids it.
  [[nodiscard]] bool can_make(std::size_t claimed_point) const;
  // Whether a claimed point repeats one of the same index. A position alone leaves open which of several contact
  // sets is meant. `same_index` has the claims of that index that are accepted so far.
  [[nodiscard]] bool is_again(std::size_t claimed_point, const std::vector<std::size_t>& same_index) const;
  // Whether one perturbation makes just these points. It must be able to make each, and none may be there again.
  [[nodiscard]] MadeByPerturbation makes(std::span<const std::size_t> claimed_points) const;

 private:
  using Names = std::vector<PointId>;

  [[nodiscard]] std::vector<std::vector<Names>> outcomes_of_simplex() const;
  [[nodiscard]] std::vector<std::vector<Names>> outcomes_of_kind_13(const Names& edge) const;
  [[nodiscard]] bool is_outcome(const std::vector<Names>& outcome, std::span<const std::size_t> claimed_points) const;
  [[nodiscard]] bool is_face(const Names& names, int dimension) const;
  [[nodiscard]] bool is_on_face(const Names& names) const;
  [[nodiscard]] Names polygon_below_apex(const Names& names) const;
  [[nodiscard]] bool has_inside(const Names& names) const;
  [[nodiscard]] bool is_amid(const Names& base, const RationalPoint& axis) const;
  [[nodiscard]] bool has_right_sum(std::span<const std::size_t> claimed) const;
  [[nodiscard]] bool are_different(std::span<const std::size_t> claimed) const;
  [[nodiscard]] bool overlap(std::span<const std::size_t> claimed_points) const;
  [[nodiscard]] std::size_t count_opposite_samples() const;
  [[nodiscard]] RationalPoint from_center(PointId name) const;

  CheckRun& run_;
  StationaryIndex index_;
  Names contact_;
  RationalPoint center_;
  bool is_simplex_;
  std::size_t opposite_pairs_ = 0;            // of samples, if the contact set is no simplex
  std::vector<std::vector<Names>> outcomes_;  // of a simplex; without the one that leaves nothing
};

}  // namespace flowcert::certify
