#include "tests/vectors/incidences.h"

#include <array>
#include <map>
#include <optional>
#include <set>

#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "oracle/stable_set.h"
#include "oracle/unstable_set.h"

namespace oracle::vectors {

namespace {

using Contact = std::vector<std::size_t>;

bool has_index(const StationaryPoint& x, int index) { return x.face_dimension == index && x.hull_dimension == index; }

// How many connecting orbits come down to each index-1 point, told by its contact set.
std::map<Contact, std::size_t> orbits_down(const StableSet& stable) {
  std::map<Contact, std::size_t> count;
  for (const BackwardSegment& segment : stable.segments) {
    if (segment.back_kind == BackKind::kCritical) ++count[segment.back_contact];
  }
  return count;
}

Json incidences_of_saddle(const PointSet& set, const StationaryPoint& x, std::set<Contact>& reached) {
  Json limits = Json::array(), ends = Json::array(), boundary = Json::array();
  for (const Orbit& path : unstable_orbits(set, x)) {
    limits.push_back(path.limit ? Json(path.limit->contact) : Json(nullptr));
  }
  const StableSet stable = stable_set(set, x);
  for (const auto& [contact, count] : orbits_down(stable)) {
    ends.push_back(contact);
    if (count % 2 == 1) boundary.push_back(contact);
    reached.insert(contact);
  }
  if (has_tie(stable)) boundary = nullptr;
  return {{"limits", limits}, {"ends", ends}, {"boundary", boundary}};
}

// Each limit of the λ-list once.
Json incidences_without_saddle(const PointSet& set, const StationaryPoint& x) {
  std::set<Contact> finite;
  bool has_infinity = false;
  for (const UnstableEntry& entry : lambda_list(set, x)) {
    if (entry.limit) finite.insert(entry.limit->contact);
    has_infinity = has_infinity || !entry.limit;
  }
  Json limits = finite;
  if (has_infinity) limits.push_back(nullptr);
  return {{"limits", limits}};
}

}  // namespace

std::vector<Json> incidences(const PointSet& set, const std::vector<StationaryPoint>& all) {
  std::vector<Json> made(all.size());
  std::set<Contact> reached;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (has_index(all[i], 2)) made[i] = incidences_of_saddle(set, all[i], reached);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (has_index(all[i], 1) && !reached.contains(all[i].contact)) made[i] = incidences_without_saddle(set, all[i]);
  }
  return made;
}

}  // namespace oracle::vectors
