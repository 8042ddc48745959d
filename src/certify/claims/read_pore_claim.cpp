// Reads diameters of pores: lines, a list in JSON, or what `pores --json` prints. Twice a radius is a diameter.
#include <algorithm>
#include <span>
#include <utility>

#include "certify/claims/exchange_value.h"
#include "certify/claims/named_format.h"
#include "certify/layer.h"
#include "certify/pore_claims.h"
#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert {

using namespace certify;

namespace {

using Places = std::vector<ClaimedPorePlace>;

std::optional<PoreKind> kind_of(std::string_view word) {
  const auto* const found = std::ranges::find(kPoreKinds, word);
  return found == kPoreKinds.end() ? std::nullopt : std::optional(static_cast<PoreKind>(found - kPoreKinds.begin()));
}

ClaimedRoot as_root(const ClaimedNumber& number, int factor = 1) {
  return {Rational(number.value * factor), number.is_exact};
}

// ---- JSON

QuadraticNumber root_of(const ExchangeValue& value) {
  const ExchangeValue polynomial = value.get("polynomial"), choice = value.get("root");
  const auto coefficients = list_of(polynomial, [](const ExchangeValue& each) { return number_of(each).value; });
  const std::string_view which = choice.number_text();
  if ((coefficients.size() != 2 && coefficients.size() != 3) || coefficients[0] == 0) {
    polynomial.reject("two or three coefficients, of which the first one is not 0");
  }
  if (coefficients.size() == 2 ? which != "0" : which != "1" && which != "-1") {
    choice.reject("0 for degree 1, and 1 or -1 for degree 2");
  }
  if (coefficients.size() == 2) return Rational(-coefficients[1] / coefficients[0]);
  const auto roots = roots_of({coefficients[0], coefficients[1] / 2, coefficients[2]});
  if (roots.empty()) polynomial.reject("one that has real roots");
  return which == "1" ? std::max(roots.front(), roots.back()) : std::min(roots.front(), roots.back());
}

// The forms of a number, times the factor. A null is none: a double would overflow, or it is below 0.
ClaimedForms forms_of(const ExchangeValue& value, int factor) {
  if (value.is_null()) return {};
  if (!value.is(JsonKind::kObject)) return {as_root(number_of(value), factor)};
  ClaimedForms forms{{QuadraticNumber(Rational(factor)) * root_of(value), true}};
  const auto rounded = value.find("double");
  if (rounded && !rounded->is_null()) forms.push_back(as_root(number_of(*rounded), factor));
  return forms;
}

ClaimedPorePlace place_of(const ExchangeValue& value) {
  ClaimedPorePlace place;
  if (const auto contact = value.find("contact")) place.balls = contact_of(*contact);
  if (const auto center = value.find("center")) {
    center->expect_size(3);
    place.position.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      (*place.position)[axis] = forms_of((*center)[axis], 1);
      if ((*place.position)[axis].empty()) center->reject("three coordinates");
    }
  }
  return place;
}

class PoreObject {
 public:
  explicit PoreObject(const ExchangeValue& object) : object_(object) {}

  [[nodiscard]] PoreClaim read() {
    if (const auto format = object_.find("format")) format->expect_one_of({"flowcert-pores"}, "'flowcert-pores'");
    const auto version = object_.find("format_version");
    if (version && version->number_text() != "1") version->reject("1, the only version that is known");
    if (const auto balls = object_.find("balls")) claim_.balls = count_of(*balls);
    if (const auto depth = object_.find("depth")) claim_.depth = distance_of(*depth).value;
    const bool has_chambers = read_list("chambers", "chamber ", &PoreObject::read_chamber),
               has_windows = read_list("windows", "window ", &PoreObject::read_window);
    claim_.is_whole = has_chambers && has_windows;
    if (const auto whole = object_.find("whole")) claim_.is_whole = bool_of(*whole);
    if (!read_list("pores", "pore ", &PoreObject::read_pore) && !has_chambers && !has_windows) {
      object_.place().reject("no key 'pores', and none of 'chambers' and 'windows'");
    }
    read_greatest("largest_cavity_diameter", PoreKind::kCavity, has_chambers);
    read_greatest("pore_limiting_diameter", PoreKind::kLimiting, has_chambers);
    return std::move(claim_);
  }

 private:
  using Name = const std::string&;

  bool read_list(const char* key, Name noun, void (PoreObject::*read_one)(const ExchangeValue&, Name)) {
    const auto list = object_.find(key);
    std::size_t number = 0;
    if (!list) return false;
    list->for_each([&](const ExchangeValue& each) { (this->*read_one)(each, noun + std::to_string(number++)); });
    return true;
  }

  // One of the two lengths may be missing. Where none has a number, it is claimed to be below 0.
  ClaimedPore& add(PoreKind kind, Name name, const std::optional<ExchangeValue>& radius,
                   const std::optional<ExchangeValue>& diameter, Places places) {
    ClaimedPore pore{.kind = kind, .line = object_.place().line, .name = name, .places = std::move(places)};
    for (const auto& [value, factor] : {std::pair(radius, 2), std::pair(diameter, 1)}) {
      if (!value) continue;
      if (value->is_null() && kind < PoreKind::kGate) value->reject("a number");
      std::ranges::move(forms_of(*value, factor), std::back_inserter(pore.diameter));
      if (std::ranges::any_of(pore.diameter, [](const auto& form) { return form.value.sign() < 0; })) {
        value->reject("0 or more");
      }
    }
    return claim_.pores.emplace_back(std::move(pore));
  }

