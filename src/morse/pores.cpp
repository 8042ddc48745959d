// The merge tree of {d >= s} from index-2 points and their ends, chambers, and windows by the labelled merge.
#include "flowcert/pores.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "morse/ball_ascents.h"
#include "morse/ball_critical_points.h"

namespace flowcert {

using namespace morse;

namespace {

using Numbers = std::vector<std::uint32_t>;

void append(Numbers& numbers, const Numbers& others) { numbers.insert(numbers.end(), others.begin(), others.end()); }

}  // namespace

// Finds all of it. Sets of rooms are kept by a member: a point of index 3, or the outside, which has the number of
// points.
class PoreSearch {
 public:
  PoreSearch(Pores& pores, const Rational& depth, unsigned threads) : pores_(pores), depth_(depth), threads_(threads) {}

  void run() {
    find_points();
    build_tree();
    keep_deep_chambers();
    mark_rooms();
  }

 private:
  struct Side {
    std::uint32_t point;
    Numbers rooms;  // of the ends: points of index 3, or the outside
  };

  // ---- Points ----

  void find_points() {
    const BallSet& balls = *pores_.balls_;
    const BallDiagram diagram(balls);
    const std::vector<BallCriticalPoint> found = ball_critical_points(diagram, threads_);
    std::vector<std::uint32_t> order(found.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
      const auto sign = compare(balls, found[i].value, found[j].value);
      return sign != 0 ? sign > 0 : found[i].contacts < found[j].contacts;
    });
    std::vector<std::uint32_t> number_of(found.size());
    for (std::uint32_t number = 0; number < order.size(); ++number) {
      const BallCriticalPoint& point = found[order[number]];
      number_of[order[number]] = number;
      std::uint32_t rank = 0;
      if (number > 0) {
        const bool is_equal = compare(balls, found[order[number - 1]].value, point.value) == 0;
        rank = pores_.points_.back().rank + (is_equal ? 0 : 1);
      }
      pores_.points_.push_back({point.index, rank, point.contacts});
      near_.push_back(point.value.near());
      pores_.carriers_.push_back({point.carrier, point.corners, static_cast<std::uint8_t>(point.value.root())});
    }
    outside_ = static_cast<std::uint32_t>(order.size());
    BallAscents ascents(diagram, found);
    for (std::uint32_t number = 0; number < order.size(); ++number) {
      if (pores_.points_[number].index != 2) continue;
      Side side{number, {}};
      for (const BallEnds& ends : ascents.ends(found[order[number]])) {
        for (const std::uint32_t end : ends) side.rooms.push_back(end == morse::kOutside ? outside_ : number_of[end]);
      }
      geometry::keep_unique(side.rooms);
      sides_.push_back(std::move(side));
    }
  }

  // Calls use(first, last) for each run of points of index 2 of one value, places in sides_.
  void for_each_value(const auto& use) {
    for (std::size_t first = 0, last = 0; first < sides_.size(); first = last) {
      const std::uint32_t rank = rank_of(sides_[first].point);
      while (last < sides_.size() && rank_of(sides_[last].point) == rank) ++last;
      use(first, last);
    }
  }
  [[nodiscard]] std::uint32_t rank_of(std::uint32_t point) const { return pores_.points_[point].rank; }

  // ---- The tree ----

  // A component of {d > g}.
  struct Component {
    Numbers peaks;     // empty for the outside
    Numbers chambers;  // inside of it, whose exits are not known
  };

