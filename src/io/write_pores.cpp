#include "io/write_pores.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "geometry/floating_point.h"
#include "io/csv_fields.h"
#include "io/json_fields.h"
#include "io/layer.h"
#include "io/number_text.h"

namespace flowcert {

using namespace io;

namespace {

Json number_field(const QuadraticNumber& number) {
  const PrimitivePolynomial polynomial = primitive_polynomial(number);
  Json json;
  json["polynomial"] = polynomial.coefficients;
  json["root"] = polynomial.root;
  json["double"] = double_field(nearest_or_infinity(number));
  return json;
}

// The nearest double to twice the number: a diameter.
double nearest_twice(const QuadraticNumber& number) {
  return nearest_or_infinity(QuadraticNumber(Rational(2)) * number);
}

// A gate below 0 counts as 0 (FC-BALL-05).
double nearest_depth(const Pores& pores, const Chamber& chamber) {
  const QuadraticNumber gate = chamber.gates.empty() ? QuadraticNumber() : pores.value(chamber.gates[0]);
  return nearest_difference(pores.value(chamber.peaks[0]), gate);
}

// balls, hidden, and what made the object.
Json ball_fields(const char* format, const BallSet& balls, const std::string& radii) {
  Json json = header_fields(format, 1);
  json["radii"] = radii.empty() ? Json(nullptr) : Json(radii);
  json["balls"] = balls.size();
  json["hidden"] = Json::array();
  for (std::uint32_t id = 0; id < balls.size(); ++id) {
    if (!std::ranges::binary_search(balls.visible(), id)) json["hidden"].push_back(id);
  }
  return json;
}

// Their names.
Json atom_texts(const AtomNames& atoms, const std::vector<std::uint32_t>& ids) {
  Json texts = Json::array();
  for (const std::uint32_t id : ids) texts.push_back(atoms.text(id));
  return texts;
}

class PoreFields {
 public:
  explicit PoreFields(const PoresToWrite& what) : what_(what), pores_(what.pores) {}

  [[nodiscard]] Json chamber(const Chamber& chamber) const {
    Json json;
    json["peak"] = witnesses(chamber.peaks);
    json["gate"] = chamber.gates.empty() ? Json(nullptr) : witnesses(chamber.gates);
    json["depth"] = double_field(nearest_depth(pores_, chamber));
    json["exit"] = chamber.exit ? number_field(pores_.value(*chamber.exit)) : Json(nullptr);
    json["diameter"] = diameter(chamber.peaks[0]);
    json["limiting_diameter"] = chamber.exit ? diameter(*chamber.exit) : Json(nullptr);
    json["windows"] = chamber.windows;
    json["handles"] = Json::array();
    for (const std::uint32_t handle : chamber.handles) json["handles"].push_back(contacts(handle));
    if (what_.probe) json["is"] = status_text(pores_.status(chamber, *what_.probe));
    return json;
  }

  [[nodiscard]] Json window(const PoreWindow& window) const {
    Json json;
    json["value"] = number_field(pores_.value(window.point));
    json["diameter"] = diameter(window.point);
    json.update(point(window.point));
    json["rooms"] = Json::array();
    for (const std::uint32_t room : window.rooms) {
      json["rooms"].push_back(room == Pores::kOutside ? -1 : static_cast<std::int64_t>(room));
    }
    return json;
  }

  [[nodiscard]] Json witnesses(const std::vector<std::uint32_t>& points) const {
    Json json;
    json["value"] = number_field(pores_.value(points[0]));
    json["points"] = Json::array();
    for (const std::uint32_t each : points) json["points"].push_back(point(each));
    return json;
  }

  [[nodiscard]] Json diameter(std::uint32_t point) const { return double_field(nearest_twice(pores_.value(point))); }

  [[nodiscard]] Json interval(const CavityInterval& cavity) const {
    return {cavity.gate ? number_field(pores_.value(*cavity.gate)) : Json(nullptr),
            number_field(pores_.value(cavity.peak))};
  }

 private:
  [[nodiscard]] const std::vector<std::uint32_t>& contacts(std::uint32_t point) const {
    return pores_.points()[point].contact;
  }

  [[nodiscard]] Json point(std::uint32_t point) const {
    Json json;
    json["contact"] = contacts(point);
    if (what_.atoms != nullptr) json["names"] = atom_texts(*what_.atoms, contacts(point));
    json["center"] = Json::array();
    for (const QuadraticNumber& coordinate : pores_.center(point)) json["center"].push_back(number_field(coordinate));
    return json;
  }

