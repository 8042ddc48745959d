// The connections graph: which stationary points flow to which, along how many orbits and in how many families (spec
// clauses FC-CONN).
//
// Guarantees: exact, on every input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "flowcert/flow_limits.h"
#include "flowcert/stable_manifolds.h"

namespace flowcert {

// What leads from one stationary point to another one, or to infinity.
struct Connection {
  static constexpr std::uint32_t kInfinity = 0xffffffffu;

  std::uint32_t from, to;      // places in the list of stationary points
  std::uint32_t orbits = 0;    // single directions of the λ-list, beside no arc of their own limit
  std::uint32_t families = 0;  // arcs of it, with those of their ends that have their limit

  friend bool operator==(const Connection&, const Connection&) = default;
};

// Of the i-th list alone, sorted by to; infinity comes last.
[[nodiscard]] std::vector<Connection> connections_of(const FlowLimits& limits, std::size_t i);
// Of all lists, in their order.
[[nodiscard]] std::vector<Connection> connections(const FlowLimits& limits);

// Orbits of U2 that end neither at a maximum nor at infinity.
[[nodiscard]] std::size_t orbits_that_end_elsewhere(const StationaryPoints& stationary, const FlowLimits& limits);

// Whether the input is Morse-Smale (FC-CONN-03).
[[nodiscard]] bool is_morse_smale(const StationaryPoints& stationary, const FlowLimits& limits,
                                  const StableManifolds& stable);

}  // namespace flowcert
