#include "flowcert/persistence.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory_resource>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/portions.h"
#include "geometry/prefetch.h"
#include "morse/layer.h"

namespace flowcert {

using namespace morse;

namespace {

using Record = std::uint32_t;
constexpr Record kNone = Persistence::kNone;

// Components of elements, of which those with lower numbers are older. Each is known by its eldest element.
class Components {
 public:
  explicit Components(std::size_t count) : elder_(count) { std::iota(elder_.begin(), elder_.end(), Record{0}); }

  // Makes two components one. Returns the eldest of the younger one; nothing if they are one already.
  std::optional<Record> merge(Record a, Record b) {
    a = eldest(a);
    b = eldest(b);
    if (a == b) return std::nullopt;
    elder_[std::max(a, b)] = std::min(a, b);
    return std::max(a, b);
  }
  void prefetch(Record element) const { __builtin_prefetch(&elder_[element]); }

 private:
  Record eldest(Record element) {
    while (elder_[element] != element) element = elder_[element] = elder_[elder_[element]];
    return element;
  }

  std::vector<Record> elder_;  // of each element: an older one of its component, or itself
};

class Pairing {
 public:
  Pairing(const PointSet& points, const StationaryPoints& stationary, const SaddleLinks& links,
          const SquaredDistances& values)
      : points_(points), stationary_(stationary), links_(links), partner_(stationary.size(), kNone) {
    std::size_t first = 0;
    for (std::size_t index = 0; index < 4; ++index) {
      first_[index] = static_cast<Record>(first);
      ascending_[index].reserve(stationary.critical_counts()[index]);
      first += stationary.critical_counts()[index];
    }
    for (const Record record : values.ascending()) {
      if (record >= first) continue;  // regular
      ascending_[static_cast<std::size_t>(index_of(record))].push_back(record);
    }
  }

  // The other point of each critical point's pair.
  [[nodiscard]] std::vector<Record>& partners() { return partner_; }
  [[nodiscard]] std::vector<ColumnAddition>& additions() { return additions_; }

  std::vector<PersistencePair> pairs(unsigned threads) {
    geometry::parallel_for(2, threads, [this](std::size_t k) { k == 0 ? pair_components() : pair_voids(); });
    pair_tunnels(threads);
    // A record of a lower index is born.
    std::vector<PersistencePair> pairs;
    for (Record record = 0; record < first_[3]; ++record) {
      const int index = index_of(record);
      const Record partner = partner_[record];
      if (partner != kNone && partner > record) pairs.push_back({index, record, partner});
      if (partner == kNone && index == 0) pairs.push_back({index, record, std::nullopt});
    }
    return pairs;
  }

 private:
  [[nodiscard]] std::span<const Record> lower(Record saddle) const { return links_.lower(saddle - first_[2]); }
  [[nodiscard]] const std::array<Record, 2>& upper(Record saddle) const { return links_.upper(saddle - first_[2]); }
  int index_of(Record record) const {
    return static_cast<int>(std::ranges::upper_bound(first_, record) - first_.begin()) - 1;
  }
  void add(Record birth, Record death) {
    partner_[birth] = death;
    partner_[death] = birth;
  }

  // All samples are born at 0; the one listed later dies.
  void pair_components() {
    // Critical points of index 0 are listed by name, as the ordinals of the point set are.
    std::vector<std::array<Record, 2>> samples(ascending_[1].size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const auto contact = stationary_.contact(first_[1] + k);
      for (const std::size_t end : {0U, 1U}) {
        samples[k][end] = static_cast<Record>(points_.ordinal_of_row(contact[end]));
      }
    }
    Components components(ascending_[0].size());
    const auto samples_of = [&](Record edge) { return &samples[edge - first_[1]]; };
    const auto merge = [&](Record edge) {
      const auto [one, other] = *samples_of(edge);
      if (const auto dies = components.merge(one, other)) add(*dies, edge);
    };
    const auto prefetch_components = [&](Record edge) {
      for (const Record sample : *samples_of(edge)) components.prefetch(sample);
    };
    geometry::in_blocks(
        std::span<const Record>(ascending_[1]), merge, [&](Record edge) { __builtin_prefetch(samples_of(edge)); },
        prefetch_components);
  }

  // Going down in value, two voids come together at the index-2 point that separates them. That point is
  // paired with the lower maximum. Infinity is the eldest.
  void pair_voids() {
    const std::vector<Record>& maxima = ascending_[3];
    std::vector<Record> age(maxima.size());
    for (Record k = 0; k < maxima.size(); ++k) age[maxima[k] - first_[3]] = static_cast<Record>(maxima.size()) - k;
    const auto age_of = [&](Record maximum) {
      return maximum == SaddleLinks::kInfinity ? 0 : age[maximum - first_[3]];
    };
    Components voids(maxima.size() + 1);
    const auto merge = [&](Record saddle) {
      const auto& [one, other] = upper(saddle);
      if (const auto dies = voids.merge(age_of(one), age_of(other))) add(saddle, maxima[maxima.size() - *dies]);
    };
    const auto prefetch_ages = [&](Record saddle) {
      for (const Record maximum : upper(saddle)) {
        if (maximum != SaddleLinks::kInfinity) __builtin_prefetch(&age[maximum - first_[3]]);
      }
    };
    const auto prefetch_voids = [&](Record saddle) {
      for (const Record maximum : upper(saddle)) voids.prefetch(age_of(maximum));
    };
    const std::vector<Record> descending(ascending_[2].rbegin(), ascending_[2].rend());
    geometry::in_blocks(
        std::span(descending), merge, [&](Record saddle) { __builtin_prefetch(&upper(saddle)); }, prefetch_ages,
        prefetch_voids);
  }

