#include "cli/pockets_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cli/automatic_threshold.h"
#include "cli/fixed_decimals.h"
#include "cli/table.h"
#include "flowcert/sphere.h"
#include "geometry/difference_of_roots.h"
#include "io/pocket_persistence.h"
#include "morse/saddle_radii.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kShownPockets = 20, kShownMouths = 5;
// Of the example: a carbon atom, and water.
constexpr double kAtomRadius = 1.7, kWaterRadius = 1.4;

// The deepest come first; of equal depths, the first in the list.
std::vector<std::size_t> by_depth(const Pockets& pockets) {
  std::vector<morse::PairEnds> ends;
  ends.reserve(pockets.size());
  for (std::size_t number = 0; number < pockets.size(); ++number) {
    ends.push_back({pockets[number].highest_mouth, pockets[number].peaks.front()});
  }
  const morse::ValueOrder order = morse::length_order(pockets.squared_distances(), ends);
  std::vector<std::size_t> numbers;
  for (std::size_t k = order.size(); k > 0; --k) numbers.push_back(order.at(k - 1));
  return numbers;
}

class Report {
 public:
  explicit Report(const PocketsReport& report)
      : report_(report),
        complex_(report.what.complex),
        pockets_(report.what.pockets),
        probe_(report.what.probe),
        atoms_(report.what.atoms),
        spacing_(morse::squared_spacing(complex_)),
        decimals_(spacing_),
        order_(by_depth(pockets_)) {
    if (!report.shows_all && order_.size() > kShownPockets) order_.resize(kShownPockets);
  }

  void print() const {
    print_input(report_.input);
    print_what_distances_mean();
    print_counts();
    if (pockets_.size() == 0) return print_that_there_is_none();
    print_pockets();
    print_mouths();
    if (atoms_ != nullptr) print_lining();
  }

 private:
  // ---- What the numbers mean ----

  void print_what_distances_mean() const {
    if (atoms_ == nullptr) {
      print_wrapped(
          "Distances are measured to the points, which have no radii; of atoms, to their centres. A volume is that of "
          "a "
          "pocket's cell, up to the points.");
    } else {
      print_wrapped(fmt::format(
          "Distances are measured to the centres of atoms, which have no radii here: water, a ball of radius {:.1f}, "
          "keeps {:.1f} from the centre of an atom of radius {:.1f}, so --probe {:.1f} asks for water. A volume is "
          "that "
          "of a pocket's cell up to the centres of atoms, not of solvent.",
          kWaterRadius, kWaterRadius + kAtomRadius, kAtomRadius, kWaterRadius + kAtomRadius));
    }
  }

  void print_probe() const {
    const double radius = nearest_or_infinity(probe_->radius);
    std::string remark = atoms_ == nullptr ? "its distance to all points" : "its distance to all centres of atoms";
    if (atoms_ != nullptr && radius > kAtomRadius) {
      remark += fmt::format("; with atoms of radius {:.1f}, a ball of radius {}", kAtomRadius,
                            decimals_.length(radius - kAtomRadius));
    }
    if (atoms_ != nullptr && radius <= kAtomRadius) {
      remark += fmt::format("; no more than the radius of an atom: water needs {:.1f}", kWaterRadius + kAtomRadius);
    }
    print_row("probe", fmt::format("{}", radius), remark);
    std::array<std::size_t, 3> counts{};
    for (std::size_t number = 0; number < pockets_.size(); ++number) {
      ++counts.at(static_cast<std::size_t>(pockets_.passage(pockets_[number], probe_->squared_radius())));
    }
    print_row("cavities for the probe", with_commas(counts[0]), "of which no way to infinity is so wide");
    print_row("pockets for the probe", with_commas(counts[1]), "of which one mouth is so wide");
    print_row("channels for the probe", with_commas(counts[2]), "of which several mouths are so wide");
  }

  // ---- Counts ----

  [[nodiscard]] std::string merging_text() const {
    if (pockets_.squared_persistence() == 0) return "one for each maximum";
    const std::string depth =
        decimals_.length(geometry::nearest_difference_of_roots(pockets_.squared_persistence(), 0));
    if (!report_.automatic || report_.automatic->valley) return "deeper than " + depth;
    return fmt::format("deeper than {}: {} of the spacing", depth, to_text(kShallowInSpacings));
  }

