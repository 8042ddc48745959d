// Version, commit and CGAL's version come from CMake. OpenSSL computes the digest.
#include "flowcert/reproducibility.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/err.h>
#include <openssl/evp.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <system_error>

#include "geometry/floating_point.h"
#include "io/layer.h"

namespace flowcert {

using namespace io;

namespace {

// More than OpenSSL takes. Version 3.5 waits for ever where it gets nothing at all, so new has to find this much first.
constexpr std::size_t kMemoryOfOpenssl = std::size_t{1} << 20;

}  // namespace

Reproducibility reproducibility() {
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "gcc " __VERSION__;
#endif
  return {FLOWCERT_VERSION, FLOWCERT_COMMIT, "double filter, exact integers", compiler, FLOWCERT_CGAL_VERSION};
}

std::string coordinates_sha256(const PointSet& points) {
  const geometry::IeeeDoubles ieee;
  static_assert(std::endian::native == std::endian::little, "the digest is of little-endian doubles");
  ::operator delete(::operator new(kMemoryOfOpenssl));
  ::ERR_clear_error();  // where OpenSSL 3.0 begins with a digest, and finds no memory, it crashes
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  bool ok = context != nullptr && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  for (std::size_t row = 0; row < points.row_count(); ++row) {
    const std::array<double, 3> coordinates = points.at_row(static_cast<PointId>(row)).coordinates();
    ok = ok && EVP_DigestUpdate(context.get(), coordinates.data(), sizeof(coordinates)) == 1;
  }
  ok = ok && EVP_DigestFinal_ex(context.get(), digest.data(), &length) == 1;
  if (!ok) {
    throw std::system_error(std::make_error_code(std::errc::function_not_supported),
                            "OpenSSL has no SHA-256, or no memory for it");
  }
  return fmt::format("{:02x}", fmt::join(digest.data(), digest.data() + length, ""));
}

std::string made_by_text(const char* format, int format_version, const PointSet& points) {
  const Reproducibility made_by = reproducibility();
  const std::size_t left_out = points.left_out().size();
  return fmt::format("{} {}, by flowcert {} (commit {}; kernel: {}; compiler: {}; CGAL {}), input_sha256 {}{}", format,
                     format_version, made_by.version, made_by.commit, made_by.kernel, made_by.compiler, made_by.cgal,
                     coordinates_sha256(points), left_out > 0 ? fmt::format(", rows left out: {}", left_out) : "");
}

}  // namespace flowcert
