// zlib compresses, and OpenSSL writes base64.
#include "io/viewer_blob.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <bit>
#include <cstddef>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

namespace flowcert::io {

namespace {

using Bytes = std::vector<unsigned char>;

template <typename Number>
Bytes planes_of(std::span<const Number> numbers) {
  static_assert(std::endian::native == std::endian::little, "the first plane has the lowest bytes");
  Bytes planes(numbers.size_bytes());
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  auto to = planes.begin();
  for (std::size_t plane = 0; plane < sizeof(Number); ++plane) {
    for (std::size_t i = 0; i < numbers.size(); ++i) *to++ = bytes[i * sizeof(Number) + plane];
  }
  return planes;
}

Bytes compressed(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes stream(size);
  if (compress2(stream.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::bad_alloc();
  }
  stream.resize(size);
  return stream;
}

std::string base64(const Bytes& bytes) {
  if (bytes.size() > std::numeric_limits<int>::max() / 2) {
    throw std::runtime_error("an array of this complex is too large for a page");
  }
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // OpenSSL ends it with a zero
  const int size =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(size));
  return text;
}

template <typename Number>
Json blob_of(const char* type, std::span<const Number> numbers) {
  Json blob;
  blob["type"] = type;
  blob["count"] = numbers.size();
  blob["data"] = numbers.empty() ? "" : base64(compressed(planes_of(numbers)));
  return blob;
}

}  // namespace

Json viewer_blob(std::span<const double> numbers) { return blob_of("f64", numbers); }
Json viewer_blob(std::span<const float> numbers) { return blob_of("f32", numbers); }
Json viewer_blob(std::span<const std::uint32_t> numbers) { return blob_of("u32", numbers); }
Json viewer_blob(std::span<const std::uint8_t> numbers) { return blob_of("u8", numbers); }

}  // namespace flowcert::io
