// Diameters that a program claims of the room between balls, in JSON or in lines, and which of them are wrong, by how
// much, and why (FC-FILE-58, spec/formats/pores.md; FC-CLAIM-26).
//
// Guarantees: a claim is kept as it was made, and nothing is rounded. Which ones are right is decided by exact numbers,
// by a matching that makes as many right as possible. Only the reason of a wrong one is found in doubles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/pair_differences.h"
#include "flowcert/pores.h"

namespace flowcert {

enum class PoreKind : std::uint8_t { kCavity, kWindow, kGate, kLimiting };
inline constexpr std::array kPoreKinds = {"cavity", "window", "gate", "limiting"};

// A number as claimed. A decimal is not exact, and its value is the decimal itself.
struct ClaimedRoot {
  QuadraticNumber value;
  bool is_exact = false;
};
// One number in one form or several, all of which have to be right.
using ClaimedForms = std::vector<ClaimedRoot>;

// By the balls that are nearest there, or some of them; by a position; or by both.
struct ClaimedPorePlace {
  std::vector<PointId> balls;  // ascending, each once
  std::optional<std::array<ClaimedForms, 3>> position;
  std::array<double, 3> near{};  // the nearest doubles
};

struct ClaimedPore {
  PoreKind kind = PoreKind::kCavity;
  std::size_t line = 0;                       // of the file, 1-based
  std::string name = {};                      // "chamber 3", in JSON
  ClaimedForms diameter = {};                 // none: it is below 0
  double near = -1;                           // the nearest double
  std::vector<ClaimedPorePlace> places = {};  // of the window, or of peaks of the chamber
  bool is_greatest = false;                   // of its kind
  bool is_beside = false;                     // chambers tell the same, so that it is no claim of its own
};

struct PoreClaim {
  Rational depth = Rational(1) / 10;  // of the chambers that are listed
  std::optional<std::size_t> balls;   // so many are said to be there
  bool is_whole = false;              // it has all chambers and windows
  std::vector<ClaimedPore> pores;
};

// Whether a file is such a claim: JSON that says so in its first line, or lines that begin with a kind.
[[nodiscard]] bool is_pore_claim(std::string_view bytes, const std::string& name);
// Reads what a program has written, without a byte order mark. name: of the file, for messages. Throws InvalidInput,
// "FILE:LINE: reason", for a file of another form.
[[nodiscard]] PoreClaim claimed_pores_of(std::string_view bytes, const std::string& name);

// Where no tolerance is asked for.
inline constexpr double kPoreTolerance = 1e-6;

struct PoreJudgement {
  std::vector<PairDifference> differences;  // PairDifference::dimension is the kind
  // By kind. What is left out is wrong only if the claim is whole.
  std::array<std::size_t, kPoreKinds.size()> claimed{}, truth{}, left_out{};
  bool is_exact = true;  // no diameter is claimed in decimals alone
};
// pores: of the depth of the claim. Throws InvalidInput for a ball that is not there.
[[nodiscard]] PoreJudgement judge_pores(const PoreClaim& claim, const Pores& pores, double tolerance,
                                        const std::string& name);

}  // namespace flowcert
