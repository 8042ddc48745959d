// VTP (VTK's XML PolyData) as TTK's ScalarFieldCriticalPoints exports it. It has positions, and CriticalType in the
// point data: 0 minimum, 1 and 2 saddles, 3 maximum.
//
// A position is kept exactly as it is stored, but it stands for any position near it. TTK's other types (4
// degenerate, 5 regular) name no index, and are refused.
#include <algorithm>
#include <string>

#include "certify/claims/claim_formats.h"
#include "certify/claims/vtp_file.h"
#include "io/input_bytes.h"

namespace flowcert::certify {
namespace {

constexpr const char* kTypeArray = "CriticalType";

void add_points(const VtpPiece& piece, VtpDecoder& decoder, Claim& claim) {
  if (piece.point_count == 0) return;
  if (!piece.points) piece.place.reject("a piece without the positions of its points");
  if (!piece.data) piece.place.reject(std::string("no array '") + kTypeArray + "' in the point data");
  if (piece.points->components != 3) piece.points->place.reject("positions are not of 3 components");
  if (piece.data->components != 1)
    piece.data->place.reject(std::string("the array '") + kTypeArray + "' is not of 1 component");
  const VtpValues positions = decoder.decode(*piece.points, piece.point_count);
  const VtpValues types = decoder.decode(*piece.data, piece.point_count);
  for (std::size_t k = 0; k < piece.point_count; ++k) {
    const Rational type = types[k].value;
    int index = 0;
    while (index < 4 && type != index) ++index;
    if (index == 4) {
      piece.data->place.reject("point " + std::to_string(k) + " of the piece: its " + kTypeArray +
                               " is none of 0 to 3");
    }
    ClaimedPoint& point = claim.points.emplace_back();
    point.line = claim.points.size();
    point.index = index;
    point.center = {positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]};
  }
}

bool recognises_vtp(std::string_view bytes) {
  const auto* const first = std::find_if_not(bytes.begin(), bytes.end(), is_blank);
  return first != bytes.end() && *first == '<';
}

Claim read_vtp(std::string_view bytes, std::string_view file, bool is_unlimited) {
  Claim claim;
  VtpDocument document = parse_vtp(bytes, file, kTypeArray);
  document.most_bytes = most_content(bytes.size(), is_unlimited);
  VtpDecoder decoder(document);
  for (const VtpPiece& piece : document.pieces) add_points(piece, decoder, claim);
  return claim;
}

}  // namespace

const ClaimFormat kVtpClaims = {.name = "vtp", .recognises = recognises_vtp, .read = read_vtp};

}  // namespace flowcert::certify
