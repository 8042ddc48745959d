// A signature says in a few small numbers what is degenerate about an input. A campaign keeps inputs with new
// signatures.
//
// Guarantees: a signature is a function of the input alone, computed by the fast implementation. All components but
// the two about arithmetic are the same for any order of the rows. What exact arithmetic had to decide depends on the
// triangulation, and so on that order as well. Numbers come in buckets, so that there are thousands of signatures and
// not millions.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

// In the order of signature_components().
enum class SignaturePart : std::uint8_t {
  kDimension,
  kDuplicates,
  kCluster,
  kPolygon,
  kKind12,
  kKind23,
  kKind13,
  // A Voronoi edge is right-angled iff a side of its polygon is a diameter of the polygon's circle. The midpoint of
  // that side drives the edge, and lies on its line. A chain is a set of right-angled Voronoi edges that are
  // connected by Voronoi vertices. Its length is the number of its edges.
  kChain,
  kVertexStarts,
  kVertexHits,
  kEndsAtRegular,
  kEndsAtInfinity,
  kCascade,
  kDescent,
  kStableVertex,
  kStableInterval,
  kTies,
  kExact,
  kExactFlow,
};
inline constexpr std::size_t kSignatureSize = 19;

struct SignatureComponent {
  std::string name;
  std::string description;  // a sentence
  // What the values 0, 1, ... mean. For a set: what the bits of the value mean.
  std::vector<std::string> texts;
  bool is_set = false;
  // Whether the component is the same for any order of the rows.
  bool is_combinatorial = true;
};
const std::vector<SignatureComponent>& signature_components();

struct DegeneracySignature {
  std::array<std::uint8_t, kSignatureSize> values{};

  [[nodiscard]] std::uint8_t operator[](SignaturePart part) const { return values[static_cast<std::size_t>(part)]; }
  std::uint8_t& operator[](SignaturePart part) { return values[static_cast<std::size_t>(part)]; }
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the zero that an order is compared with for a pointer
  friend auto operator<=>(const DegeneracySignature&, const DegeneracySignature&) = default;
};

// Throws InvalidInput for a coordinate that is NaN or infinite.
[[nodiscard]] DegeneracySignature signature_of(const Input& input);
// Sets all components to zero that are not combinatorial.
[[nodiscard]] DegeneracySignature combinatorial_part(DegeneracySignature signature);

// How many values a component can have.
[[nodiscard]] std::size_t value_count(std::size_t component);
// "3-4"; for a set "angle,cospherical", or "none".
[[nodiscard]] std::string value_text(std::size_t component, std::uint8_t value);
// One line: "dimension=3 duplicates=0 cluster=6 polygon=4 12=1 ... exact=angle,cospherical exact-flow=none".
[[nodiscard]] std::string to_text(const DegeneracySignature& signature);

}  // namespace flowcert::fuzz
