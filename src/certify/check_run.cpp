// The stationary points of each sample are listed side by side.
#include "certify/check_run.h"

#include <algorithm>

#include "geometry/contract.h"

namespace flowcert::certify {

ContactIndex::ContactIndex(const PointSet& points, const Truth& truth)
    : points_(points), truth_(truth), first_(points.size() + 1, 0) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (const PointId name : truth.contact(i)) ++first_[points.ordinal_of_row(name) + 1];
  }
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  records_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (const PointId name : truth.contact(i)) {
      records_[next[points.ordinal_of_row(name)]++] = static_cast<std::uint32_t>(i);
    }
  }
}

std::span<const std::uint32_t> ContactIndex::fewest(std::span<const PointId> names) const {
  FLOWCERT_REQUIRES(!names.empty() && std::ranges::is_sorted(names));
  std::span<const std::uint32_t> best = of(names.front());
  for (const PointId name : names.subspan(1)) {
    if (of(name).size() < best.size()) best = of(name);
  }
  return best;
}

std::optional<std::size_t> ContactIndex::find(std::span<const PointId> names) const {
  for (const std::uint32_t i : fewest(names)) {
    if (std::ranges::equal(truth_.contact(i), names)) return i;
  }
  return std::nullopt;
}

std::vector<std::size_t> ContactIndex::larger(std::span<const PointId> names) const {
  std::vector<std::size_t> result;
  for (const std::uint32_t i : fewest(names)) {
    const auto contact = truth_.contact(i);
    if (contact.size() > names.size() && std::ranges::includes(contact, names)) result.push_back(i);
  }
  return result;
}

}  // namespace flowcert::certify
