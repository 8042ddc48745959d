// Ties. A cycle of edges that lead to y bounds below y: it is a sum of boundaries of index-2 points not above y
// (FC-CYC-01). So a cocycle that is even on all boundaries before the death, by one choice each, is even on what ties
// add to them. And a loop that is the boundary of the surface up to ties bounds in {d^2 <= death}, which is what a
// surface is for.
#include "oracle/witness.h"

#include <algorithm>
#include <map>
#include <optional>

#include "oracle/boundaries.h"

namespace oracle {

namespace {

std::size_t common(const Chain& a, const Chain& b) {
  return static_cast<std::size_t>(std::count_if(a.begin(), a.end(), [&](const Contact& e) { return b.contains(e); }));
}

bool has_repeats(const std::vector<Contact>& list) { return std::set(list.begin(), list.end()).size() != list.size(); }

// The critical points of this index with these contact sets. Nothing iff one of them is none.
std::optional<std::vector<StationaryPoint>> critical_points(const PointSet& set, const std::vector<Contact>& list,
                                                            int index) {
  const auto is_class = [&](std::size_t name) { return std::binary_search(set.names.begin(), set.names.end(), name); };
  std::vector<StationaryPoint> points;
  for (const Contact& contact : list) {
    if (contact.empty() || !std::all_of(contact.begin(), contact.end(), is_class)) return std::nullopt;
    const std::vector<Point> samples = select(set.points, places_of(set, contact));
    const Point z = circumcentre(spanning_subset(samples))->center;
    points.push_back({z, squared_distance(z, samples[0]), contact, index, index});
    if (certify(set, points.back())) return std::nullopt;
  }
  return points;
}

bool is_cycle(const std::vector<Contact>& loop) {
  std::map<std::size_t, std::size_t> times;
  for (const Contact& edge : loop) {
    for (const std::size_t sample : edge) ++times[sample];
  }
  return std::all_of(times.begin(), times.end(), [](const auto& time) { return time.second % 2 == 0; });
}

std::string fault_of_cocycle(const PointSet& set, const Witness& witness, const std::vector<StationaryPoint>& edges,
                             const Rational& death) {
  const Chain cocycle(witness.cocycle.begin(), witness.cocycle.end());
  std::set<Contact> listed(witness.met.begin(), witness.met.end());
  bool is_met_right = true;
  for (const StationaryPoint& x : saddles_above(set, edges, death)) {
    const auto [chain, ties] = boundary(set, x);
    bool meets = common(chain, cocycle) > 0;
    if (common(chain, cocycle) % 2 == 1) return "odd-boundary";
    for (const Chain& tie : ties) {
      meets = meets || common(tie, cocycle) > 0;
      if (common(tie, cocycle) % 2 == 1) return "odd-boundary";
    }
    const bool is_listed = listed.erase(x.contact) > 0;
    is_met_right = is_met_right && (is_listed ? meets : !meets || !ties.empty());
  }
  return is_met_right && listed.empty() ? "" : "met";
}

std::string fault_of_surface(const PointSet& set, const Witness& witness, const std::vector<StationaryPoint>& surface) {
  Chain rest(witness.loop.begin(), witness.loop.end());
  std::vector<Chain> all_ties;
  for (const StationaryPoint& x : surface) {
    const auto [chain, ties] = boundary(set, x);
    rest = sum(rest, chain);
    all_ties.insert(all_ties.end(), ties.begin(), ties.end());
  }
  return is_sum_of(rest, all_ties) ? "" : "surface-boundary";
}

}  // namespace

std::string fault(const PointSet& set, const Witness& witness) {
  for (const auto* list : {&witness.loop, &witness.surface, &witness.cocycle, &witness.met}) {
    if (has_repeats(*list)) return "repeated";
  }
  const auto births = critical_points(set, {witness.birth}, 1), deaths = critical_points(set, {witness.death}, 2);
  const auto loop = critical_points(set, witness.loop, 1), cocycle = critical_points(set, witness.cocycle, 1);
  const auto surface = critical_points(set, witness.surface, 2);
  if (!births || !deaths || !loop || !cocycle || !surface) return "no-critical-point";
  const Rational birth = births->front().squared_distance, death = deaths->front().squared_distance;
  const auto has_value = [](const std::vector<StationaryPoint>& points, const auto& is_meant) {
    return std::any_of(points.begin(), points.end(), [&](const auto& x) { return is_meant(x.squared_distance); });
  };
  if (!is_cycle(witness.loop)) return "not-a-cycle";
  if (has_value(*loop, [&](const Rational& value) { return value > birth; })) return "born-later";
  if (has_value(*surface, [&](const Rational& value) { return value > death; })) return "surface-too-late";
  if (has_value(*cocycle, [&](const Rational& value) { return value < birth; })) return "cocycle-too-early";
  const Chain edges(witness.loop.begin(), witness.loop.end());
  if (common(edges, {witness.cocycle.begin(), witness.cocycle.end()}) % 2 == 0) return "even-on-loop";
  const std::string of_cocycle = fault_of_cocycle(set, witness, *cocycle, death);
  return of_cocycle.empty() ? fault_of_surface(set, witness, *surface) : of_cocycle;
}

}  // namespace oracle
