// One orbit among up to 10 points: all four ways to compute it give the oracle's, segment by segment.
//
// The first eight bytes choose the start: its kind, and seven numbers that say which points it goes by.
#include "fuzz/properties/property.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kStartBytes = 8;
constexpr std::size_t kMostRows = 10;

property::StartChoice start_of_bytes(Bytes bytes) {
  property::StartChoice choice;
  choice.kind = static_cast<property::StartKind>(bytes[0] % property::kStartKindCount);
  choice.numbers.assign(bytes.begin() + 1, bytes.begin() + kStartBytes);
  return choice;
}

}  // namespace

std::string complaint_of(Bytes bytes) {
  if (bytes.size() < kStartBytes) return {};
  return complaint_of({"orbit", "orbit-kernels"},
                      {input_of_bytes(bytes.subspan(kStartBytes), kMostRows), start_of_bytes(bytes)});
}

}  // namespace flowcert::fuzz
