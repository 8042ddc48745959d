// First guesses, then augmenting paths (Kuhn's algorithm).
#include "certify/matching.h"

#include <algorithm>
#include <ranges>

namespace flowcert::certify {

namespace {

class Search {
 public:
  Search(const std::vector<Candidates*>& candidates, std::size_t true_count, const IsRightOf& is_right)
      : candidates_(candidates), is_right_(is_right), is_tried_(true_count, false) {
    found_.of_claimed.resize(candidates.size());
    found_.of_truth.resize(true_count);
  }

  Matching result() {
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      if (candidates_[k] != nullptr) guess(k);
    }
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      if (candidates_[k] != nullptr && !found_.of_claimed[k]) exchange(k);
    }
    return std::move(found_);
  }

 private:
  void join(std::size_t k, std::size_t place) {
    found_.of_claimed[k] = place;
    found_.of_truth[place] = k;
  }

  // Takes what is free.
  void guess(std::size_t k) {
    Candidates& among = *candidates_[k];
    const std::size_t count = among.places.size();
    for (std::size_t step = 0; step < count; ++step) {
      const std::size_t at = (among.next + step) % count, place = among.places[at];
      if (found_.of_truth[place] || !is_right_(k, place)) continue;
      join(k, place);
      among.next = at + 1;
      return;
    }
  }

  // Takes the partner of another one, if that can have a different one, and so on. What was tried in vain leads to
  // nothing free, and never will: it stays marked.
  void exchange(std::size_t first) {
    struct Step {
      std::size_t k;
      std::size_t tried;  // so many of its candidates
    };
    std::vector<Step> path{{first, 0}};
    std::vector<std::size_t> tried;
    while (!path.empty()) {
      Step& last = path.back();
      const std::vector<std::size_t>& places = candidates_[last.k]->places;
      if (last.tried == places.size()) {
        path.pop_back();
        continue;
      }
      const std::size_t place = places[last.tried++];
      const std::optional<std::size_t> owner = found_.of_truth[place];
      // What is free is not right of the first: guess() has asked.
      if (is_tried_[place] || (path.size() == 1 && !owner) || !is_right_(last.k, place)) continue;
      is_tried_[place] = true;
      tried.push_back(place);
      if (owner) {
        path.push_back({*owner, 0});
        continue;
      }
      for (const Step& step : path) join(step.k, candidates_[step.k]->places[step.tried - 1]);
      for (const std::size_t once : tried) is_tried_[once] = false;
      return;
    }
  }

  const std::vector<Candidates*>& candidates_;
  const IsRightOf& is_right_;
  std::vector<bool> is_tried_;  // by true thing
  Matching found_;
};

// A way from an owed true thing without a partner to one that has a partner and is not owed.
class OwedSearch {
 public:
  OwedSearch(Matching& matching, const std::vector<Candidates*>& candidates, const IsRightOf& is_right,
             const std::function<bool(std::size_t)>& is_owed)
      : matching_(matching), candidates_(candidates), is_right_(is_right), is_owed_(is_owed) {}

  // Returns whether it has a partner now.
  bool find(std::size_t owed) {
    came_from_.assign(candidates_.size(), std::nullopt);
    std::vector<std::size_t> open(1, owed);
    while (!open.empty()) {
      const std::size_t place = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < candidates_.size(); ++k) {
        // A claimed thing without a partner is right of nothing that is free, or the matching was not a maximum.
        if (came_from_[k] || !matching_.of_claimed[k] || !is_candidate(k, place) || !is_right_(k, place)) continue;
        came_from_[k] = place;
        if (!is_owed_(*matching_.of_claimed[k])) return give_back_to(owed, k);
        open.push_back(*matching_.of_claimed[k]);
      }
    }
    return false;
  }

 private:
  [[nodiscard]] bool is_candidate(std::size_t k, std::size_t place) const {
    return candidates_[k] != nullptr && std::ranges::binary_search(candidates_[k]->places, place);
  }

  bool give_back_to(std::size_t owed, std::size_t k) {
    matching_.of_truth[*matching_.of_claimed[k]].reset();
    while (true) {
      const std::size_t place = *came_from_[k];
      const std::optional<std::size_t> next = matching_.of_truth[place];
      matching_.of_claimed[k] = place;
      matching_.of_truth[place] = k;
      if (place == owed) return true;
      k = *next;
    }
  }

  Matching& matching_;
  const std::vector<Candidates*>& candidates_;
  const IsRightOf& is_right_;
  const std::function<bool(std::size_t)>& is_owed_;
  std::vector<std::optional<std::size_t>> came_from_;  // by claimed thing: the true one that asked for it
};

}  // namespace

Matching maximum_matching(const std::vector<Candidates*>& candidates, std::size_t true_count,
                          const IsRightOf& is_right) {
  return Search(candidates, true_count, is_right).result();
}

void prefer_owed(Matching& matching, const std::vector<Candidates*>& candidates, const IsRightOf& is_right,
                 const std::function<bool(std::size_t)>& is_owed) {
  std::vector<std::size_t> without;
  bool can_give = false;
  for (std::size_t place = 0; place < matching.of_truth.size(); ++place) {
    const bool owed = is_owed(place), has_partner = matching.of_truth[place].has_value();
    if (owed && !has_partner) without.push_back(place);
    can_give = can_give || (!owed && has_partner);
  }
  if (!can_give) return;
  OwedSearch search(matching, candidates, is_right, is_owed);
  // Once one stays without a partner the claim is wrong, and how many do is not worth a search each.
  for (const std::size_t place : without) {
    if (!search.find(place)) return;
  }
}

}  // namespace flowcert::certify
