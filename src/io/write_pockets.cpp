#include "io/write_pockets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flowcert/sphere.h"
#include "flowcert/stable_manifolds.h"
#include "geometry/difference_of_roots.h"
#include "geometry/floating_point.h"
#include "io/csv_fields.h"
#include "io/json_fields.h"
#include "io/layer.h"

namespace flowcert {

using namespace io;

namespace {

Json atom_field(const AtomName& name) {
  return {{"chain", name.chain},
          {"residue", name.residue},
          {"number", name.number},
          {"atom", name.atom},
          {"element", name.element}};
}

class PocketFields {
 public:
  explicit PocketFields(const PocketsToWrite& what)
      : what_(what), complex_(what.complex), stationary_(what.complex.stationary()) {
    const auto& counts = stationary_.critical_counts();
    first_saddle_ = counts[0] + counts[1];
  }

  [[nodiscard]] Json pocket(const Pocket& pocket) const {
    Json json;
    json["peaks"] = Json::array();
    for (const std::uint32_t peak : pocket.peaks) json["peaks"].push_back(ball(peak));
    json["maxima"] = contacts(pocket.maxima);
    json["depth"] = double_field(what_.pockets.depth(pocket));
    json["difference_of_squares"] = to_text(what_.pockets.difference_of_squares(pocket));
    json["volume"] = what_.has_exact_volumes ? Json(to_text(complex_.volumes().exact_sum(pocket.cell)))
                                             : double_field(complex_.volumes().nearest_sum(pocket.cell));
    json["cell"] = Json::array();
    for (const std::uint32_t record : pocket.cell) json["cell"].push_back(stationary_point(record));
    json["mouths"] = Json::array();
    for (const std::uint32_t mouth : pocket.mouths) json["mouths"].push_back(mouth_field(mouth));
    add_lining(json, Pockets::lining(pocket, complex_.volumes()));
    json["neighbours"] = neighbours(pocket.neighbours);
    json["widest_path"] = path(pocket.to_infinity);
    if (what_.probe) json["is"] = passage_text(what_.pockets.passage(pocket, what_.probe->squared_radius()));
    return json;
  }

  [[nodiscard]] Json contacts(const std::vector<std::uint32_t>& records) const {
    Json all = Json::array();
    for (const std::uint32_t record : records) all.push_back(stationary_.contact(record));
    return all;
  }

  [[nodiscard]] Json pore_limiting_radius() const {
    const std::optional<WidestPath> widest = what_.pockets.widest_path();
    return widest ? path(*widest) : Json(nullptr);
  }

  [[nodiscard]] Json largest_cavity_radius() const {
    const std::vector<std::uint32_t> largest = what_.pockets.largest_balls();
    if (largest.empty()) return nullptr;
    Json json = radii(largest.front());
    json["balls"] = Json::array();
    for (const std::uint32_t record : largest) json["balls"].push_back(witness(record));
    return json;
  }

 private:
  void add_lining(Json& json, const std::vector<PointId>& lining) const {
    json["lining"] = lining;
    if (what_.atoms == nullptr) return;
    json["atoms"] = Json::array();
    for (const PointId row : lining) json["atoms"].push_back(atom_field((*what_.atoms)[row]));
    json["residues"] = what_.atoms->residue_texts(lining);
  }
  [[nodiscard]] Json radii(std::uint32_t record) const {
    const Rational squared_radius = what_.pockets.squared_distances().exact(record);
    Json json;
    json["squared_radius"] = to_text(squared_radius);
    json["radius"] = double_field(geometry::nearest_difference_of_roots(squared_radius, 0));
    return json;
  }
  [[nodiscard]] Json witness(std::uint32_t record) const {
    Json json;
    json["contact"] = stationary_.contact(record);
    json["center"] = center_field(complex_.sphere(record).center);
    return json;
  }
  [[nodiscard]] Json ball(std::uint32_t record) const {
    Json json = witness(record);
    json.update(radii(record));
    return json;
  }
  [[nodiscard]] Json stationary_point(std::uint32_t record) const {
    Json json;
    json["index"] = index_field(stationary_.index(record));
    json["contact"] = stationary_.contact(record);
    return json;
  }
  [[nodiscard]] Json mouth_field(std::uint32_t record) const {
    Json json;
    json["contact"] = stationary_.contact(record);
    json.update(radii(record));
    json["area"] = double_field(surface_area(complex_.points(), complex_.stable(), record - first_saddle_));
    json["between"] = neighbours(what_.pockets.above(record));
    return json;
  }
  // Pockets by number; the outside is -1.
  [[nodiscard]] Json neighbours(const std::vector<std::uint32_t>& numbers) const {
    Json json = Json::array();
    for (const std::uint32_t number : numbers) {
      json.push_back(number == what_.pockets.size() ? -1 : static_cast<std::int64_t>(number));
    }
    return json;
  }
  [[nodiscard]] Json path(const WidestPath& widest) const {
    Json json = radii(widest.gates.front());
    json["gates"] = Json::array();
    for (const std::uint32_t gate : widest.gates) json["gates"].push_back(witness(gate));
    return json;
  }

