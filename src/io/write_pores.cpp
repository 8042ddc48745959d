#include "io/write_pores.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/floating_point.h"
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

class PoreFields {
 public:
  explicit PoreFields(const PoresToWrite& what) : what_(what), pores_(what.pores) {}

  [[nodiscard]] Json chamber(const Chamber& chamber) const {
    const QuadraticNumber peak = pores_.value(chamber.peaks[0]);
    const QuadraticNumber gate = chamber.gates.empty() ? QuadraticNumber() : pores_.value(chamber.gates[0]);
    Json json;
    json["peak"] = witnesses(chamber.peaks);
    json["gate"] = chamber.gates.empty() ? Json(nullptr) : witnesses(chamber.gates);
    json["depth"] = chamber.gates.empty() ? Json(nullptr) : double_field(nearest_difference(peak, gate));
    json["exit"] = chamber.exit ? number_field(pores_.value(*chamber.exit)) : Json(nullptr);
    json["windows"] = chamber.windows;
    json["handles"] = Json::array();
    for (const std::uint32_t handle : chamber.handles) json["handles"].push_back(contacts(handle));
    if (what_.probe) json["is"] = status_text(pores_.status(chamber, *what_.probe));
    return json;
  }

  [[nodiscard]] Json window(const PoreWindow& window) const {
    Json json;
    json["value"] = number_field(pores_.value(window.point));
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

  [[nodiscard]] Json interval(const CavityInterval& cavity) const {
    return {cavity.gate ? number_field(pores_.value(*cavity.gate)) : Json(nullptr),
            number_field(pores_.value(cavity.peak))};
  }

 private:
  [[nodiscard]] const std::vector<std::uint32_t>& contacts(std::uint32_t point) const {
    return pores_.points()[point].contacts;
  }

  [[nodiscard]] Json point(std::uint32_t point) const {
    Json json;
    json["contact"] = contacts(point);
    if (what_.atoms != nullptr) {
      json["atoms"] = Json::array();
      for (const std::uint32_t row : contacts(point)) json["atoms"].push_back(what_.atoms->text(row));
    }
    json["center"] = Json::array();
    for (const QuadraticNumber& coordinate : pores_.position(point)) json["center"].push_back(number_field(coordinate));
    return json;
  }

  const PoresToWrite& what_;
  const Pores& pores_;
};

std::string csv_number(const QuadraticNumber& number) {
  const double value = nearest_or_infinity(number);
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string csv_position(const Pores& pores, std::uint32_t point) {
  const auto [x, y, z] = pores.position(point);
  return fmt::format("{},{},{}", csv_number(x), csv_number(y), csv_number(z));
}

}  // namespace

void write_pores(std::ostream& out, const PoresToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const PoreFields fields(what);
  const Pores& pores = what.pores;
  Json json = header_fields("flowcert-pores", 1);
  json["balls"] = pores.balls().size();
  json["hidden"] = Json::array();
  for (std::uint32_t id = 0; id < pores.balls().size(); ++id) {
    if (!std::ranges::binary_search(pores.balls().visible(), id)) json["hidden"].push_back(id);
  }
  json["depth"] = to_text(what.depth);
  json["probe"] = what.probe ? Json(to_text(*what.probe)) : Json(nullptr);
  if (what.probe) json["cavities_at_probe"] = pores.cavities_at(*what.probe);
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
  for (std::size_t number = 0; number < pores.chambers().size(); ++number) {
    out << (number > 0 ? "," : "") << fields.chamber(pores.chambers()[number]).dump();
  }
  out << "]}\n";
}

void write_pores_csv(std::ostream& out, const PoresToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const Pores& pores = what.pores;
  out << "chamber,x,y,z,peak,gate,depth,exit,windows,handles,peaks" << (what.probe ? ",is" : "") << '\n';
  for (std::size_t number = 0; number < pores.chambers().size(); ++number) {
    const Chamber& chamber = pores.chambers()[number];
    const QuadraticNumber peak = pores.value(chamber.peaks[0]);
    const auto of_gate = [&](const auto& text) {
      return chamber.gates.empty() ? std::string() : text(pores.value(chamber.gates[0]));
    };
    out << fmt::format("{},{},{},{},{},{},{},{},{}", number, csv_position(pores, chamber.peaks[0]), csv_number(peak),
                       of_gate(csv_number), of_gate([&](const QuadraticNumber& gate) {
                         return fmt::format("{}", nearest_difference(peak, gate));
                       }),
                       chamber.exit ? csv_number(pores.value(*chamber.exit)) : "", chamber.windows.size(),
                       chamber.handles.size(), chamber.peaks.size());
    if (what.probe) out << ',' << status_text(pores.status(chamber, *what.probe));
    out << '\n';
  }
}

void write_windows_csv(std::ostream& out, const PoresToWrite& what) {
  const geometry::IeeeDoubles ieee;
  const Pores& pores = what.pores;
  out << "chamber,window,x,y,z,value,rooms,atoms\n";
  for (std::size_t number = 0; number < pores.chambers().size(); ++number) {
    for (const std::uint32_t place : pores.chambers()[number].windows) {
      const PoreWindow& window = pores.windows()[place];
      std::string rooms, atoms;
      for (const std::uint32_t room : window.rooms) {
        rooms += (rooms.empty() ? "" : ";") + (room == Pores::kOutside ? std::string("-1") : std::to_string(room));
      }
      for (const std::uint32_t id : pores.points()[window.point].contacts) {
        atoms += (atoms.empty() ? "" : ";") + std::to_string(id);
      }
      out << fmt::format("{},{},{},{},{},{}\n", number, place, csv_position(pores, window.point),
                         csv_number(pores.value(window.point)), rooms, atoms);
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

}  // namespace flowcert
