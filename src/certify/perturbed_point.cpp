// The conditions of FC-CLAIM-04, one after the other.
#include "certify/perturbed_point.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
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
  const RationalPoint a = from_center(edge[0]), r = from_center(others[0]), s = from_center(others[1]);
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
  const bool can_be_kept = is_face(names, index) || (index == 3 && !polygon_below_apex(names).empty());
  return (index_of(names) == index || can_be_kept) && has_in_hull(run_.points, names, center_);
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
  const bool is_possible = has_right_sum(claimed) && are_different(claimed) && !overlap(claimed);
  return is_possible ? MadeByPerturbation::kNotDecided : MadeByPerturbation::kNo;
}

// Indices that are not judged may have any possible numbers of points (FC-CLAIM-12).
bool PerturbedPoint::has_right_sum(std::span<const std::size_t> claimed) const {
  struct Range {
    long long least = 0, most = 0;
  };
  constexpr long long kMany = std::numeric_limits<int>::max();
  std::array<Range, 4> counts{};
  for (const std::size_t k : claimed) ++counts.at(static_cast<std::size_t>(run_.claim.points[k].index)).least;
  for (int index = 1; index <= 3; ++index) {
    Range& range = counts.at(static_cast<std::size_t>(index));
    const bool is_own = index_.is_critical() && index == index_.face_dimension;
    range.most = range.least;
    if (is_own && run_.judges(index) && range.least == 0) return false;
    if (run_.judges(index)) continue;
    range = {is_own ? 1 : 0, index == 1 ? static_cast<long long>(opposite_pairs_) : kMany};
  }
  // n2 - n1 - n3 takes all values between its least and its greatest one.
  const long long right = !index_.is_critical() ? 0 : index_.face_dimension % 2 == 0 ? 1 : -1;
  return counts[2].least - counts[1].most - counts[3].most <= right &&
         right <= counts[2].most - counts[1].least - counts[3].least;
}

bool PerturbedPoint::are_different(std::span<const std::size_t> claimed) const {
  std::set<Names> seen;
  return std::ranges::all_of(claimed, [&](std::size_t k) {
    const Names& names = run_.placed[k].names;
    return names.empty() || seen.insert(names).second;
  });
}

// ---- Geometry ----

bool PerturbedPoint::is_face(const Names& names, int dimension) const {
  if (names == contact_) return dimension == index_.hull_dimension;
  if (dimension != 2 || names.size() < 3 || affine_dimension(run_.points, names) != 2) return false;
  return index_.hull_dimension == 3 && supported_face(run_.points, names, contact_) == names;
}

// The polygon that stays on its circle where a perturbation makes this contact set with one further sample of the
// point. There is one at most, because two would share three samples.
PerturbedPoint::Names PerturbedPoint::polygon_below_apex(const Names& names) const {
  if (index_.hull_dimension < 3 || names.size() < 5) return {};
  // Three of the first four samples are in it.
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    Names three(names.begin(), names.begin() + 4);
    three.erase(three.begin() + static_cast<std::ptrdiff_t>(left_out));
    Names face = supported_face(run_.points, three, contact_);
    if (face.size() + 1 == names.size() && std::ranges::includes(names, face)) return face;
  }
  return {};
}

// Whether the centre, which is in the hull of these, is in its interior. They are a tetrahedron, or a polygon with one
// further sample.
bool PerturbedPoint::has_inside(const Names& names) const {
  if (names.size() < 4 || affine_dimension(run_.points, names) < 3) return false;
  const Names base = names.size() == 4 ? Names(names.begin() + 1, names.end()) : polygon_below_apex(names);
  if (base.empty() || has_in_hull(run_.points, base, center_)) return false;
  Names apex;
  std::ranges::set_difference(names, base, std::back_inserter(apex));
  return is_amid(base, from_center(apex.front()));
}

// Whether in every plane through the axis, these samples lie on both sides.
bool PerturbedPoint::is_amid(const Names& base, const RationalPoint& axis) const {
  const auto plane_to = [&](PointId name) { return cross(axis, from_center(name)); };
  // If all are on one side of some plane, this finds the first of them around the axis. It takes two rounds, because
  // one that is opposite to another is on no side of that.
  RationalPoint first = plane_to(base.front());
  for (int round = 0; round < 2; ++round) {
    for (const PointId name : base) {
      const RationalPoint plane = plane_to(name);
      if (is_zero(plane)) return false;
      if (dot(first, from_center(name)) < 0) first = plane;
    }
  }
  return std::ranges::any_of(base, [&](PointId name) { return dot(first, from_center(name)) < 0; });
}

// Whether the samples, which have the centre in their hull, are part of the vertex set of a proper face.
bool PerturbedPoint::is_on_face(const Names& names) const {
  // A line through the centre is in every plane that supports the hull there.
  if (names.size() == 2) return !index_.is_critical();
  return index_.hull_dimension == 3 && affine_dimension(run_.points, names) == 2 &&
         !supported_face(run_.points, names, contact_).empty();
}

// Delaunay faces do not overlap. So of one of them at most the centre is inside. If all of the contact set stays
// together, what else there is lies on faces of its hull. Otherwise one polygon at most stays on its circle.
bool PerturbedPoint::overlap(std::span<const std::size_t> claimed) const {
  bool is_together = false, are_on_faces = true;
  std::size_t around = 0;
  std::set<Names> polygons;
  for (const std::size_t k : claimed) {
    const int index = run_.claim.points[k].index;
    const Names& names = run_.placed[k].names;
    if (names.empty()) continue;
    if (names == contact_ && index == index_.hull_dimension) {
      is_together = true;
      continue;
    }
    are_on_faces = are_on_faces && is_on_face(names);
    if (index == 3 && has_inside(names)) ++around;
    if (index_of(names) > index) polygons.insert(index == 2 ? names : polygon_below_apex(names));
  }
  if (around > 1 || (is_together && !are_on_faces)) return true;
  // All of it may stay together, without being claimed.
  const bool may_be_together = is_together || (!run_.judges(3) && are_on_faces);
  return !may_be_together && polygons.size() > 1;
}

std::size_t PerturbedPoint::count_opposite_samples() const {
  std::set<RationalPoint> samples;
  for (const PointId name : contact_) samples.insert(exact_position(sample(run_.points, name)));
  const auto count = std::ranges::count_if(
      samples, [&](const RationalPoint& p) { return samples.contains(Rational(2) * center_ - p); });
  return static_cast<std::size_t>(count) / 2;
}

RationalPoint PerturbedPoint::from_center(PointId name) const {
  return exact_position(sample(run_.points, name)) - center_;
}

}  // namespace flowcert::certify
