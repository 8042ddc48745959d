// Both implementations' answers for an input, and what is wrong with them.
#pragma once

#include <sstream>
#include <string>

#include "fuzz/inputs/input.h"
#include "fuzz/properties/input_points.h"
#include "fuzz/properties/stationary_comparison.h"
#include "oracle/fast/point_set.h"

namespace flowcert::property {

inline StationaryAnswer fast_answer(const fuzz::Input& input) { return fast_answer(FlowComplex(point_set_of(input))); }

inline StationaryAnswer oracle_answer(const fuzz::Input& input) {
  return oracle_answer(oracle::fast::PointSet(input.rows));
}

struct Comparison {
  StationaryAnswer fast;
  StationaryAnswer oracle;
  // The first thing that is wrong between the two or with one of them, and both answers; empty if nothing is.
  std::string complaint;
};

inline Comparison compare(const fuzz::Input& input) {
  Comparison both{fast_answer(input), oracle_answer(input), {}};
  std::string complaint = difference(both.fast, both.oracle);
  for (const StationaryAnswer* answer : {&both.fast, &both.oracle}) {
    complaint = complaint.empty() ? broken_clause(*answer) : complaint;
  }
  if (!complaint.empty()) {
    std::ostringstream text;
    text << complaint << "\ninput:\n"
         << input << "the fast answer:\n"
         << to_text(both.fast) << "\nthe oracle's answer:\n"
         << to_text(both.oracle) << '\n';
    both.complaint = text.str();
  }
  return both;
}

}  // namespace flowcert::property
