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
#include "flowcert/flow_statistics.h"
#include "flowcert/rational.h"
#include "flowcert/sphere.h"
#include "geometry/contract.h"

namespace flowcert::flow {

// A sign comes from a kernel's filter, or from a longer precision if it has any. All of them may leave it open. Its
// exact numbers answer always.
enum class KernelRung { kFilter, kDoubled, kExtended, kExact };

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
concept KeepsPoints = requires(K& kernel, const K& constant, PointNumber x, const RationalPoint& position,
                               const Point& p, std::span<const Point* const> simplex, Stay stay) {
  // Keeps a point, by its coordinates, or as the point where the ray from the midpoint of p0 and p1 through x
  // crosses the bisector of q (`crossing` in steering.h).
  { kernel.add(position) } -> std::same_as<PointNumber>;
  { kernel.add_crossing(x, p, p, p) } -> std::same_as<PointNumber>;
  // Keeps the centre of the circle or sphere through 3 or 4 points, which are affinely independent. Four of them are
  // positively oriented.
  { kernel.add_circumcenter(simplex, stay) } -> std::same_as<PointNumber>;

  { kernel.exact(x) } -> std::same_as<RationalPoint>;
  // How many bytes the coordinates take, where they have been computed exactly.
  { constant.exact_bytes(x) } -> std::same_as<std::optional<std::array<std::size_t, 3>>>;
  // The longest chain of constructions behind a point, of those that the kernel remembered, since all were dropped.
  { constant.deepest() } -> std::same_as<std::size_t>;

  // Points that do not last are numbered in order; the latest can be dropped.
  { constant.kept() } -> std::same_as<PointNumber>;
  { kernel.drop_from(x) };
  { kernel.drop_all() };
};
template <class K>
concept ConstructsPoints =
    std::constructible_from<K, KernelTally&> && answers_each<K>(SteeringQueries{}) && KeepsPoints<K>;

// A point that moves from facet to facet. It leaves a facet by the bisector of q, and enters the next one. This one
// keeps a point for each facet that it leaves.
template <class Kernel>
class ConstructedMovingPoint {
 public:
  ConstructedMovingPoint(Kernel& kernel, PointNumber start, const Point& p0, const Point& p1)
      : kernel_(kernel), x_(start), p0_(&p0), p1_(&p1) {}

  void leave(const Point& q) { x_ = kernel_.add_crossing(x_, *p0_, *p1_, q); }
  void enter(const Point& p0, const Point& p1) { p0_ = &p0, p1_ = &p1; }

  [[nodiscard]] PointNumber number() const { return x_; }
  [[nodiscard]] Sign sign_of_ray_at_infinity(const Point& q) { return kernel_.sign(RayAtInfinity{x_, *p0_, *p1_, q}); }
  // Between leaving one facet and entering another.
  [[nodiscard]] Sign sign_along_edge(const Point& a, const Point& b, const Point& c) {
    return kernel_.sign(AlongEdge{x_, a, b, c});
  }

 protected:
  Kernel& kernel_;
  PointNumber x_;
  const Point *p0_, *p1_;
};

// A kernel may have a moving point of its own, which keeps no points unless they are asked for. It says on which side
// of its ray a Voronoi vertex lies by the samples that make the vertex (OrderOfExits). Otherwise the vertex is
// constructed (SideOfRay).
template <class K>
concept HasMovingPoint = requires(typename K::MovingPoint& x, const Point& p) {
  { x.sign_of_order(p, p) } -> std::same_as<Sign>;
};
// A kernel may know the doubles nearest to a point's coordinates and squared distance without exact numbers.
template <class K>
concept RoundsPoints = requires(K& kernel, PointNumber x) {
  { kernel.rounded(x) } -> std::same_as<std::optional<RoundedSphere>>;
};

template <class Kernel>
struct MovingPointOf {
  using Type = ConstructedMovingPoint<Kernel>;
};
template <HasMovingPoint Kernel>
struct MovingPointOf<Kernel> {
  using Type = typename Kernel::MovingPoint;
};

// The centre of 3 or 4 points, by what makes it from their vectors.
[[nodiscard]] auto center_of(std::span<const Point* const> p, const auto& in, const auto& construct) {
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
