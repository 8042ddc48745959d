// Histograms of what a computation counted, as the paper's Figures 10 to 12 have them: bins, and bars for people.
//
// Guarantees: every number is in one bin, and bins without numbers between others are there too. A bin with a number
// has a bar that can be seen. The bins depend on the numbers alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/layer.h"
#include "flowcert/flow_statistics.h"

namespace flowcert::cli {

// `count` numbers from `first` to `last`, both included.
struct Bin {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t count = 0;

  friend bool operator==(const Bin&, const Bin&) = default;
};

struct Histogram {
  std::string name;   // of a file
  std::string title;  // says what is counted
  std::string value;  // what a number is: "segments"
  bool is_logarithmic = false;
  std::vector<Bin> bins;
};

// At most 30 bins of one width, which is 1, 2 or 5 times a power of ten. Each begins at a multiple of the width.
[[nodiscard]] std::vector<Bin> equal_bins(const Distribution& distribution);

// From 2^k to 2^(k+1) - 1. There is a bin of its own for 0.
[[nodiscard]] std::vector<Bin> doubling_bins(const Distribution& distribution);

// The greatest count.
[[nodiscard]] std::size_t largest_count(const std::vector<Bin>& bins);

// A count's share of an axis that ends at `top`, from 0 to 1. A logarithmic axis begins at 1/2, so that a single number
// can be seen.
[[nodiscard]] double share_of_axis(double count, double top, bool is_logarithmic);

struct BarLine {
  std::string from, to;
  std::size_t count = 0;
  std::string mark;  // stands behind the bar
};

// A line for each bin, with its count and a bar.
void print_bars(const std::string& title, const std::vector<BarLine>& lines, bool is_logarithmic, bool has_marks);
void print_bars(const Histogram& histogram);

}  // namespace flowcert::cli
