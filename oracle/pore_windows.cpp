// The labelled merge of FC-BALL-09. The outside and the chambers are marks. From the greatest value down, blocks with
// different marks stay apart, and others join. A block is a component here, and each of its leaves bears its mark. So
// the blocks of a vestibule need not be made one: they have one mark, and it is the marks that later steps ask for.
#include <algorithm>
#include <map>
#include <numeric>

#include "oracle/pore_rooms.h"

namespace oracle {

namespace {

class Merge {
 public:
  explicit Merge(Pores& pores) : pores_(pores), components_(pores.points.size() + 1) {
    std::iota(components_.begin(), components_.end(), std::size_t{0});
    for (std::size_t point = 0; point < outside(); ++point) mark_of_.push_back(smallest_chamber(point));
    mark_of_.push_back(kOutside);
    for (const std::vector<Link>& links : links_by_value(pores)) fall_to(links);
    for (Window& window : pores.windows) name_outside(window.rooms);
    for (Vestibule& vestibule : pores.vestibules) name_outside(vestibule.neighbours);
  }

 private:
  using Mark = std::optional<std::size_t>;  // the number of a room
  // The outside's number is not known before all vestibules are.
  static constexpr std::size_t kOutside = static_cast<std::size_t>(-1);

  std::size_t outside() const { return pores_.points.size(); }

  Mark smallest_chamber(std::size_t peak) const {
    Mark smallest;
    for (std::size_t room = 0; room < pores_.chambers.size(); ++room) {
      const Places& peaks = pores_.chambers[room].peaks;
      const bool has_it = std::find(peaks.begin(), peaks.end(), peak) != peaks.end();
      if (has_it && (!smallest || peaks.size() < pores_.chambers[*smallest].peaks.size())) smallest = room;
    }
    return smallest;
  }

  void name_outside(Places& rooms) const {
    std::replace(rooms.begin(), rooms.end(), std::size_t{kOutside}, outside_room(pores_));
  }

  // The links are all of one value.
  void fall_to(const std::vector<Link>& links) {
    note_handles(links);
    for (const auto& [number, members] : clusters(links)) {
      const Places around = marks_around(members, links);
      if (around.empty()) continue;
      const std::size_t mark = around.size() == 1 ? around[0] : new_vestibule(members, around);
      for (const std::size_t member : members) mark_of_[member] = mark;
    }
    for (const Link& link : links) {
      const Places rooms = marks_at(link.ends);
      if (rooms.size() > 1) pores_.windows.push_back({link.point, rooms});
      if (rooms.size() <= 1) join(components_, link.ends);
    }
  }

  void note_handles(const std::vector<Link>& links) {
    for (const Link& link : links) {
      const Mark mark = mark_of_[*link.ends.begin()];
      const bool is_in_chamber = mark && *mark < pores_.chambers.size();
      if (!is_in_chamber || components_at(components_, link.ends).size() > 1) continue;
      pores_.chambers[*mark].handles.push_back(link.point);
    }
  }

  // Their members, by the least one. A block without a mark that these links do not reach is here one by itself.
  std::map<std::size_t, Places> clusters(const std::vector<Link>& links) const {
    Components joined = components_;
    for (const Link& link : links) {
      Ends unmarked;
      for (const std::size_t end : link.ends) {
        if (!mark_of_[end]) unmarked.insert(end);
      }
      join(joined, unmarked);
    }
    std::map<std::size_t, Places> members_of;  // by component
    for (std::size_t point = 0; point < outside(); ++point) {
      if (pores_.points[point].index == 3 && !mark_of_[point]) members_of[joined[point]].push_back(point);
    }
    std::map<std::size_t, Places> result;
    for (const auto& [component, members] : members_of) result[members[0]] = members;
    return result;
  }

  // Ascending.
  Places marks_at(const Ends& ends) const {
    std::set<std::size_t> marks;
    for (const std::size_t end : ends) {
      if (mark_of_[end]) marks.insert(*mark_of_[end]);
    }
    return {marks.begin(), marks.end()};
  }

  // The marks at the ends of all links that have an end in the cluster.
  Places marks_around(const Places& members, const std::vector<Link>& links) const {
    Ends all;
    for (const Link& link : links) {
      const bool is_at_cluster =
          std::any_of(members.begin(), members.end(), [&](std::size_t member) { return link.ends.contains(member); });
      if (is_at_cluster) all.insert(link.ends.begin(), link.ends.end());
    }
    return marks_at(all);
  }

  // Its peaks are the cluster's highest points.
  std::size_t new_vestibule(const Places& members, const Places& neighbours) {
    Places peaks;
    for (const std::size_t member : members) {
      if (pores_.points[member].value == pores_.points[members[0]].value) peaks.push_back(member);
    }
    pores_.vestibules.push_back({peaks, neighbours});
    return pores_.chambers.size() + pores_.vestibules.size() - 1;
  }

  Pores& pores_;
  Components components_;
  std::vector<Mark> mark_of_;  // by leaf
};

// A vestibule is inside of the chamber iff its neighbours are, and these are chambers or earlier vestibules.
std::set<std::size_t> rooms_inside(const Pores& pores, const Chamber& chamber) {
  std::set<std::size_t> inside;
  for (std::size_t room = 0; room < pores.chambers.size(); ++room) {
    const Places& peaks = pores.chambers[room].peaks;
    if (std::includes(chamber.peaks.begin(), chamber.peaks.end(), peaks.begin(), peaks.end())) inside.insert(room);
  }
  for (std::size_t k = 0; k < pores.vestibules.size(); ++k) {
    const Places& neighbours = pores.vestibules[k].neighbours;
    const bool is_inside =
        std::all_of(neighbours.begin(), neighbours.end(), [&](std::size_t room) { return inside.contains(room); });
    if (is_inside) inside.insert(pores.chambers.size() + k);
  }
  return inside;
}

// Between a room inside of a chamber and one that is not.
bool is_window(const Window& window, const std::set<std::size_t>& inside) {
  const auto is_inside = [&](std::size_t room) { return inside.contains(room); };
  return std::any_of(window.rooms.begin(), window.rooms.end(), is_inside) &&
         !std::all_of(window.rooms.begin(), window.rooms.end(), is_inside);
}

}  // namespace

std::size_t outside_room(const Pores& pores) { return pores.chambers.size() + pores.vestibules.size(); }

void find_windows(Pores& pores) {
  Merge{pores};
  for (Chamber& chamber : pores.chambers) {
    const std::set<std::size_t> inside = rooms_inside(pores, chamber);
    for (std::size_t place = 0; place < pores.windows.size(); ++place) {
      if (is_window(pores.windows[place], inside)) chamber.windows.push_back(place);
    }
  }
}

}  // namespace oracle