  const PocketsToWrite& what_;
  const FlowComplex& complex_;
  const StationaryPoints& stationary_;
  std::size_t first_saddle_ = 0;
};

}  // namespace

void write_pockets(std::ostream& out, const PocketsToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const PocketFields fields(what);
  Json json = header_fields("flowcert-pockets", 2, what.complex.points());
  add_counts(json, what.complex.points(), what.complex.stationary());
  json["squared_persistence"] = to_text(what.pockets.squared_persistence());
  json["probe"] = what.probe ? Json(to_text(what.probe->radius)) : Json(nullptr);
  json["volumes"] = what.has_exact_volumes ? "exact" : "double";
  json["pore_limiting_radius"] = fields.pore_limiting_radius();
  json["largest_cavity_radius"] = fields.largest_cavity_radius();
  json["outside"] = fields.contacts(what.pockets.outside());
  // The pockets come last, and are written as they are made.
  json["pockets"] = Json::array();
  std::string text = json.dump();
  text.resize(text.size() - 2);
  out << text;
  for (std::size_t number = 0; number < what.pockets.size(); ++number) {
    out << (number > 0 ? "," : "") << fields.pocket(what.pockets[number]).dump();
  }
  out << "]}\n";
}

// ---- Tables ----
namespace {

std::string position_text(const Point& p) {
  return fmt::format("{},{},{}", csv_number(p.x), csv_number(p.y), csv_number(p.z));
}

// The residues in one field, with semicolons.
std::string residues_text(const AtomNames& atoms, const std::vector<PointId>& lining) {
  std::string text;
  for (const std::string& residue : atoms.residue_texts(lining)) text += (text.empty() ? "" : "; ") + residue;
  return text;
}

}  // namespace

void write_pocket_csv(std::ostream& out, const PocketsToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const auto radius = [&](std::uint32_t record) {
    return csv_number(geometry::nearest_difference_of_roots(what.pockets.squared_distances().exact(record), 0));
  };
  const auto is_open = [&](std::uint32_t record) {
    return !what.probe || what.pockets.squared_distances().compare(record, what.probe->squared_radius()) >= 0;
  };
  out << "pocket,x,y,z,radius,depth,volume,maxima,mouths,widest,lining" << (what.probe ? ",open_mouths,kind" : "")
      << (what.atoms != nullptr ? ",residues" : "") << '\n';
  for (std::size_t number = 0; number < what.pockets.size(); ++number) {
    const Pocket& pocket = what.pockets[number];
    const std::vector<PointId> lining = Pockets::lining(pocket, what.complex.volumes());
    out << fmt::format("{},{},{},{},{},{},{},{},{}", number,
                       position_text(what.complex.rounded_sphere(pocket.peaks.front()).center),
                       radius(pocket.peaks.front()), csv_number(what.pockets.depth(pocket)),
                       csv_number(what.complex.volumes().nearest_sum(pocket.cell)), pocket.maxima.size(),
                       pocket.mouths.size(), radius(pocket.to_infinity.gates.front()), lining.size());
    if (what.probe) {
      out << fmt::format(",{},{}", std::ranges::count_if(pocket.mouths, is_open),
                         passage_text(what.pockets.passage(pocket, what.probe->squared_radius())));
    }
    if (what.atoms != nullptr) out << ',' << csv_text(residues_text(*what.atoms, lining));
    out << '\n';
  }
}

void write_lining_csv(std::ostream& out, const PocketsToWrite& what) {
  const geometry::IeeeDoubles ieee;
  if (what.atoms == nullptr) throw std::invalid_argument("the points have no names of atoms");
  out << "pocket,row,chain,residue,number,atom,element,x,y,z\n";
  for (std::size_t number = 0; number < what.pockets.size(); ++number) {
    for (const PointId row : Pockets::lining(what.pockets[number], what.complex.volumes())) {
      const AtomName name = (*what.atoms)[row];
      const PointSet& points = what.complex.points();
      out << fmt::format("{},{},{},{},{},{},{},{}\n", number, row, csv_text(name.chain), csv_text(name.residue),
                         csv_text(name.number), csv_text(name.atom), csv_text(name.element),
                         position_text(points.at_row(row)));
    }
  }
}

// ---- Merge trees ----
// Trees can be as deep as they have leaves, so that text is made from a stack of our own.

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
