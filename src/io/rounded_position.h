// Exact positions and squared distances as the doubles nearest to them, for files that hold nothing else.
#pragma once

#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/layer.h"

namespace flowcert::io {

class BeyondDoubles : public InvalidInput {
 public:
  BeyondDoubles();
};

// Both throw BeyondDoubles where a number would overflow.
[[nodiscard]] double rounded(const Rational& value);
[[nodiscard]] Point rounded(const RationalPoint& position);

}  // namespace flowcert::io
