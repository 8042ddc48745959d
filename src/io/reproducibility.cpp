// See flowcert/reproducibility.h. Version, commit and CGAL's version come from CMake; the digest is
// OpenSSL's.
#include "flowcert/reproducibility.h"

#include <openssl/evp.h>

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "io/layer.h"

namespace flowcert {

using namespace io;

Reproducibility reproducibility() {
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "gcc " __VERSION__;
#endif
  return {FLOWCERT_VERSION, FLOWCERT_COMMIT, "double filter, exact integers", compiler,
          FLOWCERT_CGAL_VERSION};
}

std::string coordinates_sha256(std::span<const Point> rows) {
  static_assert(std::endian::native == std::endian::little, "the digest is of little-endian doubles");
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  bool ok = context != nullptr && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  for (const Point& p : rows) {
    const std::array<double, 3> coordinates = {p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0.0 becomes 0.0
    ok = ok && EVP_DigestUpdate(context.get(), coordinates.data(), sizeof(coordinates)) == 1;
  }
  ok = ok && EVP_DigestFinal_ex(context.get(), digest.data(), &length) == 1;
  if (!ok) throw std::runtime_error("SHA-256 is not available from this OpenSSL");
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    constexpr const char* kDigits = "0123456789abcdef";
    text += kDigits[digest[i] >> 4];
    text += kDigits[digest[i] & 15];
  }
  return text;
}

}  // namespace flowcert
