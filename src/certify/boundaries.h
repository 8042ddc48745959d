// Whether chains of index-1 points are boundaries of index-2 points (FC-CLAIM-09).
//
// Guarantees: exact. Where no tie has to be broken, only the one boundary is right. Where ties leave it open,
// a chain is permitted iff it is a cycle of what lies below the point that together with one right boundary
// bounds below the point: then homology and persistence are the same. That is found by elimination over Z/2,
// once for all chains that have to be judged so.
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

  // Of the index-2 critical point at which point k is. The chain: contact sets by rows, taken mod 2 where
  // is_walk says so; otherwise none may be there twice. level: of the findings.
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
