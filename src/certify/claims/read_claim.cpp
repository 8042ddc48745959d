// From a name to its bytes, through gzip, to the first format that recognises them.
#include <algorithm>
#include <array>
#include <span>

#include "certify/claim_content.h"
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

void require_ids(std::span<const PointId> ids, const PointSet& points, const LinePlace& place) {
  for (const PointId id : ids) {
    if (id < points.row_count()) continue;
    const std::string truth =
        points.row_count() == 0 ? "the input is empty" : "the ids are 0 to " + std::to_string(points.row_count() - 1);
    place.reject("there is no point " + std::to_string(id) + "; " + truth);
  }
}

// A piece is a segment, an interval, a sector or a sheet.
template <class Piece>
void require_rows_of_pieces(const std::vector<Piece>& pieces, const PointSet& points, const LinePlace& place) {
  for (const Piece& piece : pieces) {
    if constexpr (requires { piece.polygon; }) {
      require_ids(piece.polygon, points, place);
    } else {
      require_ids(piece.samples, points, place);
    }
  }
}

void require_rows_of_skeleton(const StableSet<ClaimedPosition>& skeleton, const PointSet& points,
                              const LinePlace& place) {
  for (const BackwardSegment<ClaimedPosition>& segment : skeleton.segments) {
    require_ids(segment.samples, points, place);
    if (segment.front_contact) require_ids(*segment.front_contact, points, place);
    if (segment.back_contact) require_ids(*segment.back_contact, points, place);
  }
  require_rows_of_pieces(skeleton.intervals, points, place);
  require_rows_of_pieces(skeleton.sectors, points, place);
}

void require_rows_of_stable(const ClaimedPoint& point, const PointSet& points, const LinePlace& place) {
  if (point.stable) {
    if (point.stable->walk) require_ids(*point.stable->walk, points, place);
    if (point.stable->boundary) {
      for (const auto& contact : *point.stable->boundary) require_ids(contact, points, place);
    }
  }
  if (point.skeleton) require_rows_of_skeleton(*point.skeleton, points, place);
}

void require_rows_of_directions(const ClaimedPoint& point, const PointSet& points, const LinePlace& place) {
  if (point.lambda) {
    for (const ClaimedDirection& one : point.lambda->directions) require_ids(one.limit.contact, points, place);
    for (const ClaimedTarget& limit : point.lambda->arcs) require_ids(limit.contact, points, place);
  }
  if (point.connections) {
    for (const ClaimedConnection& one : *point.connections) require_ids(one.to.contact, points, place);
  }
  if (point.shares) {
    for (const ClaimedShare& share : *point.shares) require_ids(std::array{share.sample}, points, place);
  }
}

void require_rows_of_unstable(const ClaimedPoint& point, const PointSet& points, const LinePlace& place) {
  if (!point.u1) return;
  require_rows_of_pieces(point.u1->traces, points, place);
  require_rows_of_pieces(point.u1->runs, points, place);
  require_rows_of_pieces(point.u1->sheets, points, place);
  require_rows_of_pieces(point.u1->segments, points, place);
}

void require_rows_of_witnesses(const std::vector<ClaimedWitness>& witnesses, const PointSet& points,
                               const LinePlace& place) {
  for (const ClaimedWitness& witness : witnesses) require_ids(witness.contact, points, place);
}

void require_rows_of_pocket(const ClaimedPocket& pocket, const PointSet& points, const LinePlace& place) {
  for (const auto& maximum : pocket.maxima) require_ids(maximum, points, place);
  if (pocket.peaks) require_rows_of_witnesses(*pocket.peaks, points, place);
  if (pocket.cell) {
    for (const ClaimedCellPart& part : *pocket.cell) require_ids(part.contact, points, place);
  }
  if (pocket.mouths) {
    for (const ClaimedMouth& mouth : *pocket.mouths) require_ids(mouth.at.contact, points, place);
  }
  if (pocket.widest_path) require_rows_of_witnesses(pocket.widest_path->witnesses, points, place);
}

void require_rows_of_pockets(const ClaimedPockets& pockets, const PointSet& points, const LinePlace& place) {
  for (const ClaimedPocket& pocket : pockets.pockets) require_rows_of_pocket(pocket, points, place);
  if (pockets.outside) {
    for (const auto& maximum : *pockets.outside) require_ids(maximum, points, place);
  }
  for (const auto* whole : {&pockets.pore_limiting_radius, &pockets.largest_cavity_radius}) {
    if (*whole && (*whole)->radius) require_rows_of_witnesses((*whole)->radius->witnesses, points, place);
  }
}

}  // namespace

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
  if (claim.infinity) {
    for (const auto* part : {&claim.infinity->bounded, &claim.infinity->unbounded}) {
      require_rows_of_skeleton(*part, points, {.file = name, .line = claim.infinity->line});
    }
  }
  if (claim.pockets) require_rows_of_pockets(*claim.pockets, points, {.file = name, .line = claim.pockets->line});
  for (const ClaimedPoint& point : claim.points) {
    const LinePlace place{.file = name, .line = point.line};
    require_ids(point.contact, points, place);
    if (point.samples) require_ids(*point.samples, points, place);
    require_rows_of_stable(point, points, place);
    require_rows_of_directions(point, points, place);
    require_rows_of_unstable(point, points, place);
    if (!point.successors) continue;
    for (const ClaimedTarget& target : *point.successors) require_ids(target.contact, points, place);
  }
}

Claim read_claim(const std::string& path, bool unlimited) { return read_claim_from(read_bytes(path), path, unlimited); }

}  // namespace flowcert
