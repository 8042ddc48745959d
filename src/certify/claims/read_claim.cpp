// From a name to its bytes, through gzip, to the first format that recognises them.
#include <algorithm>
#include <array>
#include <span>

#include "certify/claim_content.h"
#include "certify/claimed_rows.h"
#include "certify/claims/claim_formats.h"
#include "certify/layer.h"
#include "flowcert/claim.h"
#include "geometry/floating_point.h"
#include "io/input_bytes.h"
#include "io/line_reader.h"

namespace flowcert {

using namespace certify;
namespace {

// The order in which formats are tried. The last one takes every file that the others do not recognise.
constexpr std::array kFormats = {&kPocketClaims, &kExchangeClaims, &kVtpClaims, &kGiesenKuehneClaims, &kCsvClaims};

}  // namespace

void certify::require_ids(std::span<const PointId> ids, const PointSet& points, const LinePlace& place) {
  for (const PointId id : ids) {
    if (id < points.row_count()) continue;
    const std::string truth =
        points.row_count() == 0 ? "the input is empty" : "the ids are 0 to " + std::to_string(points.row_count() - 1);
    place.reject("there is no point " + std::to_string(id) + "; " + truth);
  }
}

Claim certify::claim_in(std::string_view content, const std::string& name, bool unlimited) {
  const geometry::IeeeDoubles ieee;
  const auto* const format = std::find_if(kFormats.begin(), kFormats.end() - 1,
                                          [&](const ClaimFormat* one) { return one->recognises(content); });
  Claim claim = (*format)->read(content, name, unlimited);
  claim.format = (*format)->name;
  return claim;
}

Claim read_claim_from(std::string_view bytes, const std::string& name, bool unlimited) {
  std::string decompressed;
  return claim_in(plain_content(bytes, name, decompressed, unlimited), name, unlimited);
}

void require_rows(const Claim& claim, const PointSet& points, const std::string& name) {
  const auto required_at = [&](std::size_t line) {
    return [&points, place = LinePlace{.file = name, .line = line}](std::span<const PointId> ids) {
      require_ids(ids, points, place);
    };
  };
  if (claim.infinity) {
    for_each_rows(claim.infinity->bounded, required_at(claim.infinity->line));
    for_each_rows(claim.infinity->unbounded, required_at(claim.infinity->line));
  }
  if (claim.pockets) for_each_rows(*claim.pockets, required_at(claim.pockets->line));
  for (const ClaimedPoint& point : claim.points) {
    const auto require = required_at(point.line);
    const auto require_limits = [&require](const std::vector<ClaimedTarget>& limits) {
      std::ranges::for_each(limits, require, &ClaimedTarget::contact);
    };
    require(point.contact);
    if (point.samples) require(*point.samples);
    if (point.stable && point.stable->walk) require(*point.stable->walk);
    if (point.stable && point.stable->boundary) std::ranges::for_each(*point.stable->boundary, require);
    if (point.skeleton) for_each_rows(*point.skeleton, require);
    if (point.lambda) {
      for (const ClaimedDirection& one : point.lambda->directions) require(one.limit.contact);
      require_limits(point.lambda->arcs);
    }
    if (point.connections) {
      for (const ClaimedConnection& one : *point.connections) require(one.to.contact);
    }
    if (point.shares) {
      for (const ClaimedShare& share : *point.shares) require({&share.sample, 1});
    }
    if (point.u1) for_each_rows(*point.u1, require);
    if (point.successors) require_limits(*point.successors);
  }
}

Claim read_claim(const std::string& path, bool unlimited) { return read_claim_from(read_bytes(path), path, unlimited); }

}  // namespace flowcert
