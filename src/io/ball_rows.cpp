#include "io/ball_rows.h"

#include <fmt/format.h>

#include <utility>

#include "io/foreign_text.h"
#include "io/number_text.h"
#include "io/point_rows.h"

namespace flowcert::io {

namespace {

[[noreturn]] void reject_at(const LinePlace& place, const std::string& reason) {
  if (place.line == 0) reject_file(place.file, reason);
  place.reject(reason);
}

[[noreturn]] void reject_radius(const LinePlace& place, std::string_view text, const char* advice = "") {
  reject_at(place, fmt::format("a radius is above 0, not {}{}", in_quotes(text), advice));
}

}  // namespace

void require_radius(const Rational& radius, std::string_view text, const LinePlace& place) {
  if (radius <= 0) reject_radius(place, text);
}

void BallRows::see_centre(const std::optional<RationalPoint>& centre, const LinePlace& place) {
  next_centre_ = centre;
  place_ = place;
}

void BallRows::add(const std::array<std::string_view, 3>& fields, const LinePlace& place) {
  place_ = place;
  add({exact_number(fields[0], place), exact_number(fields[1], place), exact_number(fields[2], place)});
}

void BallRows::add(const Point& point) {
  if (next_centre_) {
    add(*std::exchange(next_centre_, std::nullopt));
    return;
  }
  add({Rational(point.x), Rational(point.y), Rational(point.z)});
}

void BallRows::add(RationalPoint centre) {
  const bool is_one = radii_.source() == AtomRadii::Source::kOne, is_said = !next_radius_.empty();
  balls_.push_back({std::move(centre), is_one ? radii_.one() : is_said ? exact_number(next_radius_, place_) : 0});
  for (const Rational& coordinate : balls_.back().center) require_short(coordinate);
  if (!radii_.needs_elements()) take_radius(balls_.back().radius);
}

void BallRows::take_radius(const Rational& radius) {
  const bool is_pqr = radii_.source() == AtomRadii::Source::kPqr;
  if (radius <= 0) reject_radius(place_, next_radius_, is_pqr ? "; --radii pqr,H=R gives hydrogens another" : "");
  require_short(radius);
  balls_.back().radius = radius;
}

// All numbers get a common denominator later, so that one long one would make all of them long.
void BallRows::require_short(const Rational& number) const {
  constexpr std::size_t kMostBits = 4096;
  if (mpz_sizeinbase(mpq_denref(number.backend().data()), 2) <= kMostBits) return;
  reject_at(place_, "a number of more than a thousand decimals, which is refused where radii are asked for");
}

void BallRows::see_element(const AtomNames& names, std::string_view residue, const ElementText& text) {
  if (!radii_.needs_elements()) return;
  const MeantElement meant = element_of(text, residue);
  const Rational* const radius = radii_.of_element(meant.symbol);
  const bool is_missing = radius == nullptr && radii_.source() == AtomRadii::Source::kElements;
  if (meant.symbol.empty() || !meant.other.empty() || is_missing) reject_element(names, text, meant);
  if (text.source == ElementSource::kPdbName || text.source == ElementSource::kName) ++named_elements_;
  take_radius(radius != nullptr ? *radius : balls_.back().radius);
}

void BallRows::reject_element(const AtomNames& names, const ElementText& text, const MeantElement& meant) const {
  const auto id = static_cast<PointId>(balls_.size() - 1);
  const auto reject = [&](const std::string& reason) {
    reject_at(place_, fmt::format("atom {} ({}): {}", id, names.text(id), reason));
  };
  const std::string_view written = trimmed(text.text);
  if (written.empty()) reject("its element is not said, and --radii needs it");
  if (meant.symbol.empty()) reject(fmt::format("no element is known by {}, and --radii needs it", in_quotes(written)));
  if (!meant.other.empty()) {
    reject(fmt::format("{} may mean {} or {}: the file has to say which element it is", in_quotes(written),
                       meant.symbol, meant.other));
  }
  reject(fmt::format("{} has no radius of {}; --radii {},{}=R says one", in_quotes(radii_.base()), meant.symbol,
                     on_one_line(radii_.text()), meant.symbol));
}

void BallRows::see_crystal(std::size_t line) const {
  if (is_finite_) return;
  reject_at({file_, line},
            "the atoms of a crystal have no end, and balls are a finite set: --finite takes those of the "
            "file alone");
}

}  // namespace flowcert::io
