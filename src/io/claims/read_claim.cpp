// From a name to its bytes, through gzip, to the first format that recognises them.
#include <algorithm>
#include <array>

#include "flowcert/claim.h"
#include "io/claims/claim_formats.h"
#include "io/claims/input_bytes.h"
#include "io/gzip_stream.h"
#include "io/line_reader.h"

namespace flowcert {
namespace {

// In the order in which they are tried. The last takes what none before it does.
constexpr std::array kFormats = {&kExchangeClaims, &kVtpClaims, &kGiesenKuehneClaims, &kCsvClaims};

}  // namespace

Claim read_claim_from(std::string_view bytes, const std::string& name) {
  std::string decompressed;
  if (is_gzip(bytes)) {
    decompressed = gunzip(bytes, name);
    bytes = decompressed;
  }
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  if (std::all_of(bytes.begin(), bytes.end(), is_blank)) reject_file(name, "empty");
  const auto* const format = std::find_if(kFormats.begin(), kFormats.end() - 1,
                                          [&](const ClaimFormat* one) { return one->recognises(bytes); });
  Claim claim = (*format)->read(bytes, name);
  claim.format = (*format)->name;
  return claim;
}

Claim read_claim(const std::string& path) { return read_claim_from(read_bytes(path), path); }

}  // namespace flowcert
