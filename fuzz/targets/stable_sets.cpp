// Stable sets, index-2 and regular, of up to 8 points: both kernels give the oracle's, piece by piece.
#include <sstream>

#include "flowcert/stable_manifolds.h"
#include "fuzz/properties/stable_pieces.h"
#include "fuzz/properties/subject.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kMostRows = 8;

oracle::StationaryPoint stationary_point(const PointSet& points, const StationaryPoints& stationary,
                                         std::size_t record) {
  const auto contact = stationary.contact(record);
  const ExactSphere sphere = exact_sphere(points, contact);
  const StationaryIndex index = stationary.index(record);
  return {sphere.center,
          sphere.squared_radius,
          {contact.begin(), contact.end()},
          index.face_dimension,
          index.hull_dimension};
}

}  // namespace

std::string complaint_of(Bytes bytes) {
  const Input input = input_of_bytes(bytes, kMostRows);
  const property::Subject subject(input);
  const StationaryPoints stationary = stationary_points(subject.delaunay);
  StableManifolds lazy(subject.delaunay, stationary);
  StableManifolds exact(subject.delaunay, stationary, {{ConstructionKernel::kExact, FacetSearch::kLinear}});
  for (std::size_t i = 0; i < lazy.size(); ++i) {
    const auto z = stationary_point(subject.points, stationary, lazy.record(i));
    const oracle::StableSet by_oracle = oracle::stable_set(subject.set, z);
    const auto truth = property::pieces_of(subject.set, by_oracle);
    const auto fast = property::pieces_of(lazy.set(i));
    const auto slow = property::pieces_of(exact.set(i));
    const bool same_flags = lazy.has_vertex(i) == by_oracle.has_vertex &&
                            lazy.has_interval(i) == !truth.intervals.empty() &&
                            (lazy.has_interval(i) || lazy.segment_count(i) == truth.segments.size());
    if (fast == truth && slow == truth && same_flags) continue;
    std::ostringstream text;
    text << "the stable set of " << property::text_of(z.contact)
         << (same_flags ? "" : ": its numbers or flags differ") << "\ninput:\n"
         << input << "lazy:\n"
         << property::text_of(fast) << "exact:\n"
         << property::text_of(slow) << "the oracle's:\n"
         << property::text_of(truth);
    return text.str();
  }
  return {};
}

}  // namespace flowcert::fuzz
