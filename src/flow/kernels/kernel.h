// What a construction kernel is: it keeps the points that the flow constructs, and decides signs about them.
//
// Guarantees of every kernel: signs and coordinates are exact. A point is a number that the kernel gives out; its
// storage, and the history that it may keep of a point, are its own. Requirements are written here once, as a
// concept; CascadeKernel, LazyKernel and ExactKernel are its models. Not for two threads at once. Source: paper,
// sections 5.2, 6.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "flow/kernels/steering.h"
#include "flowcert/kernel_tally.h"
#include "flowcert/rational.h"
#include "geometry/contract.h"

namespace flowcert::flow {

// A sign comes from a kernel's filter, or from an intermediate precision if it has one. Both may leave it open. Its
// exact numbers answer always.
enum class KernelRung { kFilter, kExtended, kExact };

// A lasting point stays until drop_all(), and its number has kLasting.
enum class Stay { kPassing, kLasting };

// K knows the sign of a query, and what one rung alone says of it.
template <class K, class Query>
concept Answers = requires(K& kernel, const Query& query, KernelRung rung) {
  { kernel.sign(query) } -> std::same_as<Sign>;
  { kernel.sign_on_rung(query, rung) } -> std::same_as<MaybeSign>;
};
template <class K, class... Query>
constexpr bool answers_each(QueryList<Query...>) {
  return (Answers<K, Query> && ...);
}

template <class K>
concept ConstructsPoints = std::constructible_from<K, KernelTally&> && answers_each<K>(SteeringQueries{}) &&
    requires(K& kernel, const K& constant, PointNumber x, const RationalPoint& position, const Point& p,
             std::span<const Point* const> simplex, Stay stay) {
  // Keeps a point, by its coordinates, or as the point where the ray from the midpoint of p0 and p1 through x
  // crosses the bisector of q (`crossing` in steering.h).
  { kernel.add(position) } -> std::same_as<PointNumber>;
  { kernel.add_crossing(x, p, p, p) } -> std::same_as<PointNumber>;
  // Keeps the centre of the circle or sphere through 3 or 4 points, which are affinely independent. Four of them are
  // positively oriented.
  { kernel.add_circumcenter(simplex, stay) } -> std::same_as<PointNumber>;

  // Whether the flow asks on which side of a ray a Voronoi vertex lies by constructing the vertex (SideOfRay), or by
  // the samples that make it (OrderOfExits).
  { K::kConstructsVertices } -> std::convertible_to<bool>;

  { kernel.exact(x) } -> std::same_as<RationalPoint>;
  // How many bytes the coordinates take, where they have been computed exactly.
  { constant.exact_bytes(x) } -> std::same_as<std::optional<std::array<std::size_t, 3>>>;
  // The longest chain of constructions behind x that the kernel remembers.
  { constant.depth(x) } -> std::same_as<std::size_t>;

  // Points that do not last are numbered in order; the latest can be dropped.
  { constant.kept() } -> std::same_as<PointNumber>;
  {kernel.drop_from(x)};
  {kernel.drop_all()};
};

// The centre of 3 or 4 points, by what makes it from their vectors.
template <class In, class Construct>
[[nodiscard]] auto center_of(std::span<const Point* const> p, const In& in, const Construct& construct) {
  FLOWCERT_REQUIRES(p.size() == 3 || p.size() == 4);
  return p.size() == 3 ? construct(in(*p[0]), in(*p[1]), in(*p[2]))
                       : construct(in(*p[0]), in(*p[1]), in(*p[2]), in(*p[3]));
}

// The storage of a kernel's points.
template <class Value>
class PointStorage {
 public:
  PointNumber keep(Value value, Stay stay = Stay::kPassing) {
    std::vector<Value>& values = stay == Stay::kLasting ? lasting_ : passing_;
    values.push_back(std::move(value));
    return static_cast<PointNumber>(values.size() - 1) | (stay == Stay::kLasting ? kLasting : 0);
  }
  // A new passing point, with the greatest number.
  [[nodiscard]] Value& add() { return passing_.emplace_back(); }
  [[nodiscard]] bool has(PointNumber number) const {
    return (number & kLasting) != 0 ? (number ^ kLasting) < lasting_.size() : number < passing_.size();
  }
  const Value& operator[](PointNumber number) const {
    FLOWCERT_REQUIRES(has(number));
    return (number & kLasting) != 0 ? lasting_[number ^ kLasting] : passing_[number];
  }
  [[nodiscard]] Value& at(PointNumber number) { return const_cast<Value&>((*this)[number]); }
  [[nodiscard]] PointNumber kept() const { return static_cast<PointNumber>(passing_.size()); }
  void drop_from(PointNumber number) {
    FLOWCERT_REQUIRES(number <= kept());
    passing_.erase(passing_.begin() + static_cast<std::ptrdiff_t>(number), passing_.end());
  }
  void drop_all() {
    passing_.clear();
    lasting_.clear();
  }

 private:
  std::vector<Value> passing_, lasting_;
};

}  // namespace flowcert::flow
