// The conditions of FC-CLAIM-04, one after the other.
#include "certify/perturbed_point.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <set>
#include <stdexcept>

#include "certify/claimed_geometry.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

std::vector<PointId> with(std::vector<PointId> names, PointId name) {
  names.insert(std::ranges::upper_bound(names, name), name);
  return names;
}

int index_of(const std::vector<PointId>& simplex) { return static_cast<int>(simplex.size()) - 1; }

}  // namespace

PerturbedPoint::PerturbedPoint(CheckRun& run, std::size_t record)
    : run_(run),
      index_(run.index(record)),
      contact_(run.truth.contact(record).begin(), run.truth.contact(record).end()),
      center_(run.truth.sphere(record).center),
      is_simplex_(contact_.size() == index_.hull_dimension + std::size_t{1}) {
  if (is_simplex_) outcomes_ = outcomes_of_simplex();
  // What a claim says nothing of may be there or not.
  for (std::vector<Names>& outcome : outcomes_) {
    std::erase_if(outcome, [&](const Names& simplex) { return !run_.judges(index_of(simplex)); });
  }
  if (!is_simplex_) opposite_pairs_ = count_opposite_samples();
}

// ---- Simplices ----

std::vector<std::vector<PerturbedPoint::Names>> PerturbedPoint::outcomes_of_simplex() const {
  if (index_.is_critical()) return {{contact_}};
  // The centre lies inside one face. It is the only one of its dimension that has its centre there.
  for (std::uint32_t chosen = 0; chosen < 1U << contact_.size(); ++chosen) {
    Names face;
    for (std::size_t k = 0; k < contact_.size(); ++k) {
      if ((chosen >> k & 1U) != 0) face.push_back(contact_[k]);
    }
    if (index_of(face) != index_.face_dimension || !has_in_hull(run_.points, face, center_)) continue;
    if (index_ == StationaryIndex{1, 3}) return outcomes_of_kind_13(face);
    return {{face, contact_}};
  }
  throw std::logic_error("a regular stationary point without a face that has its centre inside");
}

std::vector<std::vector<PerturbedPoint::Names>> PerturbedPoint::outcomes_of_kind_13(const Names& edge) const {
  Names others;
  std::ranges::set_difference(contact_, edge, std::back_inserter(others));
  const Names one = with(edge, others[0]), other = with(edge, others[1]);
  std::vector<std::vector<Names>> outcomes = {{edge, one, other, contact_}};
  // The angle at the edge between the two triangles: positive if it is acute.
  const Vector3<Rational> a = from_center(edge[0]), r = from_center(others[0]), s = from_center(others[1]);
  const Rational cosine = dot(r, s) * dot(a, a) - dot(r, a) * dot(s, a);
  if (cosine >= 0) {
    outcomes.push_back({edge, one});
    outcomes.push_back({edge, other});
  }
  if (cosine <= 0) {
    outcomes.push_back({one, contact_});
    outcomes.push_back({other, contact_});
  }
  return outcomes;
}

bool PerturbedPoint::is_outcome(const std::vector<Names>& outcome, std::span<const std::size_t> claimed) const {
  if (outcome.size() != claimed.size()) return false;
  std::array<std::size_t, 4> surplus{};
  for (const Names& simplex : outcome) ++surplus.at(simplex.size() - 1);
  for (const std::size_t k : claimed) {
    const Names& names = run_.placed[k].names;
    if (!names.empty() && std::ranges::find(outcome, names) == outcome.end()) return false;
    std::size_t& left = surplus.at(static_cast<std::size_t>(run_.claim.points[k].index));
    if (left == 0) return false;
    --left;
  }
  return true;
}

// ---- Conditions ----

bool PerturbedPoint::can_make(std::size_t k) const {
  const int index = run_.claim.points[k].index;
  const Names& names = run_.placed[k].names;
  if (index < 1 || index > 3 || run_.claim.points[k].hull_dimension) return false;
  if (is_simplex_) {
    return std::ranges::any_of(outcomes_, [&](const std::vector<Names>& outcome) {
      return std::ranges::any_of(outcome, [&](const Names& simplex) {
        return index_of(simplex) == index && (names.empty() || names == simplex);
      });
    });
  }
  if (names.empty()) return index > 1 || opposite_pairs_ > 0;
  if (!std::ranges::includes(contact_, names)) return false;
  return (index_of(names) == index || is_face(names, index)) && has_in_hull(run_.points, names, center_);
}

