// Compares sorted lists. Pairs that only one list has are put beside pairs that only the other has.
#include "flowcert/pair_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "certify/finding_words.h"

namespace flowcert {

using namespace certify;

namespace {

// A message shows at most this many characters of a number.
constexpr std::size_t kLongestPairNumber = 60;

// A value beyond the doubles stays exact. No claim in text can have such a value.
Rational rounded(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? Rational(*nearest) : value;
}

std::vector<ListedPair> in_order(std::vector<ListedPair> pairs, bool is_rounded) {
  for (ListedPair& pair : pairs) {
    if (!is_rounded) break;
    pair.birth = rounded(pair.birth);
    if (pair.death) pair.death = rounded(*pair.death);
  }
  std::erase_if(pairs, [](const ListedPair& pair) { return pair.death == pair.birth; });
  std::ranges::sort(pairs, is_before);
  return pairs;
}

std::string number_words(const Rational& value, bool is_rounded) {
  std::string text = is_rounded && nearest_double(value) ? fmt::format("{}", *nearest_double(value)) : to_text(value);
  return shortened(std::move(text), kLongestPairNumber);
}

// In each dimension, the first pair of one list goes with the first pair of the other, and so on.
std::vector<PairDifference> differences_of(const std::vector<ListedPair>& claimed, const std::vector<ListedPair>& truth,
                                           bool is_rounded) {
  const auto words = [&](const std::vector<ListedPair>& pairs, std::size_t k) -> std::string {
    if (k >= pairs.size()) return "no such pair";
    const ListedPair& pair = pairs[k];
    return fmt::format("dimension {}, birth {}, death {}", pair.dimension, number_words(pair.birth, is_rounded),
                       pair.death ? number_words(*pair.death, is_rounded) : "inf");
  };
  std::vector<PairDifference> differences;
  for (int dimension = 0; dimension < kPairDimensions; ++dimension) {
    std::vector<ListedPair> a, b;
    const auto is_of = [&](const ListedPair& pair) { return pair.dimension == dimension; };
    std::ranges::copy_if(claimed, std::back_inserter(a), is_of);
    std::ranges::copy_if(truth, std::back_inserter(b), is_of);
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
      differences.push_back({words(a, k), words(b, k)});
    }
  }
  return differences;
}

}  // namespace

std::vector<PairDifference> pair_differences(const PairList& claimed, const std::vector<ListedPair>& truth) {
  const std::vector<ListedPair> a = in_order(claimed.pairs, claimed.is_rounded);
  const std::vector<ListedPair> b = in_order(truth, claimed.is_rounded);
  std::vector<ListedPair> only_a, only_b;
  std::ranges::set_difference(a, b, std::back_inserter(only_a), is_before);
  std::ranges::set_difference(b, a, std::back_inserter(only_b), is_before);
  return differences_of(only_a, only_b, claimed.is_rounded);
}

}  // namespace flowcert