  void build_tree() {
    geometry::DisjointSets sets(outside_ + 1);
    std::vector<Component> parts(outside_ + 1);
    for (std::uint32_t number = 0; number < outside_; ++number) {
      if (pores_.points_[number].index == 3) parts[number].peaks = {number};
    }
    for_each_value([&](std::size_t first, std::size_t last) {
      std::map<std::uint32_t, Numbers> gates;  // by component before: the points that touch it and another one
      std::vector<Numbers> links;
      for (std::size_t place = first; place < last; ++place) {
        Numbers before;
        for (const std::uint32_t room : sides_[place].rooms) before.push_back(sets.find(room));
        geometry::keep_unique(before);
        if (before.size() < 2) continue;
        for (const std::uint32_t each : before) gates[each].push_back(sides_[place].point);
        links.push_back(std::move(before));
      }
      for (const Numbers& link : links) {
        for (const std::uint32_t each : link) sets.unite(link[0], each);
      }
      std::map<std::uint32_t, Numbers> joins;
      for (const auto& [part, points] : gates) joins[sets.find(part)].push_back(part);
      for (const auto& [root, children] : joins) join(parts, root, children, gates);
    });
    for (std::uint32_t number = 0; number < outside_; ++number) {
      if (pores_.points_[number].index != 3 || sets.find(number) != number) continue;
      if (sets.find(outside_) == number) continue;
      add_chamber(parts[number], {});
      pores_.cavities_.push_back({std::nullopt, parts[number].peaks[0]});
    }
    std::ranges::sort(pores_.cavities_, {}, [&](const CavityInterval& each) {
      return std::pair(rank_of(each.peak), each.gate ? rank_of(*each.gate) : outside_);
    });
  }

  // Of a bounded component; the outside is before all.
  [[nodiscard]] std::int64_t height(const Component& part) const {
    return part.peaks.empty() ? -1 : static_cast<std::int64_t>(rank_of(part.peaks[0]));
  }

  void join(std::vector<Component>& parts, std::uint32_t root, const Numbers& children,
            const std::map<std::uint32_t, Numbers>& gates) {
    std::int64_t best = std::numeric_limits<std::int64_t>::max();
    for (const std::uint32_t child : children) best = std::min(best, height(parts[child]));
    const auto count = std::ranges::count_if(children, [&](std::uint32_t each) { return height(parts[each]) == best; });
    Component made;
    bool is_one_left_out = false;
    for (const std::uint32_t child : children) {
      Component& part = parts[child];
      const bool is_best = height(part) == best;
      if (!(is_best && count == 1)) add_chamber(part, gates.at(child));
      if (is_best && !is_one_left_out) {
        is_one_left_out = true;
      } else {
        pores_.cavities_.push_back({gates.at(child)[0], part.peaks[0]});
      }
      if (is_best) append(made.peaks, part.peaks);
      append(made.chambers, part.chambers);
    }
    std::ranges::sort(made.peaks);
    if (best < 0) {
      std::uint32_t exit = outside_;
      for (const std::uint32_t child : children) exit = std::min(exit, gates.at(child)[0]);
      for (const std::uint32_t chamber : made.chambers) all_[chamber].exit = exit;
      made.chambers.clear();
    }
    for (const std::uint32_t child : children) parts[child] = {};
    parts[root] = std::move(made);
  }

  void add_chamber(Component& part, const Numbers& gates) {
    part.chambers.push_back(static_cast<std::uint32_t>(all_.size()));
    all_.push_back({part.peaks, gates, std::nullopt, {}, {}});
  }

  // ---- Those of the depth ----

  [[nodiscard]] QuadraticNumber gate_value(const Chamber& chamber) const {
    return chamber.gates.empty() ? QuadraticNumber() : pores_.value(chamber.gates[0]);
  }

  [[nodiscard]] bool is_surely_shallow(const Chamber& chamber) const {
    const BoundedDouble gate = chamber.gates.empty() ? BoundedDouble() : near_[chamber.gates[0]];
    return (near_[chamber.peaks[0]] - gate - bounded(Rational(depth_ * pores_.balls_->scale()))).certain_sign() < 0;
  }

