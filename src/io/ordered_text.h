// The text of many records, made by several threads and written in the records' order.
//
// Guarantees: the text is the same for any number of threads. Eight texts are kept for each thread, and one where
// there is one thread. An exception from a record stops it; what was written before stays written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "geometry/parallel_for.h"
#include "io/layer.h"

namespace flowcert::io {

// How many records one text has: many short ones, or few where each may take a megabyte.
inline constexpr std::size_t kShortRecords = 512, kLongRecords = 4;

// make(first, last, text) appends the text of the records from `first` to `last` - 1. write(text, done) takes it, with
// the number of records that are then done, and returns whether to go on.
template <class Make, class Write>
void write_in_order(std::size_t count, std::size_t records, unsigned threads, const Make& make, const Write& write) {
  std::vector<std::string> texts(threads <= 1 ? 1 : 8 * std::size_t{threads});
  for (std::size_t begun = 0; begun < count; begun += texts.size() * records) {
    const std::size_t parts = std::min(texts.size(), (count - begun + records - 1) / records);
    geometry::parallel_for(parts, threads, [&](std::size_t k) {
      const std::size_t first = begun + k * records;
      texts[k].clear();
      make(first, std::min(first + records, count), texts[k]);
    });
    for (std::size_t k = 0; k < parts; ++k) {
      if (!write(texts[k], std::min(begun + (k + 1) * records, count))) return;
    }
  }
}

}  // namespace flowcert::io
