// The text of many records, made by several threads and written in the records' order.
//
// Guarantees: the text is the same for any number of threads. No more of it is kept than a few thousand records for
// each thread. An exception from a record stops it; what was written before stays written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "geometry/parallel_for.h"
#include "io/layer.h"

namespace flowcert::io {

// make(first, last, text) appends the text of the records from `first` to `last` - 1. write(text, done) takes it, with
// the number of records that are then done, and returns whether to go on.
template <class Make, class Write>
void write_in_order(std::size_t count, unsigned threads, const Make& make, const Write& write) {
  constexpr std::size_t kRecords = 512;  // of one text
  std::vector<std::string> texts(threads == 1 ? 1 : 8 * std::size_t{threads});
  for (std::size_t begun = 0; begun < count; begun += texts.size() * kRecords) {
    const std::size_t parts = std::min(texts.size(), (count - begun + kRecords - 1) / kRecords);
    geometry::parallel_for(parts, threads, [&](std::size_t k) {
      const std::size_t first = begun + k * kRecords;
      texts[k].clear();
      make(first, std::min(first + kRecords, count), texts[k]);
    });
    for (std::size_t k = 0; k < parts; ++k) {
      if (!write(texts[k], std::min(begun + (k + 1) * kRecords, count))) return;
    }
  }
}

}  // namespace flowcert::io