  void keep_deep_chambers() {
    struct Deep {
      double depth;
      Chamber chamber;
    };
    std::vector<Deep> deep;
    for (Chamber& chamber : all_) {
      if (is_surely_shallow(chamber)) continue;
      const QuadraticNumber peak = pores_.value(chamber.peaks[0]), gate = gate_value(chamber);
      if (peak - depth_ < gate) continue;
      deep.push_back({nearest_difference(peak, gate), std::move(chamber)});
    }
    std::ranges::stable_sort(deep, [](const Deep& x, const Deep& y) {
      if (x.depth != y.depth) return x.depth > y.depth;
      return x.chamber.peaks < y.chamber.peaks;
    });
    for (Deep& each : deep) pores_.chambers_.push_back(std::move(each.chamber));
  }

  // ---- Windows ----

  static constexpr std::uint32_t kNoRoom = Pores::kOutside - 1;

  // The smallest chamber around each peak. Chambers of one peak are nested, and an outer one has more peaks.
  [[nodiscard]] std::vector<std::uint32_t> innermost_chambers() const {
    std::vector<std::uint32_t> innermost(outside_ + 1, kNoRoom);
    for (std::uint32_t number = 0; number < pores_.chambers_.size(); ++number) {
      const Numbers& peaks = pores_.chambers_[number].peaks;
      for (const std::uint32_t peak : peaks) {
        std::uint32_t& room = innermost[peak];
        if (room == kNoRoom || peaks.size() < pores_.chambers_[room].peaks.size()) room = number;
      }
    }
    innermost[outside_] = Pores::kOutside;
    return innermost;
  }

  void mark_rooms() {
    geometry::DisjointSets sets(outside_ + 1);
    std::vector<std::uint32_t> room_of = innermost_chambers();  // by a set's representative
    std::vector<Numbers> tops(outside_ + 1);                    // the highest peaks of an unmarked set
    for (std::uint32_t number = 0; number < outside_; ++number) tops[number] = {number};
    for_each_value([&](std::size_t first, std::size_t last) { mark_value(first, last, sets, room_of, tops); });
    add_windows_of_chambers();
  }

  // Unmarked components that points of one value link, and the rooms next to them.
  struct Cluster {
    Numbers peaks, parts, rooms;
  };

