// Boost's union-find over 0 … n-1, with the memory that it works on.
#pragma once

#include <boost/pending/disjoint_sets.hpp>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace flowcert::geometry {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : rank_(n, 0), parent_(n), sets_(rank_.data(), parent_.data()) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  // Boost's part points into the memory of this one.
  DisjointSets(const DisjointSets&) = delete;
  DisjointSets& operator=(const DisjointSets&) = delete;

  // The representative of the set that i is in.
  [[nodiscard]] std::uint32_t find(std::uint32_t i) { return sets_.find_set(i); }
  void unite(std::uint32_t i, std::uint32_t j) { sets_.union_set(i, j); }

 private:
  std::vector<std::uint8_t> rank_;
  std::vector<std::uint32_t> parent_;
  boost::disjoint_sets<std::uint8_t*, std::uint32_t*> sets_;
};

}  // namespace flowcert::geometry
