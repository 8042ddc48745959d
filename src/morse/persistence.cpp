#include "flowcert/persistence.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

using Record = std::uint32_t;
constexpr Record kNone = 0xffffffffu;

// Components that know their eldest member.
class Components {
 public:
  // The lower the rank of an element, the older it is.
  explicit Components(std::vector<Record> rank) : rank_(std::move(rank)), eldest_(rank_.size()), sets_(rank_.size()) {
    std::iota(eldest_.begin(), eldest_.end(), Record{0});
  }

  // Makes two components one. Returns the eldest of the younger one; nothing if they are one already.
  std::optional<Record> merge(Record a, Record b) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return std::nullopt;
    Record older = eldest_[a], younger = eldest_[b];
    if (rank_[younger] < rank_[older]) std::swap(older, younger);
    sets_.unite(a, b);
    eldest_[sets_.find(a)] = older;
    return younger;
  }

 private:
  std::vector<Record> rank_, eldest_;
  DisjointSets sets_;
};

class Pairing {
 public:
  Pairing(const StationaryPoints& stationary, const ChainComplex& complex, const SquaredDistances& values)
      : complex_(complex), values_(values), finder_(stationary), partner_(stationary.size(), kNone) {}

  std::vector<PersistencePair> pairs() {
    pair_components();
    pair_voids();
    pair_tunnels();
    return std::move(pairs_);
  }

 private:
  // The critical points of one index, by value, then by place in the list.
  std::vector<Record> sorted(std::uint8_t index) const {
    const auto [first, last] = finder_.range({index, index});
    std::vector<Record> records(last - first);
    std::iota(records.begin(), records.end(), static_cast<Record>(first));
    std::ranges::sort(records, {}, [&](Record record) { return std::pair(values_.rank(record), record); });
    return records;
  }

  void add(int dimension, Record birth, Record death) {
    partner_[birth] = death;
    partner_[death] = birth;
    pairs_.push_back({dimension, birth, death});
  }

  // All samples are born at 0; the one listed later dies.
  void pair_components() {
    const auto [first, last] = finder_.range({0, 0});
    std::vector<Record> rank(last - first);
    std::iota(rank.begin(), rank.end(), Record{0});
    Components components(std::move(rank));
    for (const Record edge : sorted(1)) {
      const auto ends = complex_.boundary(edge);
      if (const auto dies = components.merge(ends[0], ends[1])) add(0, *dies, edge);
    }
    for (Record sample = 0; sample < last; ++sample) {
      if (partner_[sample] == kNone) pairs_.push_back({0, sample, std::nullopt});
    }
  }

  // Going down in value, two voids come together at the index-2 point that separates them. That point is
  // paired with the lower maximum. Infinity is the eldest.
  void pair_voids() {
    const auto first = static_cast<Record>(finder_.range({3, 3}).first);
    const std::vector<Record> maxima = sorted(3);
    const auto infinity = static_cast<Record>(maxima.size());
    std::vector<Record> rank(maxima.size() + 1, 0);
    for (Record k = 0; k < infinity; ++k) rank[maxima[k] - first] = infinity - k;
    Components voids(std::move(rank));
    const auto element = [&](Record limit) { return limit == ChainComplex::kInfinity ? infinity : limit - first; };
    const std::size_t first_saddle = finder_.range({2, 2}).first;
    const std::vector<Record> saddles = sorted(2);
    for (auto saddle = saddles.rbegin(); saddle != saddles.rend(); ++saddle) {
      const auto& limits = complex_.limits()[*saddle - first_saddle];
      if (const auto dies = voids.merge(element(limits[0]), element(limits[1]))) {
        add(2, *saddle, *dies + first);
      }
    }
  }

  // A column is a sum of index-1 points that close a tunnel. Each is given by its place among these; places ascend.
  void pair_tunnels() {
    std::vector<Record> edge_at;
    std::vector<Record> place_of(partner_.size(), kNone);
    for (const Record edge : sorted(1)) {
      if (partner_[edge] != kNone) continue;
      place_of[edge] = static_cast<Record>(edge_at.size());
      edge_at.push_back(edge);
    }
    std::vector<std::vector<Record>> column_of(edge_at.size());  // by its last place
    std::vector<Record> column, sum;
    for (const Record saddle : sorted(2)) {
      if (partner_[saddle] != kNone) continue;
      column.clear();
      for (const Record edge : complex_.boundary(saddle)) {
        if (place_of[edge] != kNone) column.push_back(place_of[edge]);
      }
      std::sort(column.begin(), column.end());
      while (!column.empty() && !column_of[column.back()].empty()) {
        sum.clear();
        std::ranges::set_symmetric_difference(column, column_of[column.back()], std::back_inserter(sum));
        column.swap(sum);
      }
      if (column.empty()) throw std::logic_error("an index-2 point that neither opens a void nor fills a tunnel");
      add(1, edge_at[column.back()], saddle);
      column_of[column.back()] = column;
    }
  }

  const ChainComplex& complex_;
  const SquaredDistances& values_;
  RecordFinder finder_;
  std::vector<Record> partner_;
  std::vector<PersistencePair> pairs_;
};

}  // namespace

Persistence::Persistence(const PointSet& points, const StationaryPoints& stationary, const ChainComplex& complex)
    : distances_(points, stationary) {
  const geometry::IeeeDoubles ieee;
  pairs_ = Pairing(stationary, complex, distances_).pairs();
  std::ranges::sort(pairs_, {}, [](const PersistencePair& pair) { return std::pair(pair.dimension, pair.birth); });
}

}  // namespace flowcert
