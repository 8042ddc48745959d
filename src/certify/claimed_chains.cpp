#include "certify/claimed_chains.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "certify/boundaries.h"
#include "certify/claimed_geometry.h"
#include "certify/closed_triangles.h"
#include "certify/finding_words.h"
#include "certify/layer.h"
#include "certify/truth.h"
#include "flowcert/voids.h"
#include "geometry/enclosing_ball.h"
#include "geometry/rational_point.h"
#include "morse/part_with.h"
#include "morse/record_finder.h"
#include "morse/toggle.h"

namespace flowcert::certify {

namespace {

using Records = std::vector<std::uint32_t>;
// A contact set as claimed, or all of them.
using Contact = std::vector<PointId>;
using Contacts = std::vector<Contact>;

std::optional<Records> records_of(const FlowComplex& complex, const Contacts& contacts, StationaryIndex index) {
  const RecordFinder finder(complex.stationary());
  Records records;
  for (const Contact& contact : contacts) {
    const auto record = finder.find(index, class_names(complex.points(), contact));
    if (!record) return std::nullopt;
    records.push_back(static_cast<std::uint32_t>(*record));
  }
  std::ranges::sort(records);
  return records;
}

// ---- Triangles ----

// The edges that an odd number of triangles has, by names of samples.
std::set<SampleEdge> boundary_of(const PointSet& points, const std::vector<SampleTriangle>& triangles) {
  std::set<SampleEdge> odd;
  for (const SampleTriangle& triangle : triangles) {
    const Contact names = class_names(points, triangle);
    if (names.size() < 3) continue;
    toggle(odd, {names[0], names[1]});
    toggle(odd, {names[0], names[2]});
    toggle(odd, {names[1], names[2]});
  }
  return odd;
}

// The first one that is not in {d^2 <= level} by its smallest ball, in words.
std::optional<std::string> too_large(const PointSet& points, const std::vector<SampleTriangle>& triangles,
                                     const Rational& level) {
  for (const SampleTriangle& triangle : triangles) {
    const std::array<Point, 3> corners{points.at_row(triangle[0]), points.at_row(triangle[1]),
                                       points.at_row(triangle[2])};
    const RationalPoint center = enclosing_ball_center(corners);
    Rational value = 0;
    for (const Point& corner : corners) value = std::max(value, Rational(squared_distance(center, corner)));
    if (value > level) {
      return fmt::format("the smallest ball around {} has the squared radius {}, which is more than {}",
                         names_text(triangle), number_text(value), number_text(level));
    }
  }
  return std::nullopt;
}

// ---- Loops ----

class LoopJudge final : public ChainJudge {
 public:
  explicit LoopJudge(const FlowComplex& complex)
      : complex_(complex), values_(complex.persistence().squared_distances()), classes_(complex) {}

  JudgedChain of(const ClaimedCycle& cycle, const PersistencePair& pair, const SquaredLevel& level) override {
    const std::set<SampleEdge> edges = odd_edges(complex_.points(), cycle.edges);
    if (cycle.polygons && edges != odd_edges(complex_.points(), *cycle.polygons)) {
      return {"malformed", "its polygons have other edges", {}, {}};
    }
    LoopClass found = classes_.of(cycle.edges, pair, level);
    if (found.fault != LoopFault::kNone) return {reason_text(found.fault), truth_of(found, pair, level), {}, {}};
    if (cycle.triangles) {
      if (boundary_of(complex_.points(), *cycle.triangles) != edges) {
        return {"surface-boundary", "the triangles have another boundary", {}, {}};
      }
      if (const auto found_large = too_large(complex_.points(), *cycle.triangles, values_.exact(*pair.death))) {
        return {"triangle-too-large", *found_large, {}, {}};
      }
    }
    if (cycle.saddles) {
      if (const std::string fault = surface_fault(*cycle.saddles, cycle.edges, pair); !fault.empty()) {
        return {"surface-boundary", fault, {}, {}};
      }
    }
    return {"", "", std::move(found.dying), std::move(found.born)};
  }

 private:
  [[nodiscard]] std::string truth_of(const LoopClass& found, const PersistencePair& pair,
                                     const SquaredLevel& level) const {
    const auto value = [&](std::uint32_t record) { return number_text(values_.exact(record)); };
    switch (found.fault) {
      case LoopFault::kNotACycle:
        return "a sample is an end of an odd number of its edges";
      case LoopFault::kEdgeTooLong: {
        const RationalPoint p = exact_position(complex_.points().at_row((*found.edge)[0]));
        const Rational squared = squared_distance(p, complex_.points().at_row((*found.edge)[1])) / 4;
        return fmt::format("half the length of edge {} has the square {}, which is more than {}",
                           names_text(*found.edge), number_text(squared), number_text(level.exact()));
      }
      case LoopFault::kDiesLater:
        return fmt::format("it bounds at {} and not before", value(*found.death));
      case LoopFault::kDiesEarlier:
        return found.death ? fmt::format("it bounds at {} already", value(*found.death)) : "it bounds at its level";
      default:
        return fmt::format("with what bounds before {}, it is born before {}", value(*pair.death), value(pair.birth));
    }
  }