  void add(PoreKind kind, Name name, const ExchangeValue& value, const std::optional<ExchangeValue>& radius) {
    const auto diameter = radius ? value.find("diameter") : value.get("diameter");
    const bool is_somewhere = value.find("contact") || value.find("center");
    add(kind, name, radius, diameter, is_somewhere ? Places{place_of(value)} : Places{});
  }
  void read_window(const ExchangeValue& value, Name name) { add(PoreKind::kWindow, name, value, value.get("value")); }
  void read_pore(const ExchangeValue& value, Name name) {
    const auto kind = kind_of(value.get("kind").text());
    if (!kind) value.get("kind").reject("'cavity', 'window', 'gate' or 'limiting'");
    add(*kind, name, value, std::nullopt);
  }

  // Its gate and its exit have the places of its peak, by which it is known.
  void read_chamber(const ExchangeValue& value, Name name) {
    const ExchangeValue peak = value.get("peak");
    const Places places = list_of(peak.get("points"), place_of);
    if (places.empty()) peak.reject("one with points");
    add(PoreKind::kCavity, name, peak.get("value"), value.find("diameter"), places);
    const auto gate = value.find("gate"), exit = value.find("exit");
    if (gate) add(PoreKind::kGate, name, gate->is_null() ? gate : gate->get("value"), std::nullopt, places);
    if (exit) add(PoreKind::kLimiting, name, exit, value.find("limiting_diameter"), places);
  }

  void read_greatest(const char* key, PoreKind kind, bool is_beside) {
    const auto diameter = object_.find(key);
    if (!diameter || (diameter->is_null() && kind == PoreKind::kCavity)) return;
    ClaimedPore& pore = add(kind, key, std::nullopt, diameter, {});
    pore.is_greatest = true;
    pore.is_beside = is_beside;
  }

  ExchangeValue object_;
  PoreClaim claim_;
};

PoreClaim pores_of_json(std::string_view bytes, const std::string& name) {
  const auto lines_before = std::ranges::count(bytes.substr(0, bytes.find('{')), '\n');
  const LinePlace place{.file = name, .line = 1 + static_cast<std::size_t>(lines_before)};
  const JsonDocument tree = parse_json(bytes, place);
  return PoreObject(ExchangeValue(tree, "pores", place)).read();
}

// ---- Lines

using Words = std::span<const std::string_view>;

ClaimedPorePlace place_of(Words words, const LinePlace& at) {
  ClaimedPorePlace place;
  if (words.size() > 3 && words[0] == "at") {
    const auto coordinate = [&](std::size_t k) {
      return ClaimedForms{as_root(claimed_number(words[k], PlainInteger::kDecimal, at))};
    };
    place.position = {coordinate(1), coordinate(2), coordinate(3)};
    words = words.subspan(4);
  }
  if (words.empty()) return place;
  if (words[0] != "atoms" || words.size() < 2)
    at.reject("neither 'at X Y Z' nor 'atoms' with ids: " + in_quotes(words[0]));
  for (const std::string_view word : words.subspan(1)) place.balls.push_back(claimed_id(word, at));
  return place;
}

void read_line(Words words, const LinePlace& at, PoreClaim& claim) {
  const auto number = [&] { return claimed_distance(words[1], PlainInteger::kDecimal, at); };
  if (const auto kind = kind_of(words[0]); kind && words.size() > 1) {
    ClaimedPore pore{.kind = *kind, .line = at.line};
    if (words[1] != "none" || *kind < PoreKind::kGate) pore.diameter = {as_root(number())};
    if (words.size() > 2) pore.places = {place_of(words.subspan(2), at)};
    claim.pores.push_back(std::move(pore));
  } else if (words[0] == "depth" && words.size() == 2) {
    claim.depth = number().value;
  } else if (words[0] == "all" && words.size() == 1) {
    claim.is_whole = true;
  } else {
    at.reject("not a kind (cavity, window, gate, limiting) and a diameter, 'depth' and a number, or 'all': " +
              in_quotes(words[0]));
  }
}

PoreClaim pores_of_lines(std::string_view bytes, const std::string& name) {
  PoreClaim claim;
  LineReader lines(bytes, name);
  for (std::string_view line; lines.next_uncommented(line);) read_line(words_of(line), lines.place(), claim);
  return claim;
}

}  // namespace

bool is_pore_claim(std::string_view bytes, const std::string& name) {
  const std::string_view text = trimmed(bytes);
  if (text.starts_with('{')) return names_format(text, "flowcert-pores");
  LineReader lines(text, name);
  std::string_view first;
  return lines.next_uncommented(first) && kind_of(words_of(first).front());
}

PoreClaim claimed_pores_of(std::string_view bytes, const std::string& name) {
  const geometry::IeeeDoubles ieee;
  if (is_all_blank(bytes)) reject_file(name, "empty");
  PoreClaim claim = trimmed(bytes).starts_with('{') ? pores_of_json(bytes, name) : pores_of_lines(bytes, name);
  for (ClaimedPore& pore : claim.pores) {
    // The limiting diameter of no chamber is that of all.
    pore.is_greatest = pore.is_greatest || (pore.kind == PoreKind::kLimiting && pore.places.empty());
    if (!pore.diameter.empty()) pore.near = nearest_or_infinity(pore.diameter[0].value);
    for (ClaimedPorePlace& place : pore.places) {
      for (std::size_t axis = 0; place.position && axis < 3; ++axis) {
        place.near[axis] = nearest_or_infinity((*place.position)[axis][0].value);
      }
      geometry::keep_unique(place.balls);
    }
  }
  return claim;
}

}  // namespace flowcert
