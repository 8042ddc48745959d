#include "io/cycles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <utility>

#include "geometry/difference_of_roots.h"
#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "geometry/parallel_for.h"
#include "io/coordinate_rounding.h"
#include "io/layer.h"
#include "io/number_text.h"
#include "morse/log_histogram.h"
#include "morse/longest_pairs.h"
#include "morse/saddle_radii.h"

namespace flowcert {

using namespace io;

// ---- What people write ----

CycleLevel cycle_level_of(std::string_view text, const std::string& option) {
  using Kind = CycleLevel::Kind;
  if (text == "birth") return {Kind::kShare, 0};
  if (text == "death") return {Kind::kDeath, 0};
  const bool is_share = text.ends_with('%');
  const std::string_view digits = is_share ? text.substr(0, text.size() - 1) : text;
  const auto refuse = [&](const char* reason) { throw InvalidInput(option + ": " + reason + ": " + in_quotes(text)); };
  CycleLevel level{is_share ? Kind::kShare : Kind::kDistance, 0};
  try {
    level.number = claimed_number(digits, PlainInteger::kExact, {option, 1}).value;
  } catch (const InvalidInput&) {
    refuse("neither a number, nor a share like 25%, nor birth or death");
  }
  if (is_share) level.number /= 100;
  if (level.number < 0) refuse("less than 0");
  if (is_share && level.number >= 1) refuse("a share is less than 100%; death asks for the death point's own surface");
  return level;
}

PairName pair_name_of(std::string_view text, const std::string& option) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    throw InvalidInput(option + ": not two lists of rows like 3,17/5,8,20: " + in_quotes(text));
  }
  PairName name;
  for (const std::size_t end : {0U, 1U}) {
    std::string_view left = end == 0 ? text.substr(0, slash) : text.substr(slash + 1);
    while (true) {
      const std::size_t comma = left.find(',');
      name[end].push_back(claimed_id(left.substr(0, comma), {option, 1}));
      if (comma == std::string_view::npos) break;
      left = left.substr(comma + 1);
    }
    geometry::keep_unique(name[end]);
  }
  return name;
}

namespace {

// ---- Which pairs ----

std::string text_of(std::span<const PointId> contact) { return fmt::format("{}", fmt::join(contact, ",")); }

PersistencePair named_pair(const FlowComplex& complex, const PairName& name, int dimension) {
  const std::vector<PersistencePair>& pairs = complex.persistence().pairs();
  const StationaryPoints& stationary = complex.stationary();
  const auto has_name = [&](std::uint32_t record, std::size_t end) {
    return std::ranges::equal(stationary.contact(record), name[end]);
  };
  const auto born = std::ranges::find_if(pairs, [&](const PersistencePair& pair) { return has_name(pair.birth, 0); });
  if (born != pairs.end()) {
    if (!born->death) throw InvalidInput(fmt::format("no such pair: what is born at {} lasts", text_of(name[0])));
    if (!has_name(*born->death, 1)) {
      throw InvalidInput(fmt::format("no such pair: what is born at {} dies at {}", text_of(name[0]),
                                     text_of(stationary.contact(*born->death))));
    }
    if (born->dimension == dimension) return *born;
    throw InvalidInput(fmt::format("no such pair: its dimension is {}", born->dimension));
  }
  const auto dead =
      std::ranges::find_if(pairs, [&](const PersistencePair& pair) { return pair.death && has_name(*pair.death, 1); });
  if (dead != pairs.end()) {
    throw InvalidInput(fmt::format("no such pair: what dies at {} is born at {}", text_of(name[1]),
                                   text_of(stationary.contact(dead->birth))));
  }
  throw InvalidInput(
      fmt::format("no such pair: nothing is born at {} or dies at {}", text_of(name[0]), text_of(name[1])));
}

// Those of these pairs that are longer, from the longest one down.
std::vector<PersistencePair> longer_pairs(const FlowComplex& complex, const std::vector<PersistencePair>& pairs,
                                          const LengthBound& bound) {
  std::vector<PairEnds> ends;
  for (const PersistencePair& pair : pairs) ends.push_back({pair.birth, pair.death.value()});
  const SquaredDistances& values = complex.persistence().squared_distances();
  const ValueOrder order = length_order(values, std::move(ends));
  const auto square =
      threshold_of(bound, order, squared_spacing(complex, values), length_rounding(complex.points())).squared_length;
  const std::size_t too_short = square ? order.count_up_to(*square) : 0;
  std::vector<PersistencePair> longer;
  for (std::size_t k = order.size(); k > too_short; --k) longer.push_back(pairs[order.at(k - 1)]);
  return longer;
}

std::vector<PersistencePair> chosen_pairs(const FlowComplex& complex, const CycleChoice& choice) {
  const Persistence& persistence = complex.persistence();
  const SquaredDistances& values = persistence.squared_distances();
  const bool is_at_distance = choice.dimension > 0 && choice.level.kind == CycleLevel::Kind::kDistance;
  const Rational level = is_at_distance ? Rational(choice.level.number * choice.level.number) : Rational(0);
  const auto is_there = [&](const PersistencePair& pair) {
    return !is_at_distance || (values.compare(pair.birth, level) <= 0 && values.compare(*pair.death, level) > 0);
  };
  if (choice.pair) {
    const PersistencePair pair = named_pair(complex, *choice.pair, choice.dimension);
    if (!is_there(pair)) throw InvalidInput("the pair is not there at this level");
    return {pair};
  }
  std::vector<PersistencePair> pairs, there;
  for (const PersistencePair& pair : persistence.pairs()) {
    if (pair.dimension != choice.dimension || !pair.death) continue;
    pairs.push_back(pair);
  }
  std::ranges::copy_if(pairs, std::back_inserter(there), is_there);
  if (!choice.longer_than) return longest_pairs(values, there, choice.longest);
  // The bound is of all pairs, whatever the level.
  std::vector<PersistencePair> chosen = longer_pairs(complex, pairs, *choice.longer_than);
  std::erase_if(chosen, [&](const PersistencePair& pair) { return !is_there(pair); });
  return chosen;
}

// ---- What stands for each ----

class CycleMaker {
 public:
  CycleMaker(const FlowComplex& complex, const CycleChoice& choice)
      : level_(choice.level), persistence_(complex.persistence()) {
    if (choice.dimension == 1) {
      loops_.emplace(complex.stationary(), complex.links(), persistence_);
    } else {
      trees_ = &complex.merge_trees();
    }
    if (choice.dimension == 2) {
      voids_.emplace(*trees_);
      parents_ = trees_->pockets().parents();
    }
  }

