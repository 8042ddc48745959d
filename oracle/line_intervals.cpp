// Sorted by their beginnings, intervals are put together as long as there is no gap.
#include "oracle/line_intervals.h"

#include <algorithm>

namespace oracle {

namespace {

bool begins_before(const Interval& a, const Interval& b) {
  return a.from == b.from ? a.has_from && !b.has_from : is_before(a.from, b.from);
}

// Whether no point is between the first one's end and the second one's beginning.
bool is_connected(const Interval& a, const Interval& b) {
  return is_before(b.from, a.to) || (b.from == a.to && (a.has_to || b.has_from));
}

}  // namespace

bool is_before(const Corner& a, const Corner& b) {
  const auto end = [](const Corner& x) { return !x.at_infinity ? 0 : x.position < Point{} ? -1 : 1; };
  return end(a) != end(b) ? end(a) < end(b) : a.position < b.position;
}

Interval open_interval(const Corner& a, const Corner& b) { return is_before(a, b) ? Interval{a, b} : Interval{b, a}; }

std::vector<Interval> components(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end(), begins_before);
  std::vector<Interval> result;
  for (const Interval& next : intervals) {
    if (result.empty() || !is_connected(result.back(), next)) {
      result.push_back(next);
      continue;
    }
    Interval& last = result.back();
    if (last.to == next.to) last.has_to = last.has_to || next.has_to;
    if (is_before(last.to, next.to)) last.to = next.to, last.has_to = next.has_to;
  }
  return result;
}

bool covers(const std::vector<Interval>& components, const Interval& part) {
  return std::any_of(components.begin(), components.end(), [&](const Interval& c) {
    if (part.is_point() && ((part.from == c.from && !c.has_from) || (part.from == c.to && !c.has_to))) return false;
    return !is_before(part.from, c.from) && !is_before(c.to, part.to);
  });
}

std::vector<Interval> open_remainder(const std::vector<Interval>& of, const std::vector<Interval>& without) {
  std::vector<Interval> result;
  for (const Interval& whole : of) {
    Corner from = whole.from;
    for (const Interval& hole : without) {
      if (!is_before(from, hole.to) || is_before(whole.to, hole.from)) continue;
      if (is_before(from, hole.from)) result.push_back({from, hole.from});
      from = hole.to;
    }
    if (is_before(from, whole.to)) result.push_back({from, whole.to});
  }
  return result;
}

}  // namespace oracle
