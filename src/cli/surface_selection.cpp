// See surface_selection.h.
#include "cli/surface_selection.h"

#include <algorithm>
#include <numeric>
#include <string_view>

#include "io/claims/claim_numbers.h"
#include "io/number_text.h"

namespace flowcert::cli {

namespace {

constexpr std::string_view kPersistence = "persistence>";
constexpr std::string_view kRadius = "index2-radius<";
constexpr std::string_view kLargestGaps = "largest-gaps=";

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
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

std::vector<std::size_t> SurfaceSelection::sets(const SurfaceRun& run) const {
  std::vector<bool> is_chosen(run.size(), true);
  if (radius_below_) {
    const Rational& bound = *radius_below_;
    for (std::size_t i = 0; i < is_chosen.size(); ++i) {
      is_chosen[i] = bound > 0 && run.squared_value(i) < bound * bound;
    }
  }
  if (persistence_above_ || largest_gaps_) {
    const std::vector<Rational> gaps = run.gaps();
    const std::vector<bool> is_large = among_largest(gaps, largest_gaps_.value_or(gaps.size()));
    for (std::size_t i = 0; i < is_chosen.size(); ++i) {
      const bool is_long = !persistence_above_ || gaps[i] > *persistence_above_;
      is_chosen[i] = is_chosen[i] && is_large[i] && is_long;
    }
  }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < is_chosen.size(); ++i) {
    if (is_chosen[i]) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace flowcert::cli