bool PerturbedPoint::is_again(std::size_t k, const std::vector<std::size_t>& same_index) const {
  if (is_simplex_) {
    // A simplex has at most so many faces of this dimension with that centre.
    const bool has_two = index_ == StationaryIndex{1, 3} && run_.claim.points[k].index == 2;
    if (same_index.size() >= (has_two ? 2U : 1U)) return true;
  } else if (run_.claim.points[k].index == 1 && same_index.size() >= opposite_pairs_) {
    return true;
  }
  return std::ranges::any_of(same_index, [&](std::size_t other) {
    return !run_.placed[k].names.empty() && run_.placed[k].names == run_.placed[other].names;
  });
}

MadeByPerturbation PerturbedPoint::makes(std::span<const std::size_t> claimed) const {
  if (is_simplex_) {
    const bool is_one =
        std::ranges::any_of(outcomes_, [&](const auto& outcome) { return is_outcome(outcome, claimed); });
    return is_one ? MadeByPerturbation::kYes : MadeByPerturbation::kNo;
  }
  int sum = 0;
  bool has_own_index = false;
  for (const std::size_t k : claimed) {
    const int index = run_.claim.points[k].index;
    sum += index % 2 == 0 ? 1 : -1;
    has_own_index = has_own_index || index == index_.face_dimension;
  }
  const int right_sum = !index_.is_critical() ? 0 : index_.face_dimension % 2 == 0 ? 1 : -1;
  const bool has_right_sum = sum == right_sum || !run_.judges_all();
  const bool needs_own_index = index_.is_critical() && run_.judges(index_.face_dimension);
  const bool is_possible = has_right_sum && (has_own_index || !needs_own_index) && !overlap(claimed);
  return is_possible ? MadeByPerturbation::kNotDecided : MadeByPerturbation::kNo;
}

// ---- Geometry ----

bool PerturbedPoint::is_face(const Names& names, int dimension) const {
  if (names == contact_) return dimension == index_.hull_dimension;
  if (dimension != 2 || names.size() < 3 || affine_dimension(run_.points, names) != 2) return false;
  return index_.hull_dimension == 3 && supported_face(run_.points, names, contact_) == names;
}

bool PerturbedPoint::has_inside(const Names& tetrahedron) const {
  if (affine_dimension(run_.points, tetrahedron) < 3) return false;
  for (const PointId left_out : tetrahedron) {
    Names triangle = tetrahedron;
    std::erase(triangle, left_out);
    if (has_in_hull(run_.points, triangle, center_)) return false;
  }
  return true;
}

// Whether the samples are, or span, a proper face of the hull with the centre in it.
bool PerturbedPoint::is_on_face(const Names& names, int index) const {
  if (index == 1) return index_.face_dimension == 1;
  return index == 2 && index_.hull_dimension == 3 && !supported_face(run_.points, names, contact_).empty();
}

// Delaunay faces do not overlap. So one tetrahedron at most has the centre inside. If all of the contact set stays
// together, what else there is are faces of its hull.
bool PerturbedPoint::overlap(std::span<const std::size_t> claimed) const {
  const auto names = [&](std::size_t k) -> const Names& { return run_.placed[k].names; };
  const auto is_whole = [&](std::size_t k) {
    return names(k) == contact_ && run_.claim.points[k].index == index_.hull_dimension;
  };
  const bool is_together = std::ranges::any_of(claimed, is_whole);
  std::size_t around = 0;
  for (const std::size_t k : claimed) {
    const int index = run_.claim.points[k].index;
    if (names(k).empty() || is_whole(k)) continue;
    if (is_together && !is_on_face(names(k), index)) return true;
    around += index == 3 && names(k).size() == 4 && has_inside(names(k)) ? 1 : 0;
  }
  return around > 1;
}

std::size_t PerturbedPoint::count_opposite_samples() const {
  std::set<RationalPoint> samples;
  for (const PointId name : contact_) samples.insert(exact_position(sample(run_.points, name)));
  const auto count = std::ranges::count_if(samples, [&](const RationalPoint& p) {
    return samples.contains({2 * center_[0] - p[0], 2 * center_[1] - p[1], 2 * center_[2] - p[2]});
  });
  return static_cast<std::size_t>(count) / 2;
}

Vector3<Rational> PerturbedPoint::from_center(PointId name) const {
  return vector_between(center_, exact_position(sample(run_.points, name)));
}

}  // namespace flowcert::certify
