// The components of {d >= s} are those of a graph: the vertices of the power diagram where the power is not negative,
// and the edges along which it never is. A ball lines those that have a vertex of its cell, if its power is 0 or less
// somewhere in the cell (theorem of FC-BALL-07). Where a cavity has a part of a cell, it has a vertex of it: power is
// convex.
#include "flowcert/ball_cavities.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "morse/ball_level.h"
#include "morse/ball_touching.h"
#include "voronoi/ball_slice.h"

namespace flowcert {

using namespace morse;

namespace {

using Ids = std::vector<std::uint32_t>;

// The balls of the diagram: the visible ones, and those that are tangent inside them, which can be as near at one
// place. More balls do not change d. Of equal ones the others are twins of the first.
struct Sites {
  explicit Sites(const BallSet& balls) : ids(balls.visible()) {
    std::map<RationalPoint, std::uint32_t> inside;  // the largest at each centre
    for (const std::uint32_t outer : balls.visible()) {
      for (const std::uint32_t id : balls.tangent_inside(outer)) {
        const Ball& ball = balls[id];
        if (ball.radius == balls[outer].radius) {
          twins[outer].push_back(id);
        } else if (const auto [at, is_new] = inside.try_emplace(ball.center, id); at->second != id) {
          const int sign = ball.radius.compare(balls[at->second].radius);
          if (sign > 0) at->second = id;
          if (sign == 0) twins[at->second].push_back(id);
        }
      }
    }
    for (const auto& [centre, id] : inside) ids.push_back(id);
  }

  Ids ids;
  std::map<std::uint32_t, Ids> twins;
};

class Components {
 public:
  Components(const BallSet& balls, const Rational& probe)
      : balls_(balls),
        s_(probe * balls.scale()),
        near_s_(bounded(s_)),
        sized_s_(near_s_.value),
        sites_(balls),
        slice_(balls, sites_.ids, probe),
        outside_(static_cast<std::uint32_t>(slice_.tetrahedra.size())),
        sets_(outside_ + 1) {}

  std::vector<BallCavity> run() {
    for (const BallSlice::Corners& tetrahedron : slice_.tetrahedra) signs_.push_back(power_sign(tetrahedron));
    for (std::uint32_t cell = 0; cell < outside_; ++cell) {
      if (signs_[cell] < 0) continue;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::uint32_t other = slice_.adjacent[cell][corner];
        if (other == BallSlice::kNone ? is_open(cell, corner)
                                      : other > cell && signs_[other] >= 0 && is_open(cell, corner)) {
          sets_.unite(cell, other == BallSlice::kNone ? outside_ : other);
        }
      }
    }
    for (std::uint32_t cell = 0; cell < outside_; ++cell) {
      if (is_in_cavity(cell)) cavities_[sets_.find(cell)];
    }
    if (!cavities_.empty()) add_linings();
    std::vector<BallCavity> made;
    for (auto& [root, cavity] : cavities_) {
      geometry::keep_unique(cavity.lining);
      made.push_back(std::move(cavity));
    }
    std::ranges::sort(made, {}, &BallCavity::lining);
    return made;
  }

 private:
  // ---- What lines a cavity ----

  [[nodiscard]] bool is_in_cavity(std::uint32_t cell) {
    return signs_[cell] >= 0 && sets_.find(cell) != sets_.find(outside_);
  }

  void add_linings() {
    std::map<std::uint32_t, Ids> stars;  // the tetrahedra around each ball
    for (std::uint32_t cell = 0; cell < outside_; ++cell) {
      for (const std::uint32_t id : slice_.tetrahedra[cell]) stars[id].push_back(cell);
    }
    for (const auto& [id, star] : stars) {
      std::set<std::uint32_t> roots;
      for (const std::uint32_t cell : star) {
        if (is_in_cavity(cell)) roots.insert(sets_.find(cell));
      }
      if (roots.empty() || !is_in_its_cell(id, star)) continue;
      for (const std::uint32_t root : roots) {
        Ids& lining = cavities_[root].lining;
        lining.push_back(id);
        if (const auto twins = sites_.twins.find(id); twins != sites_.twins.end()) {
          lining.insert(lining.end(), twins->second.begin(), twins->second.end());
        }
      }
    }
  }

  // Whether the power is 0 or less somewhere in a ball's cell. It is least at the foot of a simplex with the ball: the
  // point of these centres' plane that is equally far from their balls. That is in the cell iff no ball around is
  // nearer.
  [[nodiscard]] bool is_in_its_cell(std::uint32_t id, const Ids& star) const {
    if (std::ranges::any_of(star, [&](std::uint32_t cell) { return signs_[cell] <= 0; })) return true;
    std::set<std::uint32_t> around;
    std::set<Ids> simplices;
    for (const std::uint32_t cell : star) {
      const BallSlice::Corners& corners = slice_.tetrahedra[cell];
      around.insert(corners.begin(), corners.end());
      for (unsigned some = 1; some < 15; ++some) {
        Ids simplex;
        for (std::size_t k = 0; k < 4; ++k) {
          if ((some >> k & 1) != 0) simplex.push_back(corners[k]);
        }
        std::ranges::sort(simplex);
        if (std::ranges::binary_search(simplex, id)) simplices.insert(std::move(simplex));
      }
    }
    return std::ranges::any_of(simplices, [&](const Ids& simplex) {
      return power_sign(simplex) <= 0 && std::ranges::none_of(around, [&](std::uint32_t other) {
               return !std::ranges::binary_search(simplex, other) && lead_sign(simplex, other) < 0;
             });
    });
  }

  // ---- Signs ----

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

  // Also of a single ball, whose centre is the point.
  template <class Number>
  [[nodiscard]] std::optional<Touching<Number>> touching_some(std::span<const std::uint32_t> ids) const {
    if (ids.size() > 1) return touching<Number>(balls_, ids);
    Touching<Number> made{};
    add_power(made, ball_from<Number>(balls_, ids[0], ids[0]).radius);
    return made;
  }

  // Of the power of the point that is equally far from the balls of a simplex.
  [[nodiscard]] int power_sign(std::span<const std::uint32_t> ids) const {
    return sign_of([&]<class Number>() -> std::optional<Number> {
      const auto made = touching_some<Number>(ids);
      if (!made) return std::nullopt;
      const Number& s = level<Number>();
      return (made->c2 * s + Number(2) * made->c1) * s + made->c0;
    });
  }

  // Whether another ball is less near than those of a simplex at the point that is equally far from these.
  [[nodiscard]] int lead_sign(std::span<const std::uint32_t> simplex, std::uint32_t id) const {
    return sign_of([&]<class Number>() -> std::optional<Number> {
      const auto made = touching_some<Number>(simplex);
      if (!made) return std::nullopt;
      const auto [first, second] =
          lead(*made, ball_from<Number>(balls_, simplex[0], simplex[0]), ball_from<Number>(balls_, simplex[0], id));
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
  const Sites sites_;
  const BallSlice slice_;
  const std::uint32_t outside_;
  geometry::DisjointSets sets_;
  std::vector<int> signs_;                        // of the power at the vertex of each tetrahedron
  std::map<std::uint32_t, BallCavity> cavities_;  // by their roots among the sets
};

}  // namespace

std::vector<BallCavity> ball_cavities(const BallSet& balls, const Rational& probe) {
  const geometry::IeeeDoubles ieee;
  if (probe < 0) throw std::invalid_argument("a probe is not 0 or more: " + to_text(probe));
  return Components(balls, probe).run();
}

}  // namespace flowcert