  [[nodiscard]] Cycle of(const PersistencePair& pair) const {
    if (pair.dimension == 0) return {pair, std::nullopt, components_at(*trees_, *pair.death)};
    SquaredLevel level = level_of(pair);
    if (pair.dimension == 2) {
      Void space = voids_->at(*pair.death, level);
      return {pair, std::move(level), std::move(space)};
    }
    LoopCycle loop;
    loop.surface = loops_->surface(pair, level);
    loop.edges = loops_->boundary(loop.surface);
    loop.polygons = loops_->polygons(loop.edges);
    return {pair, std::move(level), std::move(loop)};
  }

 private:
  [[nodiscard]] SquaredLevel level_of(const PersistencePair& pair) const {
    const SquaredDistances& values = persistence_.squared_distances();
    switch (level_.kind) {
      case CycleLevel::Kind::kShare:
        return {values, pair.birth, *pair.death, level_.number};
      case CycleLevel::Kind::kDistance:
        return Rational(level_.number * level_.number);
      case CycleLevel::Kind::kDeath:
        break;
    }
    const std::uint32_t value = pair.dimension == 1 ? last_edge(*pair.death) : first_gate(*pair.death);
    return {values, value, value, 0};
  }

  // The one of the greatest value in the boundary of an index-2 point.
  [[nodiscard]] std::uint32_t last_edge(std::uint32_t saddle) const {
    const auto edges = loops_->boundary(std::vector{saddle});
    const auto rank = [&](std::uint32_t edge) { return persistence_.squared_distances().rank(edge); };
    return *std::ranges::max_element(edges, {}, rank);
  }
  // Where a maximum joins others first.
  [[nodiscard]] std::uint32_t first_gate(std::uint32_t maximum) const {
    const MergeTree& tree = trees_->pockets();
    return tree.nodes[parents_[maximum - trees_->record_of(0)] - tree.leaves].points.front();
  }

  const CycleLevel& level_;
  const Persistence& persistence_;
  const MergeTrees* trees_ = nullptr;
  std::vector<std::uint32_t> parents_;
  std::optional<Loops> loops_;
  std::optional<Voids> voids_;
};

}  // namespace

std::vector<Cycle> cycles(const FlowComplex& complex, const CycleChoice& choice, const Progress& progress) {
  const geometry::IeeeDoubles ieee;
  const std::vector<PersistencePair> pairs = chosen_pairs(complex, choice);
  if (pairs.empty()) return {};
  const CycleMaker maker(complex, choice);
  std::vector<Cycle> found(pairs.size());
  std::mutex telling;
  std::size_t done = 0;
  geometry::parallel_for(pairs.size(), complex.threads(), [&](std::size_t k) {
    found[k] = maker.of(pairs[k]);
    if (!progress) return;
    const std::lock_guard lock(telling);
    progress(++done, pairs.size());
  });
  return found;
}

double loop_length(const FlowComplex& complex, const LoopCycle& loop) {
  const geometry::IeeeDoubles ieee;
  const SquaredDistances& values = complex.persistence().squared_distances();
  double length = 0;
  // An edge is twice as long as the distance from its ends to its midpoint.
  for (const std::uint32_t edge : loop.edges) {
    length += 2 * geometry::nearest_difference_of_roots(values.exact(edge), 0);
  }
  return length;
}

}  // namespace flowcert
