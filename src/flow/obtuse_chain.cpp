// See obtuse_chain.h.
#include "flow/obtuse_chain.h"

#include <vector>

#include "geometry/predicates.h"

namespace flowcert::flow {

namespace {

// Of each piece; positive where it lies at infinity.
std::vector<Sign> angles_of(const VoronoiFaces& faces, FacetName facet, const FacetRing& ring,
                            FilterTally& tally) {
  const Point &p0 = faces.point(facet.v0), &p1 = faces.point(facet.v1);
  std::vector<Sign> angles;
  angles.reserve(ring.pieces.size());
  for (const RingPiece& piece : ring.pieces) {
    const bool is_finite = piece.polygon.cell != kNoCell;
    angles.push_back(is_finite ? exact_sign(Angle{p0, faces.point(piece.apex), p1}, tally) : Sign::kPositive);
  }
  return angles;
}

}  // namespace

ObtuseChain obtuse_chain(const VoronoiFaces& faces, FacetName facet, const FacetRing& ring,
                         FilterTally& tally) {
  const std::vector<Sign> angles = angles_of(faces, facet, ring, tally);
  const std::size_t n = angles.size();
  ObtuseChain chain;
  for (std::size_t k = 0; k < n; ++k) {
    const Sign before = angles[k == 0 ? n - 1 : k - 1];
    if (angles[k] == Sign::kNegative) {
      ++chain.count;
      if (before != Sign::kNegative) chain.first = static_cast<std::uint32_t>(k);
    }
    if (angles[k] == Sign::kZero) {
      ++chain.right_count;
      // Of the last and the first one of the ring, the first one is the later.
      const bool wraps = k + 1 == n && angles[0] == Sign::kZero && n > 2;
      if (!wraps) chain.right = static_cast<std::uint32_t>(k);
    }
  }
  return chain;
}

}  // namespace flowcert::flow