  void mark_value(std::size_t first, std::size_t last, geometry::DisjointSets& sets,
                  std::vector<std::uint32_t>& room_of, std::vector<Numbers>& tops) {
    // The components that each point is between, as they were before.
    std::vector<std::pair<std::uint32_t, Numbers>> links;
    std::set<std::uint32_t> unmarked;
    for (std::size_t place = first; place < last; ++place) {
      Numbers before;
      for (const std::uint32_t room : sides_[place].rooms) before.push_back(sets.find(room));
      geometry::keep_unique(before);
      if (before.size() == 1) {
        const std::uint32_t room = room_of[before[0]];
        if (room < pores_.chambers_.size()) pores_.chambers_[room].handles.push_back(sides_[place].point);
        continue;
      }
      for (const std::uint32_t each : before) {
        if (room_of[each] == kNoRoom) unmarked.insert(each);
      }
      links.emplace_back(sides_[place].point, std::move(before));
    }
    // Clusters of unmarked components, and the rooms next to each.
    std::map<std::uint32_t, std::uint32_t> leader;
    for (const std::uint32_t each : unmarked) leader[each] = each;
    const auto leader_of = [&](std::uint32_t each) {
      while (leader[each] != each) each = leader[each];
      return each;
    };
    for (const auto& [point, parts] : links) {
      std::optional<std::uint32_t> one;
      for (const std::uint32_t each : parts) {
        if (room_of[each] != kNoRoom) continue;
        if (one) leader[leader_of(each)] = leader_of(*one);
        one = each;
      }
    }
    std::map<std::uint32_t, Numbers> rooms_at, members;
    for (const auto& [point, parts] : links) {
      std::optional<std::uint32_t> cluster;
      for (const std::uint32_t each : parts) {
        if (room_of[each] == kNoRoom) cluster = leader_of(each);
      }
      if (!cluster) continue;
      for (const std::uint32_t each : parts) {
        if (room_of[each] != kNoRoom) rooms_at[*cluster].push_back(room_of[each]);
      }
    }
    for (const std::uint32_t each : unmarked) members[leader_of(each)].push_back(each);
    std::vector<Cluster> clusters;
    for (auto& [leading, parts] : members) {
      geometry::keep_unique(rooms_at[leading]);
      clusters.push_back({highest_of(parts, tops), std::move(parts), std::move(rooms_at[leading])});
    }
    std::ranges::sort(clusters, {}, &Cluster::peaks);
    for (const Cluster& cluster : clusters) {
      std::uint32_t room = cluster.rooms.size() == 1 ? cluster.rooms[0] : kNoRoom;
      if (cluster.rooms.size() > 1) {
        room = static_cast<std::uint32_t>(pores_.chambers_.size() + pores_.vestibules_.size());
        pores_.vestibules_.push_back(cluster.peaks);
        next_to_vestibule_.push_back(cluster.rooms);
      }
      for (const std::uint32_t each : cluster.parts) sets.unite(cluster.parts[0], each);
      const std::uint32_t root = sets.find(cluster.parts[0]);
      room_of[root] = room;
      tops[root] = cluster.peaks;
      for (const std::uint32_t each : cluster.parts) new_room_[each] = room;
    }
    // Points between different rooms are windows; the others join.
    for (const auto& [point, parts] : links) {
      Numbers rooms;
      for (const std::uint32_t each : parts)
        rooms.push_back(new_room_.contains(each) ? new_room_[each] : room_of[each]);
      geometry::keep_unique(rooms);
      if (rooms.size() > 1) {
        pores_.windows_.push_back({point, rooms});
        continue;
      }
      for (const std::uint32_t each : parts) {
        Numbers top = tops[sets.find(each)];
        sets.unite(parts[0], each);
        room_of[sets.find(each)] = rooms[0];
        if (rooms[0] == kNoRoom) tops[sets.find(each)] = std::move(top);
      }
    }
    new_room_.clear();
  }

  [[nodiscard]] Numbers highest_of(const Numbers& parts, const std::vector<Numbers>& tops) const {
    Numbers highest;
    for (const std::uint32_t each : parts) {
      if (!highest.empty() && rank_of(tops[each][0]) > rank_of(highest[0])) continue;
      if (!highest.empty() && rank_of(tops[each][0]) < rank_of(highest[0])) highest.clear();
      append(highest, tops[each]);
    }
    std::ranges::sort(highest);
    return highest;
  }

  // Chambers that are parts of this one, and vestibules that had only rooms inside of it next to them.
  [[nodiscard]] std::set<std::uint32_t> rooms_inside(const Chamber& chamber) const {
    std::set<std::uint32_t> inside;
    const auto chambers = static_cast<std::uint32_t>(pores_.chambers_.size());
    for (std::uint32_t room = 0; room < chambers; ++room) {
      if (std::ranges::includes(chamber.peaks, pores_.chambers_[room].peaks)) inside.insert(room);
    }
    for (std::uint32_t vestibule = 0; vestibule < next_to_vestibule_.size(); ++vestibule) {
      const auto is_inside = [&](std::uint32_t room) { return inside.contains(room); };
      if (std::ranges::all_of(next_to_vestibule_[vestibule], is_inside)) inside.insert(chambers + vestibule);
    }
    return inside;
  }

  // A window of a chamber is between one of the rooms inside of it, and one that is not.
  void add_windows_of_chambers() {
    for (Chamber& chamber : pores_.chambers_) {
      const std::set<std::uint32_t> inside = rooms_inside(chamber);
      for (std::uint32_t place = 0; place < pores_.windows_.size(); ++place) {
        const Numbers& rooms = pores_.windows_[place].rooms;
        const auto count = std::ranges::count_if(rooms, [&](std::uint32_t room) { return inside.contains(room); });
        if (count > 0 && static_cast<std::size_t>(count) < rooms.size()) chamber.windows.push_back(place);
      }
    }
  }

