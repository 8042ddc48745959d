// This is our own, because RapidCheck's trees of smaller values come with a generator. A mutant has no generator, nor
// has an input from a file.
#include "fuzz/campaign/shrinking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace flowcert::fuzz {
namespace {

using property::Disagreement;
using property::StartChoice;
using property::Trial;

// What a coordinate costs: an integer costs less than a fraction, and a small number less than a large one.
double cost_of(double value) {
  const double size = std::fabs(value);
  if (size == 0) return 0;
  const bool is_integer = size < 0x1p53 && std::floor(size) == size;
  return (is_integer ? 0 : 4000) + 1 + 2 * std::abs(std::ilogb(size)) + (value < 0 ? 0.5 : 0);
}

double cost_of(const Input& input) {
  double cost = 0;
  for (const Row& row : input.rows) {
    for (const double value : row) cost += cost_of(value);
  }
  return cost;
}

class Shrinking {
 public:
  Shrinking(const Trial& failing, const Disagreement& disagreement, const Judge& judge, std::size_t budget)
      : best_{failing, disagreement}, judge_(judge), budget_(budget) {}

  Shrunk result() {
    bool was_smaller = true;
    while (was_smaller && best_.judged < budget_) {
      was_smaller = fewer_rows();
      was_smaller = smaller_coordinates() || was_smaller;
      was_smaller = simpler_choice() || was_smaller;
    }
    best_.is_budget_up = best_.is_budget_up || was_smaller;
    fix_start();
    return std::move(best_);
  }

 private:
  bool accept(Trial candidate) {
    if (best_.judged >= budget_) {
      best_.is_budget_up = true;
      return false;
    }
    ++best_.judged;
    std::optional<Disagreement> found = judge_(candidate);
    if (!found || found->kind != best_.disagreement.kind) return false;
    best_.trial = std::move(candidate);
    best_.disagreement = *std::move(found);
    return true;
  }

  // Leaves out blocks of rows, large ones first, as often as the case still fails.
  bool fewer_rows() {
    const std::size_t before = best_.trial.input.rows.size();
    for (std::size_t block = before / 2; block >= 1; block /= 2) {
      for (std::size_t first = 0; first + block <= best_.trial.input.rows.size();) {
        Trial candidate = best_.trial;
        auto& rows = candidate.input.rows;
        const auto from = rows.begin() + static_cast<std::ptrdiff_t>(first);
        rows.erase(from, from + static_cast<std::ptrdiff_t>(block));
        if (!accept(std::move(candidate))) first += std::max<std::size_t>(1, block / 16);  // it is 1 for small inputs
      }
    }
    return best_.trial.input.rows.size() < before;
  }

  bool smaller_coordinates() {
    bool was_smaller = false;
    while (smaller_as_a_whole()) was_smaller = true;
    for (std::size_t row = 0; row < best_.trial.input.rows.size(); ++row) {
      for (std::size_t axis = 0; axis < 3; ++axis) was_smaller = smaller_coordinate(row, axis) || was_smaller;
    }
    return was_smaller;
  }

  bool accept_if_cheaper(Input input) {
    for (Row& row : input.rows) {
      for (double& value : row) {
        if (!std::isfinite(value)) return false;
        value += 0.0;  // -0.0 becomes 0.0
      }
    }
    const bool is_cheaper = cost_of(input) < cost_of(best_.trial.input);
    return is_cheaper && accept({std::move(input), best_.trial.start});
  }

  template <typename Map>
  bool accept_mapped(const Map& map) {
    Input input = best_.trial.input;
    for (Row& row : input.rows) {
      for (std::size_t axis = 0; axis < 3; ++axis) row.at(axis) = map(axis, row.at(axis));
    }
    return accept_if_cheaper(std::move(input));
  }

  // Tries to flatten an axis, to move a row to the origin, to use other units, and to round to integers.
  bool smaller_as_a_whole() {
    for (std::size_t flat = 0; flat < 3; ++flat) {
      if (accept_mapped([&](std::size_t axis, double value) { return axis == flat ? 0.0 : value; })) return true;
    }
    for (const Row origin : best_.trial.input.rows) {
      if (accept_mapped([&](std::size_t axis, double value) { return value - origin.at(axis); })) return true;
    }
    for (const double factor :
         {0x1p-512, 0x1p-64, 0x1p-16, 0.125, 0.5, 2.0, 1024.0, 0x1p64, 0x1p512, 1 / 3.0, 0.2, 0.1, 10.0}) {
      const auto times = [&](std::size_t, double value) { return value * factor; };
      if (accept_mapped(times)) return true;
      if (accept_mapped([&](std::size_t axis, double value) { return std::nearbyint(times(axis, value)); })) {
        return true;
      }
    }
    return accept_mapped([](std::size_t, double value) { return std::nearbyint(value); });
  }

  bool smaller_coordinate(std::size_t row, std::size_t axis) {
    bool was_smaller = false;
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      const double value = best_.trial.input.rows.at(row).at(axis);
      for (const double next :
           {0.0, std::nearbyint(value), std::trunc(value / 2), std::trunc(value) - 1, std::trunc(value) + 1, -value}) {
        Input input = best_.trial.input;
        input.rows.at(row).at(axis) = next;
        if (accept_if_cheaper(std::move(input))) {
          goes_on = was_smaller = true;
          break;
        }
      }
    }
    return was_smaller;
  }

  // The numbers of a choice are indices and offsets. 0 is the simplest one.
  bool simpler_choice() {
    if (!std::holds_alternative<StartChoice>(best_.trial.start)) return false;
    bool was_simpler = false;
    const std::size_t count = std::get<StartChoice>(best_.trial.start).numbers.size();
    for (std::size_t k = 0; k < count; ++k) {
      StartChoice choice = std::get<StartChoice>(best_.trial.start);
      if (choice.numbers[k] == 0) continue;
      choice.numbers[k] = 0;
      was_simpler = accept({best_.trial.input, choice}) || was_simpler;
    }
    return was_simpler;
  }

  // Turns the start into coordinates, and these into integers if the case still fails.
  void fix_start() {
    if (best_.trial.input.rows.empty()) return;
    best_.trial.start = property::start_of(best_.trial);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& start = std::get<oracle::Point>(best_.trial.start);
      const oracle::Rational value = start.at(axis);
      const oracle::Integer whole = numerator(value) / denominator(value);
      for (const oracle::Rational& next : {oracle::Rational(0), oracle::Rational(whole)}) {
        oracle::Point moved = std::get<oracle::Point>(best_.trial.start);
        if (moved.at(axis) == next || moved.at(axis) == 0) continue;
        moved.at(axis) = next;
        if (accept({best_.trial.input, moved})) break;
      }
    }
  }

  Shrunk best_;
  const Judge& judge_;
  std::size_t budget_;
};

}  // namespace

Shrunk shrunk(const Trial& failing, const Disagreement& disagreement, const Judge& judge, std::size_t budget) {
  return Shrinking(failing, disagreement, judge, budget).result();
}

}  // namespace flowcert::fuzz
