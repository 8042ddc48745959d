// The certificate checker as a witness: what the fast implementation says of an input is proved from its certificate,
// by oracle/proof, which shares nothing with it and nothing with the oracle's scans.
//
// Guarantees: exact. The certificate goes through its bytes. All stationary points are compared by kind and contact
// set, and all persistence pairs by their exact values, each as often as it is one. There is no limit of size.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/input.h"
#include "fuzz/properties/property.h"
#include "oracle/persistence.h"

namespace flowcert::property {

using ListedPoint = std::pair<StationaryIndex, std::vector<PointId>>;  // with its contact set

struct CertifiedAnswer {
  std::string certificate;                     // its bytes
  std::vector<ListedPoint> stationary;         // in the order of FC-OUT-02
  std::vector<oracle::PersistencePair> pairs;  // ascending
};
[[nodiscard]] CertifiedAnswer certified_answer(const FlowComplex& complex);

// What of the answer is not proved. Its kind is "undecoded" or "rejected", of the certificate, "stationary" or "pairs".
[[nodiscard]] std::optional<Disagreement> disproof(const fuzz::Input& input, const CertifiedAnswer& answer);

}  // namespace flowcert::property
