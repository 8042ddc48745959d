// The formats of claims, one file each (spec/formats/claims.md); read_claim.cpp tries them in order.
//
// To add one: a file that defines a ClaimFormat, its declaration below, and its place in the list of
// read_claim.cpp. src/certify/README.md has an example.
#pragma once

#include <string_view>

#include "certify/layer.h"
#include "flowcert/claim.h"

namespace flowcert::certify {

struct ClaimFormat {
  // Becomes Claim::format.
  const char* name;
  // Whether a file looks like this format. It may be wrong only about files of formats that come later in the list.
  bool (*recognises)(std::string_view bytes);
  // Takes the whole file, decompressed and without a byte order mark. The file is not blank. `file` is its name for
  // messages. Compressed data in it are held to most_content(). Guarantees what flowcert/claim.h promises of readers.
  Claim (*read)(std::string_view bytes, std::string_view file, bool is_unlimited);
};

extern const ClaimFormat kPocketClaims;
extern const ClaimFormat kExchangeClaims;
extern const ClaimFormat kVtpClaims;
extern const ClaimFormat kGiesenKuehneClaims;
extern const ClaimFormat kCsvClaims;

}  // namespace flowcert::certify