  Pores& pores_;
  const Rational& depth_;
  const unsigned threads_;
  std::uint32_t outside_ = 0;
  std::vector<BoundedDouble> near_;  // the values of the points, times the scale
  std::vector<Side> sides_;          // of the points of index 2, by falling value
  std::vector<Chamber> all_;
  std::map<std::uint32_t, std::uint32_t> new_room_;
  std::vector<Numbers> next_to_vestibule_;  // the rooms, by vestibule
};

Pores::Pores(const BallSet& balls, const Rational& depth, unsigned threads) : balls_(&balls) {
  const geometry::IeeeDoubles ieee;
  if (depth < 0) throw std::invalid_argument("a depth is not 0 or more: " + to_text(depth));
  PoreSearch(*this, depth, threads).run();
}

QuadraticNumber Pores::value(std::uint32_t point) const {
  const Carrier& carrier = carriers_[point];
  const auto made = *touching<Rational>(*balls_, std::span(carrier.balls).first(carrier.count));
  return roots_of({made.c2, made.c1, made.c0})[carrier.root] / QuadraticNumber(balls_->scale());
}

std::array<QuadraticNumber, 3> Pores::center(std::uint32_t point) const {
  const Carrier& carrier = carriers_[point];
  const auto made = *touching<Rational>(*balls_, std::span(carrier.balls).first(carrier.count));
  const Vector3<Rational> from = number_ball<Rational>(*balls_, carrier.balls[0]).center + made.a;
  const QuadraticNumber s = roots_of({made.c2, made.c1, made.c0})[carrier.root], scale = balls_->scale();
  const auto place = [&](const Rational& one, const Rational& other) {
    return (QuadraticNumber(one) + QuadraticNumber(other) * s) / scale;
  };
  return {place(from.x, made.b.x), place(from.y, made.b.y), place(from.z, made.b.z)};
}

const char* status_text(ChamberStatus status) {
  switch (status) {
    case ChamberStatus::kOpen:
      return "open";
    case ChamberStatus::kClosed:
      return "closed";
    default:
      return "too small";
  }
}

ChamberStatus Pores::status(const Chamber& chamber, const Rational& probe) const {
  if (QuadraticNumber(probe) > value(chamber.peaks[0])) return ChamberStatus::kTooSmall;
  if (chamber.gates.empty() || QuadraticNumber(probe) > value(chamber.gates[0])) return ChamberStatus::kClosed;
  return ChamberStatus::kOpen;
}

std::size_t Pores::cavities_at(const Rational& probe) const {
  const QuadraticNumber s = probe;
  return static_cast<std::size_t>(std::ranges::count_if(cavities_, [&](const CavityInterval& each) {
    return s <= value(each.peak) && (!each.gate || s > value(*each.gate));
  }));
}

std::vector<CavityStep> Pores::cavity_steps() const {
  // By rank: how many more there are at probes up to the value.
  std::map<std::uint32_t, std::pair<std::uint32_t, std::int64_t>> changes;
  const auto change = [&](std::uint32_t point, std::int64_t by) {
    const auto [entry, is_new] = changes.try_emplace(points_[point].rank, point, 0);
    entry->second.first = std::min(entry->second.first, point);
    entry->second.second += by;
  };
  for (const CavityInterval& each : cavities_) {
    change(each.peak, 1);
    if (each.gate) change(*each.gate, -1);
  }
  std::vector<CavityStep> steps;
  std::int64_t count = 0;
  for (const auto& [rank, entry] : changes) {
    count += entry.second;
    steps.push_back({entry.first, static_cast<std::size_t>(count)});
  }
  return steps;
}

}  // namespace flowcert
