// What compute writes of up to 8 points, manifolds and skeletons and all, is read again and judged right.
#include <sstream>

#include "flowcert/check.h"
#include "flowcert/reproducibility.h"
#include "fuzz/properties/stationary_comparison.h"
#include "fuzz/targets/target.h"
#include "io/write_manifolds.h"

namespace flowcert::fuzz {
namespace {

constexpr std::size_t kMostRows = 8;

std::string exchange_file(const Input& input, const PointSet& points) {
  std::vector<Point> rows;
  for (const auto& [x, y, z] : input.rows) rows.push_back({x, y, z});
  const Delaunay delaunay(points);
  const StationaryPoints stationary = stationary_points(delaunay);
  UnstableManifolds u2(delaunay, stationary);
  StableManifolds s2(delaunay, stationary);
  std::ostringstream out;
  write_manifolds(out, points, stationary, {.u2 = &u2, .polylines = true, .s2 = &s2, .skeletons = true},
                  coordinates_sha256(rows));
  return out.str();
}

}  // namespace

std::string complaint_of(Bytes bytes) {
  const Input input = input_of_bytes(bytes, kMostRows);
  const PointSet points = property::point_set_of(input);
  const std::string file = exchange_file(input, points);
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
