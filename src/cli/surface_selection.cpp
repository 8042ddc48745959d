// See surface_selection.h.
#include "cli/surface_selection.h"

#include <algorithm>
#include <numeric>
#include <string_view>

#include "flowcert/point_set.h"
#include "io/claims/claim_numbers.h"
#include "io/number_text.h"

namespace flowcert {

namespace {

constexpr std::string_view kPersistence = "persistence>";
constexpr std::string_view kRadius = "index2-radius<";
constexpr std::string_view kLargestGaps = "largest-gaps=";

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

// By number in StableManifolds: death minus birth of the pair that an index-2 point is in, as the death of a
// tunnel or the birth of a void. Every one is in a pair that does not last (FC-PERS-02).
std::vector<Rational> gaps_of(const PersistenceRun& run) {
  const std::size_t count = run.stationary.critical_counts()[2];
  std::vector<Rational> gaps(count);
  if (count == 0) return gaps;
  const std::size_t first = run.stable.record(0);
  for (const PersistencePair& pair : run.persistence.pairs()) {
    if (pair.dimension == 0 || !pair.death) continue;
    const std::size_t saddle = pair.dimension == 1 ? *pair.death : pair.birth;
    gaps.at(saddle - first) =
        run.persistence.squared_value(*pair.death) - run.persistence.squared_value(pair.birth);
  }
  return gaps;
}

// Whether each is among the n largest; of equal ones the first in the list are.
std::vector<bool> among_largest(const std::vector<Rational>& gaps, std::size_t n) {
  std::vector<std::size_t> order(gaps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return gaps[a] > gaps[b]; });
  std::vector<bool> chosen(gaps.size(), false);
  for (std::size_t k = 0; k < std::min(n, order.size()); ++k) chosen[order[k]] = true;
  return chosen;
}

}  // namespace

SurfaceSelection::SurfaceSelection(const std::vector<std::string>& expressions) {
  for (std::size_t k = 0; k < expressions.size(); ++k) add(expressions[k], {"--select", k + 1});
}

void SurfaceSelection::add(const std::string& expression, const LinePlace& place) {
  const std::string text = without_blanks(expression);
  const std::string_view rest(text);
  const auto number_behind = [&](std::string_view name) {
    return claimed_number(rest.substr(name.size()), PlainInteger::kExact, place).value;
  };
  if (rest.starts_with(kPersistence)) {
    const Rational bound = number_behind(kPersistence);
    persistence_above_ = persistence_above_ ? std::max(*persistence_above_, bound) : bound;
  } else if (rest.starts_with(kRadius)) {
    const Rational bound = number_behind(kRadius);
    radius_below_ = radius_below_ ? std::min(*radius_below_, bound) : bound;
  } else if (rest.starts_with(kLargestGaps)) {
    const std::size_t count = claimed_count(rest.substr(kLargestGaps.size()), place);
    largest_gaps_ = largest_gaps_ ? std::min(*largest_gaps_, count) : count;
  } else {
    place.reject("none of persistence>X, index2-radius<R and largest-gaps=N: " + in_quotes(expression));
  }
}

std::vector<std::size_t> SurfaceSelection::sets(const PersistenceRun& run) const {
  const std::vector<Rational> gaps = gaps_of(run);
  const std::vector<bool> is_large = among_largest(gaps, largest_gaps_.value_or(gaps.size()));
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const Rational& value = run.persistence.squared_value(run.stable.record(i));
    const bool is_small = !radius_below_ || (*radius_below_ > 0 && value < *radius_below_ * *radius_below_);
    const bool lasts = !persistence_above_ || gaps[i] > *persistence_above_;
    if (is_large[i] && is_small && lasts) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace flowcert