  // The boundaries of the points, and where a tie below leaves one open, a cycle that bounds before the point.
  std::string surface_fault(const Contacts& saddles, const std::vector<SampleEdge>& edges,
                            const PersistencePair& pair) {
    const auto records = records_of(complex_, saddles, {2, 2});
    if (!records) return "not all points of the surface are critical of index 2";
    const StationaryPoints& stationary = complex_.stationary();
    const std::size_t first = stationary.critical_counts()[0] + stationary.critical_counts()[1];
    std::set<std::uint32_t> difference;
    for (const std::uint32_t edge : classes_.as_index_1_points(edges)) toggle(difference, edge);
    for (const std::uint32_t saddle : *records) {
      if (values_.rank(saddle) > values_.rank(*pair.death)) return "a point of the surface is later than the death";
      for (const std::uint32_t edge : complex_.links().lower(saddle - first)) toggle(difference, edge);
    }
    if (difference.empty()) return "";
    if (!truth_) truth_ = fast_truth(complex_);
    std::optional<std::uint32_t> open;  // the rank of the latest one with a tie below
    for (const std::uint32_t saddle : *records) {
      if (has_tie(*truth_, saddle)) open = std::max(open.value_or(0), values_.rank(saddle));
    }
    const auto deaths = classes_.deaths_of(std::vector(difference.begin(), difference.end())).value();
    const bool is_by_ties =
        open && std::ranges::all_of(deaths, [&](std::uint32_t death) { return values_.rank(death) < *open; });
    return is_by_ties ? "" : "the boundaries of its points have another sum";
  }

  const FlowComplex& complex_;
  const SquaredDistances& values_;
  LoopClasses classes_;
  std::unique_ptr<Truth> truth_;  // made where a surface is wrong, or has ties
};

// ---- Voids ----

class VoidJudge final : public ChainJudge {
 public:
  explicit VoidJudge(const FlowComplex& complex)
      : complex_(complex),
        trees_(complex.merge_trees()),
        tree_(trees_.pockets()),
        values_(trees_.squared_distances()),
        parents_(tree_.parents()),
        voids_(trees_) {}

  JudgedChain of(const ClaimedCycle& cycle, const PersistencePair& pair, const SquaredLevel& level) override {
    std::optional<Records> maxima;
    if (cycle.maxima) {
      maxima = records_of(complex_, *cycle.maxima, {3, 3});
      if (!maxima) return wrong("not all of these are maxima");
    }
    if (cycle.triangles) {
      if (!boundary_of(complex_.points(), *cycle.triangles).empty()) {
        return {"not-a-cycle", "an edge belongs to an odd number of its triangles", {}, {}};
      }
      if (const auto found = too_large(complex_.points(), *cycle.triangles, level.exact())) {
        return {"triangle-too-large", *found, {}, {}};
      }
      Records inside = enclosed(*cycle.triangles, level);
      if (maxima && *maxima != inside) return wrong("its triangles enclose other maxima");
      maxima = std::move(inside);
    }
    if (!maxima || maxima->empty()) return wrong("it has no maximum");
    if (std::string fault = fault_of(*maxima, pair, level); !fault.empty()) return wrong(std::move(fault));
    if (cycle.cell || cycle.walls) {
      const Void space = voids_.at(maxima->front(), level);
      if (cycle.cell && !is_same(*cycle.cell, space.cell)) return wrong("its cell has other points");
      if (cycle.walls && !is_same(*cycle.walls, space.walls)) return wrong("it has other walls");
    }
    std::erase_if(*maxima, [&](std::uint32_t m) { return values_.rank(m) != values_.rank(*pair.death); });
    return {"", "", std::move(*maxima), {}};
  }

 private:
  static JudgedChain wrong(std::string truth) { return {"wrong-void", std::move(truth), {}, {}}; }

  [[nodiscard]] std::uint32_t part_above(std::uint32_t leaf, const SquaredLevel& level) const {
    return part_with(leaf, tree_, parents_,
                     [&](const MergeNode& node) { return values_.compare(node.points.front(), level) > 0; });
  }
  // The greatest rank of its maxima. Nothing is as high as infinity.
  [[nodiscard]] std::uint32_t height(std::uint32_t part) const {
    std::uint32_t greatest = 0;
    for (const std::uint32_t leaf : tree_.leaves_of(part)) {
      if (leaf == trees_.maxima()) return UINT32_MAX;
      greatest = std::max(greatest, values_.rank(trees_.record_of(leaf)));
    }
    return greatest;
  }

