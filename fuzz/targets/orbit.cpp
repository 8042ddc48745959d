// One orbit among up to 10 points: all four ways to compute it give the oracle's, segment by segment.
//
// The first eight bytes choose the start: its kind, and seven numbers that say which points it goes by.
#include "flowcert/orbit.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "fuzz/properties/orbit_comparison.h"
#include "fuzz/properties/orbit_starts.h"
#include "fuzz/properties/subject.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kStartBytes = 8;
constexpr std::size_t kMostRows = 10;

struct Way {
  const char* name;
  FlowOptions options;
};
constexpr std::array<Way, 4> kWays = {
    {{"lazy, binary", {ConstructionKernel::kLazy, FacetSearch::kBinary}},
     {"lazy, linear", {ConstructionKernel::kLazy, FacetSearch::kLinear}},
     {"exact, binary", {ConstructionKernel::kExact, FacetSearch::kBinary}},
     {"exact, linear", {ConstructionKernel::kExact, FacetSearch::kLinear}}}};

property::StartChoice start_of_bytes(Bytes bytes) {
  property::StartChoice choice;
  choice.kind = static_cast<property::StartKind>(bytes[0] % property::kStartKindCount);
  choice.numbers.assign(bytes.begin() + 1, bytes.begin() + kStartBytes);
  return choice;
}

}  // namespace

std::string complaint_of(Bytes bytes) {
  if (bytes.size() < kStartBytes) return {};
  const Input input = input_of_bytes(bytes.subspan(kStartBytes), kMostRows);
  if (input.rows.empty()) return {};
  const property::Subject subject(input);
  const RationalPoint start = property::start_of(subject.set, start_of_bytes(bytes));
  const auto truth = property::record_of(subject.set, start, oracle::orbit(subject.set, start));
  for (const Way& way : kWays) {
    Flow flow(subject.delaunay, way.options);
    const auto orbit = property::record_of(flow.orbit(start));
    const std::string difference = property::difference(orbit, truth);
    if (difference.empty()) continue;
    std::ostringstream text;
    text << difference << "\ninput:\n"
         << input << "the fast orbit (" << way.name << "):\n"
         << property::to_text(orbit) << "the oracle's orbit:\n"
         << property::to_text(truth);
    return text.str();
  }
  return {};
}

}  // namespace flowcert::fuzz
