#include "flowcert/atom_radii.h"

#include <fmt/format.h>

#include <functional>
#include <set>
#include <vector>

#include "io/ball_rows.h"
#include "io/elements.h"
#include "io/input_bytes.h"
#include "io/number_text.h"
#include "io/point_rows.h"
#include "io/table_columns.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::string_view kColumn = "column:", kTable = "table:";

// The overrides are the last parts, as far as all have '='. A file's name may have commas.
std::size_t size_of_base(std::string_view text) {
  std::size_t end = text.size();
  for (std::size_t comma = text.rfind(','); comma != std::string_view::npos; comma = text.rfind(',', comma - 1)) {
    if (text.substr(comma, end - comma).find('=') == std::string_view::npos) break;
    end = comma;
    if (comma == 0) break;
  }
  return end;
}

std::string symbol_at(std::string_view text, const LinePlace& place) {
  const std::string_view symbol = symbol_of(text);
  const bool is_right = !symbol.empty() && (symbol == text || text == "D" || text == "T");
  if (!is_right) place.reject("no element as the periodic table writes it: " + in_quotes(text));
  return std::string(symbol);
}

Rational radius_as_said(std::string_view text, const LinePlace& place) {
  const Rational radius = claimed_number(text, PlainInteger::kExact, place).value;
  require_radius(radius, text, place);
  return radius;
}

}  // namespace

AtomRadii::AtomRadii(std::string_view text)
    : text_(trimmed(text)), base_(trimmed(text_.substr(0, size_of_base(text_)))) {
  read_base();
  const std::vector<std::string_view> overrides = split_at(std::string_view(text_).substr(size_of_base(text_)), ',');
  std::set<std::string, std::less<>> seen;
  for (std::size_t k = 1; k < overrides.size(); ++k) {
    const LinePlace place = {"--radii", k + 1};
    const std::size_t sign = overrides[k].find('=');
    const std::string symbol = symbol_at(trimmed(overrides[k].substr(0, sign)), place);
    if (!seen.insert(symbol).second) place.reject(fmt::format("a second radius of {}", symbol));
    by_element_.insert_or_assign(symbol, radius_as_said(trimmed(overrides[k].substr(sign + 1)), place));
  }
}

void AtomRadii::read_base() {
  const LinePlace place = {"--radii", 1};
  const std::string_view base = base_;
  if (base == "bondi" || base == "alvarez") {
    for (const Element& element : elements()) {
      const unsigned hundredths = base == "bondi" ? element.bondi : element.alvarez;
      if (hundredths > 0) by_element_.emplace(element.symbol, Rational(hundredths) / 100);
    }
  } else if (base == "pqr") {
    source_ = Source::kPqr;
  } else if (base.starts_with(kColumn)) {
    source_ = Source::kColumn;
    column_ = written_size(base.substr(kColumn.size()), place);
    if (column_ == 0) place.reject("columns are counted from 1");
  } else if (base.starts_with(kTable)) {
    read_table(std::string(base.substr(kTable.size())));
  } else if (begins_as_number(base)) {
    source_ = Source::kOne;
    one_ = radius_as_said(base, place);
  } else {
    place.reject(
        fmt::format("bondi, alvarez, pqr, column:N, table:FILE or one radius, each also with overrides "
                    "behind it as ,Fe=2.04; not {}",
                    in_quotes(base)));
  }
}

void AtomRadii::read_table(const std::string& path) {
  const std::string bytes = read_bytes(path);
  std::string decompressed;
  LineReader lines(plain_content(bytes, path, decompressed), path);
  for (std::string_view line; lines.next_uncommented(line);) {
    const std::vector<std::string_view> fields = fields_of(line, separators_of(line));
    if (fields.size() != 2)
      lines.place().reject(fmt::format("an element and its radius, not {} fields", fields.size()));
    const std::string symbol = symbol_at(fields[0], lines.place());
    const Rational radius = exact_number(fields[1], lines.place());
    require_radius(radius, fields[1], lines.place());
    if (!by_element_.emplace(symbol, radius).second) lines.place().reject(fmt::format("a second radius of {}", symbol));
  }
  if (by_element_.empty()) reject_file(path, "no line has an element and its radius");
}

const Rational* AtomRadii::of_element(std::string_view symbol) const {
  const auto found = by_element_.find(symbol);
  return found == by_element_.end() ? nullptr : &found->second;
}

}  // namespace flowcert
