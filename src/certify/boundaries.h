// Judges chains of index-1 points that are claimed as boundaries of index-2 points (FC-CLAIM-09).
//
// Guarantees: exact. Where no tie has to be broken, only the one true boundary is right. Where a tie leaves it open,
// a chain is permitted iff it is a cycle below the index-2 point, and its sum with one right boundary is a boundary
// of what lies below the point. Homology and persistence are then the same. One elimination over Z/2 tests the sums
// of all chains together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "certify/check_run.h"

namespace flowcert::certify {

// Whether a tie leaves the boundary of a stationary point open (FC-CHAIN-02).
[[nodiscard]] bool has_tie(Truth& truth, std::size_t record);

class Boundaries {
 public:
  explicit Boundaries(CheckRun& run) : run_(run) {}

  // Judges a chain claimed for the index-2 critical point at which claimed point k is. The chain is a list of contact
  // sets, by rows. It is taken mod 2 if is_walk; otherwise none may occur twice. The findings get this level.
  void check(std::size_t k, const std::vector<std::vector<PointId>>& chain, int level, bool is_walk);
  // Judges what check() has put off.
  void conclude();

 private:
  struct Question {
    std::size_t k;
    int level;
    std::string claimed;
    std::vector<std::uint32_t> cycle;  // the chain with one right boundary, mod 2
  };

  void find(std::size_t k, int level, const std::string& claimed, const std::string& truth);
  bool bounds_below(std::vector<std::uint32_t>& cycle) const;
  void add_to_basis(std::size_t record);

  CheckRun& run_;
  std::vector<Question> questions_;
  std::vector<std::vector<std::uint32_t>> basis_;  // by highest record; empty where there is none
};

}  // namespace flowcert::certify
