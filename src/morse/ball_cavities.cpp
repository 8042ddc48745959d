// The components of {d >= s} are those of a graph: the vertices of the power diagram where the power is not negative,
// and the edges along which it never is.
#include "flowcert/ball_cavities.h"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"
#include "morse/ball_level.h"
#include "morse/ball_touching.h"
#include "voronoi/ball_slice.h"

namespace flowcert {

using namespace morse;

namespace {

class Components {
 public:
  Components(const BallSet& balls, const Rational& probe)
      : balls_(balls),
        s_(probe * balls.scale()),
        near_s_(bounded(s_)),
        sized_s_(near_s_.value),
        slice_(balls, probe),
        outside_(static_cast<std::uint32_t>(slice_.tetrahedra.size())),
        sets_(outside_ + 1) {}

  std::vector<BallCavity> run() {
    is_free_.resize(outside_);
    for (std::uint32_t cell = 0; cell < outside_; ++cell) is_free_[cell] = power_sign(slice_.tetrahedra[cell]) >= 0;
    for (std::uint32_t cell = 0; cell < outside_; ++cell) {
      if (!is_free_[cell]) continue;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::uint32_t other = slice_.adjacent[cell][corner];
        if (other == BallSlice::kNone ? is_open(cell, corner)
                                      : other > cell && is_free_[other] && is_open(cell, corner)) {
          sets_.unite(cell, other == BallSlice::kNone ? outside_ : other);
        }
      }
    }
    std::map<std::uint32_t, BallCavity> cavities;
    for (std::uint32_t cell = 0; cell < outside_; ++cell) {
      const std::uint32_t root = sets_.find(cell);
      if (!is_free_[cell] || root == sets_.find(outside_)) continue;
      std::vector<std::uint32_t>& atoms = cavities[root].atoms;
      atoms.insert(atoms.end(), slice_.tetrahedra[cell].begin(), slice_.tetrahedra[cell].end());
    }
    std::vector<BallCavity> made;
    for (auto& [root, cavity] : cavities) {
      std::ranges::sort(cavity.atoms);
      cavity.atoms.erase(std::ranges::unique(cavity.atoms).begin(), cavity.atoms.end());
      made.push_back(std::move(cavity));
    }
    std::ranges::sort(made, {}, &BallCavity::atoms);
    return made;
  }

 private:
  template <class Number>
  [[nodiscard]] const Number& level() const {
    if constexpr (std::is_same_v<Number, BoundedDouble>) {
      return near_s_;
    } else if constexpr (std::is_same_v<Number, SizedDouble>) {
      return sized_s_;
    } else {
      return s_;
    }
  }

  // The sign of a number that `number` makes in the type that it is asked for, or of nothing.
  template <class Make>
  [[nodiscard]] static int sign_of(const Make& number) {
    if (const std::optional<SizedDouble> near = number.template operator()<SizedDouble>()) {
      if (const int sign = near->bounded().certain_sign(); sign != 0) return sign;
    }
    if (const std::optional<BoundedDouble> near = number.template operator()<BoundedDouble>()) {
      if (const int sign = near->certain_sign(); sign != 0) return sign;
    }
    return number.template operator()<Rational>()->compare(0);
  }

  // Of the power of the point that is equally far from the balls of a tetrahedron or a triangle.
  [[nodiscard]] int power_sign(std::span<const std::uint32_t> ids) const {
    return sign_of([&]<class Number>() -> std::optional<Number> {
      const auto made = touching<Number>(balls_, ids);
      if (!made) return std::nullopt;
      const Number& s = level<Number>();
      return (made->c2 * s + Number(2) * made->c1) * s + made->c0;
    });
  }

  // How much less near the fourth ball is at the foot of the triangle's edge of the diagram.
  [[nodiscard]] int lead_sign(std::span<const std::uint32_t> triangle, std::uint32_t id) const {
    return sign_of([&]<class Number>() -> std::optional<Number> {
      const auto made = touching<Number>(balls_, triangle);
      if (!made) return std::nullopt;
      const auto [first, second] =
          lead(*made, ball_from<Number>(balls_, triangle[0], triangle[0]), ball_from<Number>(balls_, triangle[0], id));
      return first + second * level<Number>();
    });
  }

  // Whether the power is nowhere negative on the edge of the diagram behind a corner. It is not at the edge's ends. It
  // is least at the foot of the edge in the triangle's plane, if that lies on the edge.
  [[nodiscard]] bool is_open(std::uint32_t cell, std::size_t corner) const {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0, place = 0; k < 4; ++k) {
      if (k != corner) triangle[place++] = slice_.tetrahedra[cell][k];
    }
    if (power_sign(triangle) >= 0) return true;
    if (lead_sign(triangle, slice_.tetrahedra[cell][corner]) < 0) return true;
    const std::uint32_t other = slice_.adjacent[cell][corner];
    if (other == BallSlice::kNone) return false;
    const auto& behind = slice_.tetrahedra[other];
    const auto fifth = std::ranges::find_if(
        behind, [&](std::uint32_t id) { return std::ranges::find(triangle, id) == triangle.end(); });
    return lead_sign(triangle, *fifth) < 0;
  }

  const BallSet& balls_;
  const Rational s_;
  const BoundedDouble near_s_;
  const SizedDouble sized_s_;
  const BallSlice slice_;
  const std::uint32_t outside_;
  geometry::DisjointSets sets_;
  std::vector<char> is_free_;
};

}  // namespace

std::vector<BallCavity> ball_cavities(const BallSet& balls, const Rational& probe) {
  const geometry::IeeeDoubles ieee;
  if (probe < 0) throw std::invalid_argument("a probe is not 0 or more: " + to_text(probe));
  return Components(balls, probe).run();
}

}  // namespace flowcert
