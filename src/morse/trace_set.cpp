#include "morse/trace_set.h"

#include "morse/polygon_turn.h"

namespace flowcert::morse {

// ---- Order ----

void TraceOrder::clear() {
  rounded_.clear();
  exact_.clear();
}

// The edge is orthogonal to its polygon. All of its points differ in each coordinate in which the normal is not 0.
TraceOrder::Axis TraceOrder::axis(PolygonRef polygon) {
  const auto [known, is_new] = axes_.try_emplace(polygon.packed(), Axis{0, 0});
  if (!is_new) return known->second;
  const RationalPoint normal = exact_normal(diagram_, diagram_.corners(polygon));
  std::size_t k = 0;
  while (normal[k] == 0) ++k;
  return known->second = {k, normal[k].sign()};
}

double TraceOrder::rounded(const Location& at, std::size_t coordinate) {
  const auto [known, is_new] = rounded_.try_emplace(at.point);
  if (is_new) known->second = flow_.rounded(at).center;
  const Point& x = known->second;
  return coordinate == 0 ? x.x : coordinate == 1 ? x.y : x.z;
}

const RationalPoint& TraceOrder::exact(const Location& at) {
  const auto [known, is_new] = exact_.try_emplace(at.point);
  if (is_new) known->second = flow_.exact(at);
  return known->second;
}

int TraceOrder::compare(PolygonRef polygon, const TraceEnd& a, const TraceEnd& b) {
  if (a.kind != b.kind) return a.kind < b.kind ? -1 : 1;
  if (a.kind != TraceEnd::Kind::kPoint || a.at.point == b.at.point) return 0;
  const auto [coordinate, sign] = axis(polygon);
  const double x = rounded(a.at, coordinate), y = rounded(b.at, coordinate);
  if (x != y) return x < y ? -sign : sign;
  return sign * exact(a.at)[coordinate].compare(exact(b.at)[coordinate]);
}

// ---- Sets ----

// The new part covers a run of old ones, which may be empty, and what is between them is new.
std::vector<TracePart> TraceSet::add(PolygonRef polygon, const TracePart& part, TraceOrder& order) {
  const auto is_before = [&](const TraceEnd& a, const TraceEnd& b) { return order.compare(polygon, a, b) < 0; };
  std::size_t first = 0;
  while (first < parts_.size() && is_before(parts_[first].to, part.from)) ++first;
  std::size_t last = first;
  std::vector<TracePart> added;
  TracePart sum = part;
  TraceEnd from = part.from;
  for (; last < parts_.size() && !is_before(part.to, parts_[last].from); ++last) {
    const TracePart& old = parts_[last];
    if (is_before(from, old.from)) added.push_back({from, old.from});
    if (is_before(old.from, sum.from)) sum.from = old.from;
    if (is_before(sum.to, old.to)) sum.to = old.to;
    if (is_before(from, old.to)) from = old.to;
  }
  if (first == last) {
    added.push_back(part);
  } else if (is_before(from, part.to)) {
    added.push_back({from, part.to});
  }
  const auto begin = parts_.begin() + static_cast<std::ptrdiff_t>(first);
  parts_.insert(parts_.erase(begin, parts_.begin() + static_cast<std::ptrdiff_t>(last)), sum);
  return added;
}

}  // namespace flowcert::morse
