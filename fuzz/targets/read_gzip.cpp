// Gzip streams: refused in one line, or read. What was compressed comes back, even from two streams.
#include <zlib.h>

#include <stdexcept>

#include "fuzz/targets/reading.h"
#include "fuzz/targets/target.h"
#include "io/input_bytes.h"

namespace flowcert::fuzz {

using namespace io;
namespace {

std::string gzipped(std::string text) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib does not start");
  }
  std::string output(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(output.data());
  stream.avail_out = static_cast<uInt>(output.size());
  const int result = deflate(&stream, Z_FINISH);
  output.erase(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("zlib does not end");
  return output;
}

// The first byte says where the text is cut into two streams, and how many zeros follow them.
std::string complaint_about_pieces(std::string_view text) {
  const auto first = text.empty() ? 0U : static_cast<unsigned char>(text.front());
  const std::size_t cut = text.size() * (first % 16) / 16;
  const std::string file = gzipped(std::string(text.substr(0, cut))) + gzipped(std::string(text.substr(cut))) +
                           std::string(first / 16, '\0');
  return gunzip(file, "a.xyz.gz") == text ? "" : "cut at " + std::to_string(cut) + ", other bytes came back";
}

}  // namespace

std::string complaint_of(Bytes bytes) {
  const std::string complaint = complaint_about_pieces(text_of(bytes));
  return complaint.empty() ? complaint_about_points(bytes, "a.xyz.gz") : complaint;
}

}  // namespace flowcert::fuzz
