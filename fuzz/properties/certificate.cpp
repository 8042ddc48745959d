// The checker's headers are included here alone: its names are global.
#include "fuzz/properties/certificate.h"

#include <algorithm>
#include <sstream>

#include "flowcert/write_stationary_points.h"
#include "fuzz/properties/subject.h"
#include "oracle/proof/delaunay.h"
#include "oracle/proof/pairs.h"
#include "oracle/proof/stationary_points.h"

namespace flowcert::property {

namespace {

constexpr const char* kFast = "the fast answer";
constexpr const char* kProved = "what is proved";

StationaryIndex index_of(Kind kind) {
  constexpr std::array<StationaryIndex, 7> kIndices{{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {1, 2}, {1, 3}, {2, 3}}};
  return kIndices.at(kind);
}

std::vector<ListedPoint> proved_points(const ::StationaryPoints& stationary) {
  std::vector<ListedPoint> points;
  points.reserve(stationary.all().size());
  for (const auto& point : stationary.all()) points.emplace_back(index_of(point.kind), point.contact);
  return points;
}

// A squared radius; nothing for infinity.
std::optional<oracle::Rational> value_of(const Points& points, const PersistencePairs& pairs, Rank rank) {
  if (rank == kNone) return std::nullopt;
  if (rank == 0) return oracle::Rational(0);
  const Ratio<BigInteger> diameter = pairs.squared_diameter(rank);
  mpq_class value(diameter.numerator.value, diameter.denominator.value);
  value.canonicalize();
  const int shift = 2 * points.grid_exponent() - 2;
  const auto bits = static_cast<mp_bitcnt_t>(std::abs(shift));
  value = shift >= 0 ? mpq_class(value << bits) : mpq_class(value >> bits);
  return oracle::Rational(value.get_mpq_t());
}

std::vector<oracle::PersistencePair> proved_pairs(const Points& points, const PersistencePairs& all) {
  std::vector<oracle::PersistencePair> pairs;
  pairs.reserve(all.all().size());
  for (const auto& [dimension, birth, death] : all.all()) {
    pairs.push_back({static_cast<int>(dimension), *value_of(points, all, birth), value_of(points, all, death)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// A line for each: index or kind, and contact set.
std::string to_text(const std::vector<ListedPoint>& points) {
  std::string text;
  for (const auto& [index, contact] : points) {
    text += std::to_string(index.face_dimension);
    if (!index.is_critical()) text += '-' + std::to_string(index.hull_dimension);
    for (const PointId id : contact) text += ' ' + std::to_string(id);
    text += '\n';
  }
  return text;
}

}  // namespace

CertifiedAnswer certified_answer(const FlowComplex& complex) {
  std::ostringstream certificate;
  write_certificate(certificate, complex);
  CertifiedAnswer answer{certificate.str(), {}, persistence_pairs(complex)};
  for (std::size_t i = 0; i < complex.stationary().size(); ++i) {
    const auto contact = complex.stationary().contact(i);
    answer.stationary.emplace_back(complex.stationary().index(i), std::vector(contact.begin(), contact.end()));
  }
  return answer;
}

std::optional<Disagreement> disproof(const fuzz::Input& input, const CertifiedAnswer& answer) {
  try {
    test_rounding();
    const Points points(input.rows);
    const Triangulation cells = CertificateReader("the certificate", answer.certificate, points).read();
    const std::vector<std::uint8_t> is_cospherical = DelaunayProof(points, cells).prove();
    const auto stationary = proved_points(::StationaryPoints(points, cells, is_cospherical));
    if (stationary != answer.stationary) {
      return Disagreement{
          "stationary", "FC-CERT-03",       "other stationary points", kFast, to_text(answer.stationary),
          kProved,      to_text(stationary)};
    }
    const auto pairs = proved_pairs(points, PersistencePairs(points, cells));
    if (pairs == answer.pairs) return std::nullopt;
    return Disagreement{"pairs", "FC-CERT-06",  "other persistence pairs", kFast, to_text(answer.pairs),
                        kProved, to_text(pairs)};
  } catch (const Verdict& verdict) {
    const bool is_decoded = verdict.exit_status == 1;
    return Disagreement{
        is_decoded ? "rejected" : "undecoded", is_decoded ? "FC-CERT-02" : "FC-FILE-49", verdict.line, "", "", "", ""};
  }
}

}  // namespace flowcert::property