  void print_counts() const {
    print_point_counts(report_.input.points);
    print_row("maxima", with_commas(complex_.stationary().critical_counts()[3]));
    if (report_.automatic) print_automatic("lengths", *report_.automatic, "a fixed depth is taken");
    print_row("pockets", with_commas(pockets_.size()), merging_text());
    if (!pockets_.outside().empty()) {
      print_row("maxima at the outside", with_commas(pockets_.outside().size()),
                "too shallow; --persistence 0 tells them");
    }
    if (probe_) print_probe();
    if (const auto widest = pockets_.widest_path()) {
      const std::uint32_t gate = widest->gates.front();
      print_row("pore limiting radius", radius(gate),
                fmt::format("the widest way out of a pocket: from number {} through {}", pocket_of_gate(gate),
                            decimals_.position(center(gate))));
      const std::uint32_t ball = pockets_.largest_balls().front();
      print_row("largest cavity radius", radius(ball),
                fmt::format("the largest ball in a pocket, around {}", decimals_.position(center(ball))));
    }
    print_row("Delaunay triangulation", seconds_text(report_.delaunay_seconds));
    print_row("pockets after it", seconds_text(report_.other_seconds),
              report_.input.points.size() >= 4 && report_.delaunay_seconds > 0
                  ? fmt::format("{:.2f} x the triangulation", report_.other_seconds / report_.delaunay_seconds)
                  : "");
  }

  // The deepest pocket whose widest path has this gate.
  [[nodiscard]] std::size_t pocket_of_gate(std::uint32_t gate) const {
    for (const std::size_t number : by_depth(pockets_)) {
      if (std::ranges::binary_search(pockets_[number].to_infinity.gates, gate)) return number;
    }
    return 0;
  }

  void print_that_there_is_none() const {
    const Persistence& persistence = complex_.persistence();
    std::vector<morse::PairEnds> tunnels;
    for (const PersistencePair& pair : persistence.pairs()) {
      if (pair.dimension == 1) tunnels.push_back({pair.birth, pair.death.value()});
    }
    std::string longest = "There is none";
    if (!tunnels.empty()) {
      const morse::ValueOrder order = morse::length_order(persistence.squared_distances(), tunnels);
      const auto [death, birth] = order.exact(order.size() - 1);
      const auto text = [this](const Rational& square, const Rational& less) {
        return decimals_.length(geometry::nearest_difference_of_roots(square, less));
      };
      longest = fmt::format("The longest one has the length {}, from {} to {}, where a ball fills its narrowest place",
                            text(death, birth), text(birth, 0), text(death, 0));
    }
    fmt::print("\n");
    print_wrapped(
        fmt::format("no pocket; an open tunnel is a pair of dimension 1: see flowcert persistence. {}.", longest));
    if (atoms_ != nullptr) {
      print_wrapped("What is in a pocket fills it: water and ligands are atoms, too; --atoms protein leaves them out.");
    }
  }

  // ---- Tables ----

  void print_pockets() const {
    print_wrapped(fmt::format("\n{}", order_.size() == pockets_.size()
                                          ? "all pockets, from the deepest one"
                                          : fmt::format("the {} deepest pockets of {}", with_commas(order_.size()),
                                                        with_commas(pockets_.size()))),
                  2);
    print_wrapped(
        "  radius: of the largest ball in it; depth: how much wider that is than the widest mouth; widest: the "
        "narrowest place of the widest way out",
        2);
    Table table(probe_ ? "rrrrrrrrl" : "rrrrrrrrr", {"pocket", "x", "y", "z", "radius", "depth", "volume",
                                                     probe_ ? "widest" : "mouths", probe_ ? "probe" : "widest"});
    for (const std::size_t number : order_) {
      const Pocket& pocket = pockets_[number];
      const Point at = center(pocket.peaks.front());
      table.row(std::to_string(number));
      for (const double x : {at.x, at.y, at.z}) table.cell(decimals_.length(x));
      table.cell(radius(pocket.peaks.front()));
      table.cell(decimals_.length(pockets_.depth(pocket)));
      table.cell(decimals_.volume(complex_.volumes().nearest_sum(pocket.cell)));
      if (!probe_) table.cell(pocket.mouths.size());
      table.cell(radius(pocket.to_infinity.gates.front()));
      if (probe_) table.cell(passage_text(pockets_.passage(pocket, probe_->squared_radius())));
    }
    table.print();
  }

