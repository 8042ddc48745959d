// See encoded_bytes.h.
#include "io/claims/encoded_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <new>

#include "io/number_text.h"

namespace flowcert::io {
namespace {

constexpr int kPadding = 64;

// The six bits of a character of base64, kPadding, or -1.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return c == '=' ? kPadding : -1;
}

}  // namespace

void EncodedBytes::decode_four() {
  std::uint32_t bits = 0;
  std::size_t digits = 0;
  for (std::size_t found = 0; found < 4;) {
    if (rest_.empty()) place_.reject("cut short in the binary data");
    const char c = rest_.front();
    rest_.remove_prefix(1);
    if (is_blank(c)) continue;
    const int digit = base64_digit(c);
    const bool is_padding = digit == kPadding;
    if (digit < 0 || (is_padding && found < 2) || (!is_padding && digits < found))
      place_.reject("not base64: " + in_quotes({&c, 1}));
    ++found;
    bits = bits << 6 | (is_padding ? 0U : static_cast<std::uint32_t>(digit));
    digits += is_padding ? 0 : 1;
  }
  for (std::size_t k = 0; k + 1 < digits; ++k)
    decoded_ += static_cast<char>(static_cast<unsigned char>(bits >> (16 - 8 * k) & 0xff));
}

std::string EncodedBytes::take(std::uint64_t count) {
  if (!is_base64_) {
    if (count > rest_.size()) place_.reject("cut short in the binary data");
    std::string bytes(rest_.substr(0, count));
    rest_.remove_prefix(count);
    return bytes;
  }
  while (decoded_.size() < count) decode_four();
  std::string left = decoded_.substr(count);
  std::string bytes = std::move(decoded_);
  bytes.resize(count);
  decoded_ = std::move(left);
  return bytes;
}

void EncodedBytes::expect_end() const {
  if (!decoded_.empty() || !std::all_of(rest_.begin(), rest_.end(), is_blank))
    place_.reject("more binary data than announced");
}

void append_inflated(std::string_view bytes, std::uint64_t size, std::string& output,
                     const LinePlace& place) {
  if (bytes.size() > std::numeric_limits<uInt>::max()) place.reject("a compressed block of 4 GB or more");
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end_of_scope(&stream, inflateEnd);
  // zlib does not write through next_in; its type lacks the const for the sake of old compilers.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::array<char, std::size_t{1} << 14> block{};
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    status = inflate(&stream, Z_NO_FLUSH);
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    const std::size_t count = block.size() - stream.avail_out;
    if (count > size) place.reject("a compressed block is longer than announced");
    output.append(block.data(), count);
    size -= count;
  }
  if (status != Z_STREAM_END || size != 0 || stream.avail_in != 0)
    place.reject("a compressed block is damaged");
}

}  // namespace flowcert::io
