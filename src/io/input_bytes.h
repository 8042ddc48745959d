// Files as bytes in memory, and the contents of gzip streams.
#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

// The bytes of the file at `path`; "-" is standard input. Throws InvalidInput "FILE: reason" if the file cannot be
// opened or read. progress, if any, is called after each block, and when a signal interrupts the wait for one.
[[nodiscard]] std::string read_bytes(const std::string& path, const std::function<void()>& progress = {});

// Whether the file with this status is one that this process has read, so that no output takes its place. A file is
// known by its device and inode, whatever its name, also as standard input. One that is gone since is known no more, so
// that its inode may have a new file. Any thread may call this.
[[nodiscard]] bool is_input(const struct stat& status);

// What compressed data may grow to, in bytes: a hundred times what they are, and a megabyte where they are short, but
// no more than 4 GB. Points and claims take a tenth of their size at the least; what takes a hundredth was made to fill
// memory. --unlimited lifts it.
[[nodiscard]] std::uint64_t most_content(std::size_t compressed, bool is_unlimited);
// What is said of data that grow beyond it. what: "gzip data".
[[nodiscard]] std::string complaint_about_growth(const std::string& what);

// Gzip, from memory to memory.
//
// Guarantees: all or nothing. A stream that is cut short, fails its checksum, grows beyond most_content(), or is
// followed by anything but another stream or zero bytes (padding) throws InvalidInput "FILE: reason". Memory is bounded
// by twice the decompressed size.

// Whether the first two bytes are those of a gzip stream.
[[nodiscard]] bool is_gzip(std::string_view bytes);

// The concatenated contents of the streams (RFC 1952: a file may hold several) in `bytes`.
[[nodiscard]] std::string gunzip(std::string_view bytes, std::string_view file, bool is_unlimited = false);

// A file of UTF-8 may begin with it.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view bytes);

// What a reader of a format takes: the contents of `bytes` without gzip, for which `decompressed` is the place, and
// without a byte order mark. Throws InvalidInput "FILE: empty" if they are blank.
[[nodiscard]] std::string_view plain_content(std::string_view bytes, std::string_view file, std::string& decompressed,
                                             bool is_unlimited = false);

}  // namespace flowcert::io
