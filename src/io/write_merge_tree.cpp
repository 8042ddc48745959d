// Trees can be as deep as they have leaves, so that text is made from a stack of our own.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/sphere.h"
#include "geometry/floating_point.h"
#include "io/json_fields.h"
#include "io/layer.h"
#include "io/write_pockets.h"

namespace flowcert {

using namespace io;

namespace {

class TreeText {
 public:
  TreeText(const FlowComplex& complex, TreeKind kind)
      : complex_(complex),
        trees_(complex.merge_trees()),
        kind_(kind),
        tree_(kind == TreeKind::kPockets ? trees_.pockets() : trees_.components()) {}

  void write_json(std::ostream& out) const {
    Json json = header_fields("flowcert-merge-tree", 1, complex_.points());
    add_counts(json, complex_.points(), complex_.stationary());
    json["of"] = kind_ == TreeKind::kPockets ? "pockets" : "components";
    json["leaves"] = Json::array();
    for (std::uint32_t leaf = 0; leaf < tree_.leaves; ++leaf) json["leaves"].push_back(leaf_field(leaf));
    json["nodes"] = Json::array();
    for (const MergeNode& node : tree_.nodes) {
      Json field;
      field["squared_distance"] = to_text(trees_.squared_distances().exact(node.points.front()));
      field["parts"] = node.parts;
      field["joined_by"] = Json::array();
      for (const std::uint32_t point : node.points) {
        field["joined_by"].push_back(complex_.stationary().contact(point));
      }
      json["nodes"].push_back(std::move(field));
    }
    out << json.dump() << '\n';
  }

  void write_newick(std::ostream& out) const {
    if (tree_.leaves > 0) write_part(out, static_cast<std::uint32_t>(tree_.leaves + tree_.nodes.size() - 1));
    out << ";\n";
  }

 private:
  [[nodiscard]] bool is_leaf(std::uint32_t part) const { return part < tree_.leaves; }
  [[nodiscard]] bool is_infinity(std::uint32_t part) const {
    return kind_ == TreeKind::kPockets && part + 1 == tree_.leaves;
  }
  // The stationary point that has the value of the part; not for infinity.
  [[nodiscard]] std::size_t record_of(std::uint32_t part) const {
    if (!is_leaf(part)) return tree_.nodes[part - tree_.leaves].points.front();
    return kind_ == TreeKind::kPockets ? trees_.record_of(part) : part;
  }

  [[nodiscard]] Json leaf_field(std::uint32_t leaf) const {
    Json json;
    if (is_infinity(leaf)) {
      json["contact"] = nullptr;
      json["squared_distance"] = nullptr;
      return json;
    }
    json["contact"] = complex_.stationary().contact(record_of(leaf));
    json["squared_distance"] = to_text(trees_.squared_distances().exact(record_of(leaf)));
    return json;
  }

  // "3-17-20": a contact set. Blanks, commas and brackets have a meaning in Newick.
  [[nodiscard]] std::string label(std::uint32_t part) const {
    if (is_infinity(part)) return "infinity";
    return fmt::format("{}", fmt::join(complex_.stationary().contact(record_of(part)), "-"));
  }

  [[nodiscard]] std::string length(std::uint32_t part, std::uint32_t parent) const {
    if (is_infinity(part)) return "";
    const Rational difference =
        trees_.squared_distances().exact(record_of(parent)) - trees_.squared_distances().exact(record_of(part));
    return fmt::format(":{}", nearest_or_infinity(abs(difference)));
  }

  void write_part(std::ostream& out, std::uint32_t root) const {
    struct Open {
      std::uint32_t part;
      std::size_t next;  // of its parts
    };
    std::vector<Open> open = {{root, 0}};
    while (!open.empty()) {
      auto& [part, next] = open.back();
      if (!is_leaf(part) && next < tree_.nodes[part - tree_.leaves].parts.size()) {
        out << (next == 0 ? "(" : ",");
        const std::uint32_t inner = tree_.nodes[part - tree_.leaves].parts[next++];
        open.push_back({inner, 0});
        continue;
      }
      out << (is_leaf(part) ? "" : ")") << label(part);
      const std::uint32_t done = part;
      open.pop_back();
      if (!open.empty()) out << length(done, open.back().part);
    }
  }

  const FlowComplex& complex_;
  const MergeTrees& trees_;
  TreeKind kind_;
  const MergeTree& tree_;
};

}  // namespace

void write_merge_tree(std::ostream& out, const FlowComplex& complex, TreeKind kind) {
  const geometry::IeeeDoubles ieee;
  TreeText(complex, kind).write_json(out);
}
void write_newick(std::ostream& out, const FlowComplex& complex, TreeKind kind) {
  const geometry::IeeeDoubles ieee;
  TreeText(complex, kind).write_newick(out);
}

}  // namespace flowcert