  // A sum of index-1 points that close a tunnel. Each is given by its place among these; places ascend. The saddle is
  // the index-2 point that the sum belongs to.
  struct Column {
    const Record* places = nullptr;
    std::uint32_t size = 0;
    Record saddle = kNone;

    [[nodiscard]] std::span<const Record> all() const { return {places, size}; }
    [[nodiscard]] Record last() const { return places[size - 1]; }
  };

  // The columns of index-2 points before anything is added to them. Each part of these has memory of its own.
  [[nodiscard]] std::vector<Column> boundaries(std::span<const Record> saddles, std::span<const Record> place_of,
                                               unsigned threads, std::vector<std::vector<Record>>& memory) const {
    constexpr std::size_t kPart = geometry::portion_size(1U << 12);
    std::vector<Column> columns(saddles.size());
    memory.resize((saddles.size() + kPart - 1) / kPart);
    geometry::parallel_for(memory.size(), threads, [&](std::size_t part) {
      const auto mine = saddles.subspan(part * kPart, std::min(kPart, saddles.size() - part * kPart));
      const auto columns_of_mine = std::span(columns).subspan(part * kPart, mine.size());
      std::vector<Record>& places = memory[part];
      auto column = columns_of_mine.begin();
      const auto gather = [&](Record saddle) {
        const std::size_t begin = places.size();
        for (const Record edge : lower(saddle)) {
          if (const Record place = place_of[edge - first_[1]]; place != kNone) places.push_back(place);
        }
        std::sort(places.begin() + static_cast<std::ptrdiff_t>(begin), places.end());
        *column++ = {nullptr, static_cast<std::uint32_t>(places.size() - begin), saddle};
      };
      geometry::in_blocks(
          mine, gather, [&](Record saddle) { links_.prefetch_lower(saddle - first_[2]); },
          [&](Record saddle) { __builtin_prefetch(lower(saddle).data()); },
          [&](Record saddle) {
            for (const Record edge : lower(saddle)) __builtin_prefetch(&place_of[edge - first_[1]]);
          });
      // From here on the memory stays where it is.
      const Record* next = places.data();
      for (Column& done : columns_of_mine) done.places = std::exchange(next, next + done.size);
    });
    return columns;
  }

  void pair_tunnels(unsigned threads) {
    std::vector<Record> edge_at;
    std::vector<Record> place_of(ascending_[1].size(), kNone);
    for (const Record edge : ascending_[1]) {
      if (partner_[edge] != kNone) continue;
      place_of[edge - first_[1]] = static_cast<Record>(edge_at.size());
      edge_at.push_back(edge);
    }
    std::vector<Record> killing = ascending_[2];
    std::erase_if(killing, [this](Record saddle) { return partner_[saddle] != kNone; });
    std::vector<std::vector<Record>> memory;
    const std::vector<Column> columns = boundaries(killing, place_of, threads, memory);
    std::vector<Column> column_of(edge_at.size());  // by its last place
    std::pmr::monotonic_buffer_resource sums;       // most columns need none
    std::vector<Record> one, other;
    const auto reduce = [&](Column column) {
      while (column.size > 0 && column_of[column.last()].size > 0) {
        const Column& added = column_of[column.last()];
        additions_.push_back({column.saddle, added.saddle});
        other.clear();
        std::ranges::set_symmetric_difference(column.all(), added.all(), std::back_inserter(other));
        one.swap(other);
        column = {one.data(), static_cast<std::uint32_t>(one.size()), column.saddle};
      }
      if (column.size == 0) throw std::logic_error("an index-2 point that neither opens a void nor fills a tunnel");
      if (column.places == one.data()) {
        auto* kept = static_cast<Record*>(sums.allocate(column.size * sizeof(Record), alignof(Record)));
        std::ranges::copy(column.all(), kept);
        column.places = kept;
      }
      column_of[column.last()] = column;
    };
    const auto prefetch_sum = [&](const Column& column) {
      if (column.size > 0) __builtin_prefetch(column_of[column.last()].places);
    };
    geometry::in_blocks(
        std::span(columns), reduce,
        [&](const Column& column) {
          if (column.size > 0) __builtin_prefetch(&column_of[column.last()]);
        },
        prefetch_sum);
    for (std::size_t place = 0; place < edge_at.size(); ++place) {
      if (column_of[place].size > 0) add(edge_at[place], column_of[place].saddle);
    }
  }

  const PointSet& points_;
  const StationaryPoints& stationary_;
  const SaddleLinks& links_;
  std::array<Record, 4> first_{};                 // by index: the first critical point
  std::array<std::vector<Record>, 4> ascending_;  // by index: by value, then by place in the list
  std::vector<Record> partner_;                   // kNone: there is none, or none yet
  std::vector<ColumnAddition> additions_;
};

}  // namespace

Persistence::Persistence(const PointSet& points, const StationaryPoints& stationary, const SaddleLinks& links,
                         unsigned threads)
    : distances_(points, stationary, threads) {
  const geometry::IeeeDoubles ieee;
  Pairing pairing(points, stationary, links, distances_);
  pairs_ = pairing.pairs(threads);
  partner_ = std::move(pairing.partners());
  additions_ = std::move(pairing.additions());
}

Persistence::Persistence(const PointSet& points, const StationaryPoints& stationary, const ChainComplex& complex,
                         unsigned threads)
    : Persistence(points, stationary, SaddleLinks(stationary, complex), threads) {}

}  // namespace flowcert
