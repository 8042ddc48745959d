// Collects stationary points in whatever order they are found, and hands them out in the one order that spec
// clause FC-OUT-02 fixes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/stationary_points.h"
#include "morse/layer.h"
#include "voronoi/compact_delaunay.h"

namespace flowcert::morse {

class OrderedRecords {
 public:
  // ordinals has the ordinal of each vertex in the point set, and must outlive this.
  explicit OrderedRecords(std::span<const std::uint32_t> ordinals) : ordinals_(ordinals) {}
  // An empty one for the same ordinals, with room for what `parts` of them find in all.
  [[nodiscard]] OrderedRecords empty_part(std::size_t parts) const;

  // The contact set may come in any order. Index 0 is not added, because the points themselves give it.
  void add(StationaryIndex index, std::span<const VertexIndex> contact, std::uint32_t face);

  // Adds all of another one for the same ordinals.
  void take(OrderedRecords other);

  // O(records) expected: records are spread over buckets by their first point, and few share one.
  [[nodiscard]] StationaryPoints list(const PointSet& points, unsigned threads) const;

 private:
  // Few contact sets have more than four points. The smaller ones are kept in the record that is sorted, so that
  // sorting does not have to look elsewhere.
  struct Record {
    std::uint32_t size;
    std::uint32_t face;  // record_finder.h
    std::array<std::uint32_t, 4>
        small;  // ordinals, ascending; for more than four: the first one, and the place in large_
  };
  static constexpr std::array<StationaryIndex, 6> kOrder = {{{1, 1}, {2, 2}, {3, 3}, {1, 2}, {1, 3}, {2, 3}}};

  [[nodiscard]] std::span<const std::uint32_t> contact(const Record& record) const {
    if (record.size > record.small.size()) return large_[record.small[1]];
    return std::span(record.small).first(record.size);
  }
  // Compares two records with the same first point. The second and the third one mostly decide.
  [[nodiscard]] bool is_less(const Record& a, const Record& b) const {
    const auto key = [](const Record& record) { return std::uint64_t{record.small[1]} << 32 | record.small[2]; };
    const bool are_small = std::max(a.size, b.size) <= a.small.size();
    if (are_small && key(a) != key(b)) return key(a) < key(b);
    return std::ranges::lexicographical_compare(contact(a), contact(b));
  }
  using BySlot = std::array<std::vector<Record>, kOrder.size()>;

  // Calls use(record) for the records of this object, and for those that it has taken.
  void for_each_record(std::size_t slot, const auto& use) const {
    std::ranges::for_each(records_[slot], use);
    for (const BySlot& taken : taken_) std::ranges::for_each(taken[slot], use);
  }
  void sort(std::size_t slot, std::span<Record> result) const;

  BySlot records_;
  std::vector<BySlot> taken_;
  std::span<const std::uint32_t> ordinals_;
  std::vector<std::vector<std::uint32_t>> large_;
};

}  // namespace flowcert::morse
