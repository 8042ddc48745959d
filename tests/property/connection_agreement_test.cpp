// The connections graph of the fast implementation against the oracle's (FC-CONN-01 to 03), on all families.
//
// Guarantees: all edges of the graph are compared, with both numbers, and whether the input is Morse-Smale. The oracle
// makes all λ-lists by scans over all points.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/connections.h"
#include "fuzz/properties/stable_pieces.h"
#include "oracle/connections.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::connection_agreement_test {
namespace {

constexpr int kInputsPerFamily = 4;

struct Totals {
  std::size_t inputs = 0, edges = 0, morse_smale = 0, between_saddles = 0;

  void add(const Totals& part) {
    inputs += part.inputs;
    edges += part.edges;
    morse_smale += part.morse_smale;
    between_saddles += part.between_saddles;
  }
  void print_row(const std::string& name) const {
    std::printf("%-24s %zu inputs, %zu of them Morse-Smale; %zu edges, %zu from index 2 to index 2\n", name.c_str(),
                inputs, morse_smale, edges, between_saddles);
  }
};

// Contact sets, which differ for all stationary points of one input, and the two numbers. Infinity has none.
using Edge = std::tuple<Ids, Ids, std::size_t, std::size_t>;

std::vector<Edge> edges_of(const StationaryPoints& stationary, const std::vector<Connection>& connections) {
  std::vector<Edge> edges;
  edges.reserve(connections.size());
  for (const Connection& edge : connections) {
    const bool is_finite = edge.to != Connection::kInfinity;
    edges.emplace_back(ids(stationary.contact(edge.from)), is_finite ? ids(stationary.contact(edge.to)) : Ids{},
                       edge.orbits, edge.families);
  }
  return edges;
}

std::vector<Edge> edges_of(const std::vector<oracle::Connection>& connections) {
  std::vector<Edge> edges;
  edges.reserve(connections.size());
  for (const oracle::Connection& edge : connections) {
    edges.emplace_back(edge.from.contact, edge.to ? edge.to->contact : Ids{}, edge.directions, edge.arcs);
  }
  return edges;
}

std::string in_words(const std::vector<Edge>& edges) {
  std::string text;
  for (const auto& [from, to, orbits, families] : edges) {
    text += text_of(from) + " -> " + (to.empty() ? "infinity" : text_of(to)) + ": " + std::to_string(orbits) +
            " orbits, " + std::to_string(families) + " families\n";
  }
  return text;
}

// How many orbits from critical points of index 2 come neither to maxima nor to infinity.
std::size_t orbits_that_end_elsewhere(const std::vector<oracle::Connection>& connections) {
  std::size_t count = 0;
  for (const oracle::Connection& edge : connections) {
    const bool is_saddle = edge.from.is_critical() && edge.from.face_dimension == 2;
    const bool is_usual = !edge.to || (edge.to->is_critical() && edge.to->face_dimension == 3);
    if (is_saddle && !is_usual) count += edge.directions;
  }
  return count;
}

void require_right_graph(const Subject& subject, Totals& totals) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const FlowLimits limits(subject.complex.diagram(), stationary);
  const std::vector<Connection> connected = connections(limits);
  const std::vector<oracle::StationaryPoint> all = oracle::stationary_points(subject.set).stationary;
  const std::vector<oracle::Connection> by_oracle = oracle::connections(subject.set, all);
  const std::vector<Edge> fast = edges_of(stationary, connected), its = edges_of(by_oracle);
  require_none(subject.input, fast == its ? "" : "another graph",
               "the fast implementation's:\n" + in_words(fast) + "the oracle's:\n" + in_words(its));
  const std::size_t elsewhere = flowcert::orbits_that_end_elsewhere(stationary, limits);
  require_none(subject.input,
               elsewhere == orbits_that_end_elsewhere(by_oracle) ? "" : "another number of orbits that end elsewhere",
               std::to_string(elsewhere));
  const bool is_right = is_morse_smale(stationary, limits, subject.complex.stable());
  require_none(
      subject.input,
      is_right == oracle::is_morse_smale(subject.set, all) ? "" : "only one of them says that it is Morse-Smale", "");
  ++totals.inputs;
  totals.edges += fast.size();
  totals.morse_smale += is_right ? 1 : 0;
  for (const Connection& edge : connected) {
    const bool is_finite = edge.to != Connection::kInfinity;
    totals.between_saddles += is_finite && stationary.index(edge.from) == StationaryIndex{2, 2} &&
                              stationary.index(edge.to) == StationaryIndex{2, 2};
  }
}

TEST(ConnectionAgreement, GraphsAreTheOracles) {
  CITES("FC-CONN-01", "FC-CONN-02", "FC-CONN-03");
  Totals all;
  const bool agreed =
      expect_in_all_families("connections", {kInputsPerFamily, kInputsPerFamily}, require_right_graph, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.inputs, 150U);
    EXPECT_GE(all.morse_smale, 30U);
    EXPECT_LE(all.morse_smale, all.inputs - 30);
    EXPECT_GE(all.between_saddles, 1U);
  }
}

}  // namespace
}  // namespace flowcert::property::connection_agreement_test
