// Whether loops stand for persistence pairs of dimension 1 (FC-CYC-01 to 03), by the Čech filtration: all edges and
// triangles of samples, with the squared radii of their smallest balls. It uses no flow, no critical point and no
// triangulation.
//
// The boundaries of all triangles are reduced column by column, and a loop is written as a sum of the columns that are
// left. Exact. It takes time n^3, and the reduction in the worst case the cube of that: it is meant for 20 points.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "oracle/persistence.h"

namespace oracle {

// Places of two samples, ascending.
using Edge = std::array<std::size_t, 2>;
// A sum of edges mod 2, each once, in any order.
using Loop = std::vector<Edge>;

struct CechTunnels {
  explicit CechTunnels(const PointSet& set);

  // What is wrong with loops that claim to represent all pairs of a birth and a death (FC-CYC-02), or to be all loops
  // at a level of a death (FC-CYC-03); "" if nothing is. For a loop: "not-a-cycle", "edge-too-long" for one of a greater
  // value than birth or level, "dies-later", "dies-earlier", "born-earlier"; for all: "dependent", "too-few".
  std::string fault_at_birth(const std::vector<Loop>& loops, const Rational& birth, const Rational& death) const;
  std::string fault_at_level(const std::vector<Loop>& loops, const Rational& level, const Rational& death) const;

  // A cycle that bounds at a value, and not before. The latest of its edges is the one by which it is kept.
  struct Reduced {
    Rational death;
    Column edges;  // by their places
  };
  std::vector<Rational> values;            // of all edges, ascending
  std::map<Edge, std::size_t> edge_place;  // in that order
  std::map<std::size_t, Reduced> columns;  // by the place of the latest edge

 private:
  // The places of the columns that sum up to a loop. Nothing iff it is no cycle.
  std::optional<Column> columns_of(const Loop& loop) const;
  std::string fault(const std::vector<Loop>& loops, const std::optional<Rational>& birth, const Rational& level,
                    const Rational& death) const;
};

}  // namespace oracle