  // From the widest down.
  [[nodiscard]] std::vector<std::uint32_t> wide_mouths(const Pocket& pocket) const {
    std::vector<std::uint32_t> mouths;
    for (const std::uint32_t mouth : pocket.mouths) {
      if (probe_ && pockets_.squared_distances().compare(mouth, probe_->squared_radius()) >= 0) mouths.push_back(mouth);
    }
    std::ranges::stable_sort(mouths, std::ranges::greater{},
                             [this](std::uint32_t mouth) { return pockets_.squared_distances().rank(mouth); });
    return mouths;
  }

  void print_mouths() const {
    print_wrapped(probe_ ? "\ntheir mouths that are wide enough for the probe, from the widest down; how many of these "
                           "there are, and how many are narrower"
                         : "\ntheir widest mouths, and how many others there are",
                  2);
    Table table = probe_ ? Table("rrrrrlrrl", {"pocket", "x", "y", "z", "radius", "to", "wide", "narrower"})
                         : Table("rrrrrlrl", {"pocket", "x", "y", "z", "radius", "to", "others"});
    table.cell(atoms_ != nullptr ? "atoms" : "");
    for (const std::size_t number : order_) add_mouths(table, number);
    table.print();
  }

  // With a probe those that are wide enough, at most a few; otherwise the widest. The counts stand in the first row.
  void add_mouths(Table& table, std::size_t number) const {
    const Pocket& pocket = pockets_[number];
    const std::vector<std::uint32_t> wide = wide_mouths(pocket);
    std::vector<std::uint32_t> told = probe_ ? wide : std::vector{pocket.highest_mouth};
    if (!report_.shows_all && told.size() > kShownMouths) told.resize(kShownMouths);
    const auto add_counts = [&](bool is_first) {
      if (probe_) table.cell(is_first ? std::to_string(wide.size()) : "");
      table.cell(is_first ? std::to_string(pocket.mouths.size() - (probe_ ? wide.size() : 1)) : "");
    };
    if (told.empty()) {
      table.row(std::to_string(number));
      for (const char* text : {"", "", "", "", "none"}) table.cell(text);
      add_counts(true);
    }
    for (const std::uint32_t mouth : told) {
      const Point at = center(mouth);
      table.row(std::to_string(number));
      for (const double x : {at.x, at.y, at.z}) table.cell(decimals_.length(x));
      table.cell(radius(mouth)).cell(to_text_of(mouth, number));
      add_counts(mouth == told.front());
      if (atoms_ != nullptr) table.cell(atom_texts(mouth));
    }
  }

  // "the outside, 3": what is beyond the mouth of a pocket.
  [[nodiscard]] std::string to_text_of(std::uint32_t mouth, std::size_t pocket) const {
    std::vector<std::string> beyond;
    for (const std::uint32_t number : pockets_.above(mouth)) {
      if (number != pocket) beyond.push_back(number == pockets_.size() ? "outside" : std::to_string(number));
    }
    return fmt::format("{}", fmt::join(beyond, ", "));
  }

  [[nodiscard]] std::string atom_texts(std::uint32_t record) const {
    std::vector<std::string> texts;
    for (const PointId row : complex_.stationary().contact(record)) texts.push_back(unbroken(atoms_->text(row)));
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  void print_lining() const {
    print_wrapped("\nthe atoms nearest to some place in them, and their residues", 2);
    Table table("rrl", {"pocket", "atoms", "residues"});
    for (const std::size_t number : order_) {
      const std::vector<PointId> lining = Pockets::lining(pockets_[number], complex_.volumes());
      table.row(std::to_string(number)).cell(lining.size());
      std::vector<std::string> residues = atoms_->residue_texts(lining);
      for (std::string& residue : residues) residue = unbroken(std::move(residue));
      table.cell(fmt::format("{}", fmt::join(residues, ", ")));
    }
    table.print();
  }

  [[nodiscard]] Point center(std::uint32_t record) const { return complex_.rounded_sphere(record).center; }
  [[nodiscard]] std::string radius(std::uint32_t record) const {
    return decimals_.length(geometry::nearest_difference_of_roots(pockets_.squared_distances().exact(record), 0));
  }

  const PocketsReport& report_;
  const FlowComplex& complex_;
  const Pockets& pockets_;
  const std::optional<Probe>& probe_;
  const AtomNames* atoms_;
  std::optional<Rational> spacing_;
  FixedDecimals decimals_;
  std::vector<std::size_t> order_;  // the pockets that are shown
};

}  // namespace

void print_pockets_report(const PocketsReport& report) { Report(report).print(); }

}  // namespace flowcert::cli
