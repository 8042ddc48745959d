// Persistence diagrams in GUDHI's text format .pers (spec/formats/persistence.md).
//
// Guarantees: pairs are ordered by dimension, then exact birth, then exact death. A class that lasts comes last. So
// the text does not depend on how ties were broken.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"

namespace flowcert {

// The persistence pairs to write, in order.
class PersistenceDiagram {
 public:
  // with_zero adds the regular stationary points as pairs of length zero, whose birth and death are the same record
  // (FC-PERS-03). The complex must outlive this, and stay where it is. O(n log n).
  PersistenceDiagram(const FlowComplex& complex, bool with_zero);
  PersistenceDiagram(FlowComplex&&, bool) = delete;

  [[nodiscard]] const FlowComplex& complex() const { return complex_; }
  [[nodiscard]] const std::vector<PersistencePair>& pairs() const { return pairs_; }
  [[nodiscard]] bool has_zero() const { return has_zero_; }
  // Computed anew each time.
  [[nodiscard]] Rational squared_value(std::size_t record) const {
    return complex_.persistence().squared_value(record);
  }

  // The double nearest to it, or infinity where that would overflow.
  [[nodiscard]] double rounded_squared_value(std::size_t record) const {
    const StationaryPoints& stationary = complex_.stationary();
    return rounded_squared_radius(complex_.points(), stationary.contact(record),
                                  stationary.index(record).hull_dimension);
  }
  // The double nearest to its root.
  [[nodiscard]] double rounded_value(std::size_t record) const;

 private:
  void add_regular();

  const FlowComplex& complex_;
  bool has_zero_;
  std::vector<PersistencePair> pairs_;
};

// Squared distances, as GUDHI's alpha complex has them, or their roots, which readers of claims refuse.
enum class PersistenceValues : std::uint8_t { kSquared, kPlain };

// A line of a text with plain values.
inline constexpr char kPlainValuesMark[] = "# flowcert: plain values, not squared";

// A comment, then lines "dimension birth death". Values are rounded to the nearest doubles. The death of a class that
// lasts is `inf`. Throws InvalidInput if a value is beyond the doubles, before anything is written.
void write_pers(std::ostream& out, const PersistenceDiagram& diagram,
                PersistenceValues values = PersistenceValues::kSquared);
[[nodiscard]] std::string pers_text(const PersistenceDiagram& diagram,
                                    PersistenceValues values = PersistenceValues::kSquared);

}  // namespace flowcert