  const PoresToWrite& what_;
  const Pores& pores_;
};

std::string csv_number(const QuadraticNumber& number) { return io::csv_number(nearest_or_infinity(number)); }

std::string csv_position(const Pores& pores, std::uint32_t point) {
  const auto [x, y, z] = pores.center(point);
  return fmt::format("{},{},{}", csv_number(x), csv_number(y), csv_number(z));
}

// The ids as one field, and of a molecule the names as another one.
std::string csv_atoms(const AtomNames* atoms, const std::vector<std::uint32_t>& ids) {
  std::string rows, names;
  for (const std::uint32_t id : ids) {
    rows += (rows.empty() ? "" : ";") + std::to_string(id);
    if (atoms != nullptr) names += (names.empty() ? "" : "; ") + atoms->text(id);
  }
  return atoms == nullptr ? rows : rows + ',' + csv_text(names);
}

// The contacts of all these points, likewise.
std::string csv_atoms(const PoresToWrite& what, std::span<const std::uint32_t> points) {
  std::set<std::uint32_t> ids;
  for (const std::uint32_t point : points) {
    const auto& contacts = what.pores.points()[point].contact;
    ids.insert(contacts.begin(), contacts.end());
  }
  return csv_atoms(what.atoms, {ids.begin(), ids.end()});
}

}  // namespace

WidestChambers widest_chambers(const Pores& pores) {
  WidestChambers widest;
  const auto rank = [&](std::uint32_t point) { return pores.points()[point].rank; };
  const auto& chambers = pores.chambers();
  for (std::size_t number = 0; number < chambers.size(); ++number) {
    const Chamber& chamber = chambers[number];
    if (!widest.of_peak || rank(chamber.peaks[0]) < rank(chambers[*widest.of_peak].peaks[0])) widest.of_peak = number;
    if (!chamber.exit) continue;
    if (!widest.of_exit || rank(*chamber.exit) < rank(*chambers[*widest.of_exit].exit)) widest.of_exit = number;
  }
  return widest;
}

void write_pores(std::ostream& out, const PoresToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const PoreFields fields(what);
  const Pores& pores = what.pores;
  Json json = ball_fields("flowcert-pores", pores.balls(), what.radii);
  json["depth"] = to_text(what.depth);
  json["probe"] = what.probe ? Json(to_text(*what.probe)) : Json(nullptr);
  if (what.probe) json["cavities_at_probe"] = pores.cavities_at(*what.probe);
  const WidestChambers widest = widest_chambers(pores);
  const auto& chambers = pores.chambers();
  json["largest_cavity_diameter"] =
      widest.of_peak ? fields.diameter(chambers[*widest.of_peak].peaks[0]) : Json(nullptr);
  json["pore_limiting_diameter"] = widest.of_exit ? fields.diameter(*chambers[*widest.of_exit].exit) : Json(nullptr);
  json["vestibules"] = Json::array();
  for (const auto& peaks : pores.vestibules()) json["vestibules"].push_back(fields.witnesses(peaks));
  json["windows"] = Json::array();
  for (const PoreWindow& window : pores.windows()) json["windows"].push_back(fields.window(window));
  json["cavities"] = Json::array();
  for (const CavityInterval& cavity : pores.cavities()) json["cavities"].push_back(fields.interval(cavity));
  // The chambers come last, and are written as they are made.
  json["chambers"] = Json::array();
  std::string text = json.dump();
  text.resize(text.size() - 2);
  out << text;
  for (std::size_t number = 0; number < chambers.size(); ++number) {
    out << (number > 0 ? "," : "") << fields.chamber(chambers[number]).dump();
  }
  out << "]}\n";
}

void write_pores_csv(std::ostream& out, const PoresToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const Pores& pores = what.pores;
  out << "chamber,x,y,z,peak,gate,depth,exit,diameter,limiting_diameter,windows,handles,peaks"
      << (what.probe ? ",is" : "")
      << (what.atoms == nullptr ? ",peak_atoms,gate_atoms\n" : ",peak_atoms,peak_names,gate_atoms,gate_names\n");
  for (std::size_t number = 0; number < pores.chambers().size(); ++number) {
    const Chamber& chamber = pores.chambers()[number];
    const QuadraticNumber peak = pores.value(chamber.peaks[0]);
    std::string gate, exit, limiting;
    if (!chamber.gates.empty()) gate = csv_number(pores.value(chamber.gates[0]));
    if (chamber.exit) {
      exit = csv_number(pores.value(*chamber.exit));
      limiting = io::csv_number(nearest_twice(pores.value(*chamber.exit)));
    }
    out << fmt::format("{},{},{},{},{},{},{},{},{},{},{}", number, csv_position(pores, chamber.peaks[0]),
                       csv_number(peak), gate, io::csv_number(nearest_depth(pores, chamber)), exit,
                       io::csv_number(nearest_twice(peak)), limiting, chamber.windows.size(), chamber.handles.size(),
                       chamber.peaks.size());
    if (what.probe) out << ',' << status_text(pores.status(chamber, *what.probe));
    out << ',' << csv_atoms(what, chamber.peaks) << ',' << csv_atoms(what, chamber.gates) << '\n';
  }
}

void write_windows_csv(std::ostream& out, const PoresToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const Pores& pores = what.pores;
  out << "chamber,window,x,y,z,value,diameter,rooms,atoms" << (what.atoms == nullptr ? "\n" : ",names\n");
  for (std::size_t number = 0; number < pores.chambers().size(); ++number) {
    for (const std::uint32_t place : pores.chambers()[number].windows) {
      const PoreWindow& window = pores.windows()[place];
      const QuadraticNumber value = pores.value(window.point);
      std::string rooms;
      for (const std::uint32_t room : window.rooms) {
        rooms += (rooms.empty() ? "" : ";") + (room == Pores::kOutside ? std::string("-1") : std::to_string(room));
      }
      out << fmt::format("{},{},{},{},{},{},{}\n", number, place, csv_position(pores, window.point), csv_number(value),
                         io::csv_number(nearest_twice(value)), rooms, csv_atoms(what, {&window.point, 1}));
    }
  }
}

void write_cavity_curve_csv(std::ostream& out, const Pores& pores) {
  const geometry::IeeeDoubles ieee;
  out << "up_to,cavities\n";
  for (const CavityStep& step : pores.cavity_steps()) {
    out << fmt::format("{},{}\n", csv_number(pores.value(step.point)), step.count);
  }
}

// ---- Cavities for one probe ----

void write_cavities(std::ostream& out, const CavitiesToWrite& what) {
  Json json = ball_fields("flowcert-cavities", what.balls, what.radii);
  json["probe"] = to_text(what.probe);
  json["cavities"] = Json::array();
  for (const BallCavity& cavity : what.cavities) {
    Json one;
    one["lining"] = cavity.lining;
    if (what.atoms != nullptr) one["names"] = atom_texts(*what.atoms, cavity.lining);
    json["cavities"].push_back(std::move(one));
  }
  out << json.dump() << '\n';
}

void write_cavities_csv(std::ostream& out, const CavitiesToWrite& what) {
  out << "cavity,lining,atoms" << (what.atoms == nullptr ? "\n" : ",names\n");
  for (std::size_t number = 0; number < what.cavities.size(); ++number) {
    const auto& atoms = what.cavities[number].lining;
    out << fmt::format("{},{},{}\n", number, atoms.size(), csv_atoms(what.atoms, atoms));
  }
}

void write_cavity_atoms_csv(std::ostream& out, const CavitiesToWrite& what) {
  const geometry::IeeeDoubles ieee;
  out << "cavity,row," << (what.atoms == nullptr ? "" : "chain,residue,number,atom,element,") << "x,y,z,radius\n";
  for (std::size_t number = 0; number < what.cavities.size(); ++number) {
    for (const std::uint32_t row : what.cavities[number].lining) {
      out << fmt::format("{},{},", number, row);
      if (what.atoms != nullptr) {
        const AtomName name = (*what.atoms)[row];
        for (const std::string_view part : {name.chain, name.residue, name.number, name.atom, name.element}) {
          out << csv_text(part) << ',';
        }
      }
      const auto& [centre, radius] = what.balls[row];
      out << fmt::format("{},{},{},{}\n", csv_number(centre[0]), csv_number(centre[1]), csv_number(centre[2]),
                         csv_number(radius));
    }
  }
}

}  // namespace flowcert
