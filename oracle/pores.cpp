// At each value of an index-2 point, from the greatest one down, components of {d > g} come together to those of
// {d >= g}. Which leaves are in one component is known from the ends of index-2 points alone (FC-BALL-09).
#include "oracle/pores.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

#include "oracle/pore_rooms.h"

namespace oracle {

namespace {

struct Component {
  Places members;  // all of its leaves, ascending
  Places peaks;    // the highest members; empty if the outside is one
};

class Tree {
 public:
  explicit Tree(const Pores& pores) : pores_(pores), components_(pores.points.size() + 1) {
    std::iota(components_.begin(), components_.end(), std::size_t{0});
    for (const std::vector<Link>& links : links_by_value(pores)) fall_to(links);
    for (const Component& last : components()) {
      if (!last.peaks.empty()) end(last, {}, true);
    }
    std::sort(cavities_.begin(), cavities_.end());
  }

  const std::vector<Chamber>& chambers() const { return chambers_; }
  const std::vector<Cavity>& cavities() const { return cavities_; }

 private:
  std::size_t outside() const { return pores_.points.size(); }
  const Quadratic& value(std::size_t point) const { return pores_.points[point].value; }

  std::vector<Component> components() const {
    std::map<std::size_t, Component> found;
    for (std::size_t member = 0; member <= outside(); ++member) {
      if (member == outside() || pores_.points[member].index == 3) {
        found[components_[member]].members.push_back(member);
      }
    }
    std::vector<Component> result;
    for (auto& [number, component] : found) {
      component.peaks = peaks(component.members);
      result.push_back(component);
    }
    return result;
  }

  // Points descend by value.
  Places peaks(const Places& members) const {
    if (members.back() == outside()) return {};
    Places highest;
    for (const std::size_t member : members) {
      if (value(member) == value(members[0])) highest.push_back(member);
    }
    return highest;
  }

  bool is_as_high(const Component& one, const Component& other) const {
    if (one.peaks.empty() || other.peaks.empty()) return one.peaks.empty();
    return value(one.peaks[0]) >= value(other.peaks[0]);
  }

  // The links are all of one value.
  void fall_to(const std::vector<Link>& links) {
    const Components before = components_;
    const std::vector<Component> parts = components();
    check_sides(links, before);
    for (const Link& link : links) join(components_, link.ends);
    std::map<std::size_t, std::vector<Component>> joins;  // by component after
    for (const Component& part : parts) joins[components_[part.members[0]]].push_back(part);
    for (const auto& [number, children] : joins) {
      if (children.size() > 1) end_children(children, links, before);
    }
    note_exits(links[0].point);
  }

  // All ends of one side are in one component of {d > d(w)}.
  void check_sides(const std::vector<Link>& links, const Components& before) const {
    for (const Link& link : links) {
      for (const Ends& side : pores_.ends[link.point]) {
        if (components_at(before, side).size() != 1) throw std::logic_error("ends of one side in two components");
      }
    }
  }

  // Children that are not the only highest one are chambers. Of the highest ones, one is no cavity.
  void end_children(const std::vector<Component>& children, const std::vector<Link>& links, const Components& before) {
    bool has_highest = false;
    for (const Component& child : children) {
      const auto as_high = std::count_if(children.begin(), children.end(),
                                         [&](const Component& other) { return is_as_high(other, child); });
      const bool is_highest = std::all_of(children.begin(), children.end(),
                                          [&](const Component& other) { return is_as_high(child, other); });
      const bool is_left_out = is_highest && !has_highest;
      has_highest |= is_highest;
      if (as_high == 1) continue;  // the child alone
      end(child, gates(child, links, before), !is_left_out);
    }
  }

  static Places gates(const Component& child, const std::vector<Link>& links, const Components& before) {
    Places points;
    for (const Link& link : links) {
      const Places at = components_at(before, link.ends);
      const bool is_at_child = std::find(at.begin(), at.end(), before[child.members[0]]) != at.end();
      if (is_at_child && at.size() > 1) points.push_back(link.point);
    }
    return points;
  }

  void end(const Component& component, const Places& gates, bool is_cavity) {
    chambers_.push_back({component.peaks, gates, std::nullopt, {}, {}});
    if (!is_cavity) return;
    cavities_.push_back({gates.empty() ? std::nullopt : std::optional(value(gates[0])), value(component.peaks[0])});
  }

  // Chambers that have come to the outside at this value get their exit.
  void note_exits(std::size_t point) {
    for (Chamber& chamber : chambers_) {
      if (!chamber.exit && components_[chamber.peaks[0]] == components_[outside()]) chamber.exit = value(point);
    }
  }

  const Pores& pores_;
  Components components_;
  std::vector<Chamber> chambers_;
  std::vector<Cavity> cavities_;
};

std::vector<Chamber> of_depth(const Pores& pores, const std::vector<Chamber>& all, const Rational& depth) {
  std::vector<Chamber> deep;
  std::map<Places, double> depth_of;  // by peaks
  for (const Chamber& chamber : all) {
    const Quadratic& peak = pores.points[chamber.peaks[0]].value;
    const Quadratic gate = chamber.gates.empty() ? Quadratic() : pores.points[chamber.gates[0]].value;
    if (peak < gate + depth) continue;
    depth_of[chamber.peaks] = nearest_difference(peak, gate);
    deep.push_back(chamber);
  }
  std::sort(deep.begin(), deep.end(), [&](const Chamber& one, const Chamber& other) {
    const double depth_of_one = depth_of[one.peaks], depth_of_other = depth_of[other.peaks];
    return depth_of_one != depth_of_other ? depth_of_one > depth_of_other : one.peaks < other.peaks;
  });
  return deep;
}

}  // namespace

void join(Components& components, const Ends& ends) {
  for (const std::size_t end : ends) {
    std::replace(components.begin(), components.end(), std::size_t{components[end]},
                 std::size_t{components[*ends.begin()]});
  }
}

Places components_at(const Components& components, const Ends& ends) {
  std::set<std::size_t> found;
  for (const std::size_t end : ends) found.insert(components[end]);
  return {found.begin(), found.end()};
}

std::vector<std::vector<Link>> links_by_value(const Pores& pores) {
  std::vector<std::vector<Link>> values;
  for (std::size_t point = 0; point < pores.points.size(); ++point) {
    if (pores.points[point].index != 2) continue;
    Link link{point, pores.ends[point][0]};
    link.ends.insert(pores.ends[point][1].begin(), pores.ends[point][1].end());
    const bool is_new = values.empty() || pores.points[values.back()[0].point].value != pores.points[point].value;
    if (is_new) values.push_back({});
    values.back().push_back(link);
  }
  return values;
}

Pores pores(const std::vector<Ball>& balls, const Rational& depth) {
  return pores(balls, critical_points(balls), depth);
}

Pores pores(const std::vector<Ball>& balls, const std::vector<BallPoint>& points, const Rational& depth) {
  Pores result;
  result.points = points;
  for (const BallPoint& point : result.points) {
    result.ends.push_back(point.index == 2 ? ends_of(balls, result.points, point) : std::array<Ends, 2>());
  }
  const Tree tree(result);
  result.chambers = of_depth(result, tree.chambers(), depth);
  result.cavities = tree.cavities();
  find_windows(result);
  return result;
}

}  // namespace oracle