  // It has to be a part at the level, as high as the death, that comes at the birth to another part as high or higher.
  [[nodiscard]] std::string fault_of(const Records& maxima, const PersistencePair& pair,
                                     const SquaredLevel& level) const {
    const auto leaf = maxima.front() - static_cast<std::uint32_t>(trees_.record_of(0));
    const std::uint32_t part = part_above(leaf, level), top = values_.rank(*pair.death);
    if (height(part) == UINT32_MAX) return "its first maximum is in no void at this level";
    Records whole;
    for (const std::uint32_t other : tree_.leaves_of(part)) {
      whole.push_back(static_cast<std::uint32_t>(trees_.record_of(other)));
    }
    if (whole != maxima) {
      return fmt::format("at this level the void of its first maximum has {} of them, and not these {}", whole.size(),
                         maxima.size());
    }
    if (height(part) != top) return "its highest maximum has another value than the death";
    const std::uint32_t at_birth = part_above(leaf, SquaredLevel(values_, pair.birth, pair.birth, 0));
    const std::uint32_t next = parents_[at_birth];
    if (height(at_birth) != top || next == MergeTree::kNone) return "it has joined a higher void, or the outside";
    const MergeNode& node = tree_.nodes[next - tree_.leaves];
    const bool ends =
        values_.rank(node.points.front()) == values_.rank(pair.birth) &&
        std::ranges::any_of(node.parts, [&](std::uint32_t other) { return other != at_birth && height(other) >= top; });
    return ends ? "" : "it joins no void as high at the birth";
  }

  // The maxima in parts at the level that the triangles enclose. All of one part are on one side of them.
  [[nodiscard]] Records enclosed(const std::vector<SampleTriangle>& triangles, const SquaredLevel& level) const {
    std::vector<std::array<Point, 3>> corners;
    for (const SampleTriangle& t : triangles) {
      if (class_names(complex_.points(), t).size() < 3) continue;
      corners.push_back(
          {complex_.points().at_row(t[0]), complex_.points().at_row(t[1]), complex_.points().at_row(t[2])});
    }
    const ClosedTriangles around(std::move(corners));
    std::map<std::uint32_t, bool> is_inside;  // by part
    Records inside;
    for (std::uint32_t leaf = 0; leaf < trees_.maxima(); ++leaf) {
      const auto record = static_cast<std::uint32_t>(trees_.record_of(leaf));
      if (values_.compare(record, level) <= 0) continue;
      const auto [known, is_new] = is_inside.try_emplace(part_above(leaf, level), false);
      if (is_new) known->second = around.encloses(complex_.sphere(record).center);
      if (known->second) inside.push_back(record);
    }
    return inside;
  }

  [[nodiscard]] bool is_same(const Contacts& claimed, const Records& records) const {
    std::set<Contact> a, b;
    for (const Contact& contact : claimed) a.insert(class_names(complex_.points(), contact));
    for (const std::uint32_t record : records) {
      const auto contact = complex_.stationary().contact(record);
      b.emplace(contact.begin(), contact.end());
    }
    return a == b;
  }

  const FlowComplex& complex_;
  const MergeTrees& trees_;
  const MergeTree& tree_;
  const SquaredDistances& values_;
  std::vector<std::uint32_t> parents_;
  Voids voids_;
};

// ---- Components ----

class ComponentJudge final : public ChainJudge {
 public:
  explicit ComponentJudge(const FlowComplex& complex)
      : points_(complex.points()),
        tree_(complex.merge_trees().components()),
        values_(complex.merge_trees().squared_distances()),
        parents_(tree_.parents()) {}

  JudgedChain of(const ClaimedCycle& cycle, const PersistencePair& pair, const SquaredLevel&) override {
    if (cycle.components.size() != 2) return wrong("two components come together");
    Records parts;
    for (const std::vector<PointId>& component : cycle.components) {
      std::set<std::uint32_t> leaves;
      for (const PointId row : component) leaves.insert(static_cast<std::uint32_t>(points_.ordinal_of_row(row)));
      if (leaves.empty()) return wrong("a component has a sample");
      parts.push_back(part_with(*leaves.begin(), tree_, parents_, [&](const MergeNode& node) {
        return values_.rank(node.points.front()) < values_.rank(*pair.death);
      }));
      if (!std::ranges::equal(tree_.leaves_of(parts.back()), leaves)) {
        return wrong(
            fmt::format("before the death, the component of {} has other samples", points_.name(*leaves.begin())));
      }
    }
    std::ranges::sort(parts);
    const std::uint32_t next = parents_[parts[0]];
    const bool is_joined = parts[0] != parts[1] && next != MergeTree::kNone && next == parents_[parts[1]] &&
                           values_.rank(tree_.nodes[next - tree_.leaves].points.front()) == values_.rank(*pair.death);
    if (!is_joined) return wrong("they do not come together at the death");
    return {"", "", std::move(parts), {}};
  }

 private:
  static JudgedChain wrong(std::string truth) { return {"wrong-components", std::move(truth), {}, {}}; }

  const PointSet& points_;
  const MergeTree& tree_;
  const SquaredDistances& values_;
  std::vector<std::uint32_t> parents_;
};

}  // namespace

std::unique_ptr<ChainJudge> chain_judge(const FlowComplex& complex, int dimension) {
  if (dimension == 0) return std::make_unique<ComponentJudge>(complex);
  if (dimension == 1) return std::make_unique<LoopJudge>(complex);
  return std::make_unique<VoidJudge>(complex);
}

}  // namespace flowcert::certify
