// Pockets as rows of CSV (RFC 4180), for spreadsheets and data frames.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "flowcert/sphere.h"
#include "geometry/difference_of_roots.h"
#include "geometry/floating_point.h"
#include "io/layer.h"
#include "io/write_pockets.h"

namespace flowcert {

using namespace io;

namespace {

std::string csv_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::string csv_text(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

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
    return !what.probe || what.pockets.squared_distances().is_at_least(record, what.probe->squared_radius());
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

}  // namespace flowcert
