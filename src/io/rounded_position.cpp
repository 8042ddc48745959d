// See rounded_position.h.
#include "io/rounded_position.h"

namespace flowcert::io {

BeyondDoubles::BeyondDoubles()
    : InvalidInput(
          "a coordinate or squared distance is beyond the largest double, which an exported file cannot "
          "say; compute -o has it exactly") {}

double rounded(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  if (!nearest) throw BeyondDoubles();
  return *nearest;
}

Point rounded(const RationalPoint& position) {
  return {rounded(position[0]), rounded(position[1]), rounded(position[2])};
}

}  // namespace flowcert::io
