// What compute writes for up to 8 points, with manifolds and skeletons, is read again and judged right.
#include <sstream>

#include "flowcert/check.h"
#include "fuzz/properties/exchange_file.h"
#include "fuzz/properties/input_points.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kMostRows = 8;

}  // namespace

std::string complaint_of(Bytes bytes) {
  const Input input = input_of_bytes(bytes, kMostRows);
  const PointSet points = property::point_set_of(input);
  const std::string file = property::exchange_file(property::rows_of(input));
  const Claim claim = read_claim_from(file, "a");
  const CheckReport report = check(points, claim);
  if (claim.format == "exchange" && report.verdict == Verdict::kConforms && report.is_exact &&
      report.findings.empty()) {
    return {};
  }
  std::ostringstream text;
  text << "read as " << claim.format << ", " << verdict_text(report.verdict) << "\ninput:\n" << input;
  for (const Finding& finding : report.findings) {
    text << finding.clause << ": " << finding.claimed << "; " << finding.truth << '\n';
  }
  text << file;
  return text.str();
}

}  // namespace flowcert::fuzz
