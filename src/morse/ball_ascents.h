// Where a growing probe comes to from an index-2 point: the ends of the point (spec clause FC-BALL-09).
//
// Guarantees: exact, and the same whichever triangulation the diagram has. The way follows the edges of the power
// diagrams: along the edge through the index-2 point to its end, and from there with a vertex of the diagram, as the
// probe grows, to where that touches nothing less. It never leaves {d > d(w)}.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "morse/ball_critical_points.h"

namespace flowcert::morse {

// Numbers of index-3 points, ascending, and kOutside last. There is more than one where a rule has a tie.
using BallEnds = std::vector<std::uint32_t>;
inline constexpr std::uint32_t kOutside = BallDiagram::kNone;

// Four balls whose centres span space: an edge of the diagram. Its two ends are the cells with the four.
struct BallEdge {
  std::array<std::uint32_t, 4> balls{};  // ascending
  std::array<std::uint32_t, 2> cells{BallDiagram::kNone, BallDiagram::kNone};
  std::array<std::uint32_t, 2> opposite{BallDiagram::kNone, BallDiagram::kNone};  // the cells' fifth balls
  std::optional<Touching<BoundedDouble>> near;
  mutable std::optional<Touching<Rational>> exact;  // made when it is asked for

  friend bool operator==(const BallEdge& x, const BallEdge& y) { return x.balls == y.balls; }
};

class BallAscents {
 public:
  // Both must outlive this.
  BallAscents(const BallDiagram& diagram, const std::vector<BallCriticalPoint>& points);

  // Of an index-2 point: on either side of the plane of its contacts.
  [[nodiscard]] std::array<BallEnds, 2> ends(const BallCriticalPoint& point);

 private:
  using Ids = std::vector<std::uint32_t>;
  using Three = std::array<std::uint32_t, 3>;  // (b-a) x (c-a) points to where a way goes
  // The end of an edge above a level: a cell, and where it is.
  struct End {
    std::uint32_t cell;
    BallLevel level;
  };
  struct Beyond {
    Three facet;
    BoundedDouble far, squared_size;  // how far a point is beyond the plane, times the normal's length; its square
  };
  enum class Side { kBelow, kAbove };

  BallEnds slide(const Three& facet, Ids plane, const Ids& contacts, const BallLevel& level, std::uint32_t cell);
  BallEnds rise(const Ids& contacts, const BallLevel& level);
  BallEnds rise_from_cell(std::uint32_t cell, const BallLevel& level);
  BallEnds rise_along(const std::vector<BallEdge>& above, const BallLevel& level);
  BallEnds follow(const BallEdge& edge, const BallLevel& level);
  BallEnds stop(const BallEdge& edge, const BallLevel& level);
  BallEnds stop_among(const Ids& contacts, const BallEdge& edge, const BallLevel& level);

  [[nodiscard]] std::uint32_t cell_with(const Three& facet) const;
  [[nodiscard]] std::optional<BallEdge> edge_ahead(const Three& facet, const BallLevel& level, std::uint32_t cell);
  [[nodiscard]] Ids first_hit(const Three& facet, const Ids& contacts, const BallLevel& level) const;
  [[nodiscard]] BallEdge edge_of(std::uint32_t cell, std::size_t corner) const;
  [[nodiscard]] std::vector<BallEdge> edges_among(const Ids& contacts) const;
  [[nodiscard]] bool is_in_space(const BallEdge& edge) const;
  [[nodiscard]] bool reaches(const BallEdge& edge, const BallLevel& level, Side side) const;
  [[nodiscard]] bool is_simple(std::uint32_t cell) const;
  [[nodiscard]] bool has_four_contacts(const BallEdge& edge, const BallLevel& level) const;
  [[nodiscard]] std::optional<End> end_above(const BallEdge& edge) const;
  [[nodiscard]] std::optional<BallLevel> zero_above(const BallEdge& edge, const BallLevel& level) const;
  [[nodiscard]] Ids contacts_at(const BallEdge& edge, const BallLevel& level) const;
  [[nodiscard]] std::vector<Three> hull(const BallEdge& edge, const Ids& contacts, const BallLevel& level) const;
  [[nodiscard]] std::vector<Beyond> farthest(const BallEdge& edge, const std::vector<Three>& facets,
                                             const BallLevel& level) const;
  [[nodiscard]] std::vector<BallEdge> steepest(const std::vector<BallEdge>& above, const BallLevel& level) const;
  [[nodiscard]] std::uint32_t peak(const BallEdge& edge, const Ids& contacts, const BallLevel& level) const;

  template <class Number>
  [[nodiscard]] const Touching<Number>& touching_of(const BallEdge& edge) const;
  template <class Number>
  [[nodiscard]] std::pair<Number, Number> lead_of(const BallEdge& edge, std::uint32_t id) const;
  template <class Linear>
  [[nodiscard]] int sign_at(const BallLevel& level, const Linear& linear) const;

  const BallDiagram& diagram_;
  const BallSet& balls_;
  std::map<Ids, std::uint32_t> peak_of_;
  std::map<std::pair<std::array<std::uint32_t, 4>, bool>, BallEnds> known_;  // by edge, and whether it ends in a zero
  // By more than four contacts: the edges to rise along; and where the probe touches them all at a level, the ends.
  std::map<Ids, std::vector<BallEdge>> rises_;
  std::map<Ids, std::vector<std::pair<BallLevel, BallEnds>>> stops_;
  mutable std::vector<std::int8_t> simple_;  // by cell: 1 where is_simple(), -1 where not, 0 where nobody asked
  mutable std::vector<std::uint32_t> seen_;  // by ball: the number of the last search that saw it
  mutable std::uint32_t searches_ = 0;
};

}  // namespace flowcert::morse
