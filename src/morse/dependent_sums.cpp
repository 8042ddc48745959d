#include "morse/dependent_sums.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace flowcert::morse {

namespace {

std::vector<std::uint32_t> sum_of(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::vector<std::uint32_t> sum;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(sum));
  return sum;
}

}  // namespace

std::vector<bool> dependent_sums(std::span<const std::vector<std::uint32_t>> sums) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> kept;  // by the last item
  std::vector<bool> are_dependent;
  for (std::vector<std::uint32_t> sum : sums) {
    while (!sum.empty() && kept.contains(sum.back())) sum = sum_of(sum, kept.at(sum.back()));
    are_dependent.push_back(sum.empty());
    if (!sum.empty()) kept.emplace(sum.back(), sum);
  }
  return are_dependent;
}

}  // namespace flowcert::morse
