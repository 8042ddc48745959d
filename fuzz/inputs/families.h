// The families of inputs that tests and fuzzers draw from: degenerate on purpose, each in its own way.
//
// Guarantees: an input is a function of family, seed and size alone: the same on every machine and with every
// standard library (integers come from RapidCheck's own generator, and only operations that IEEE 754 rounds
// correctly make doubles of them). All coordinates are finite. Whatever is drawn shrinks to fewer points
// first, then to smaller integers, and stays of its family in spirit: a nudge by one ulp shrinks to no nudge,
// a tilted plane to a level one. A family states how often it keeps what its name says, and tests hold it to
// that.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

// The least shares of inputs with a feature, in percent, over sizes 0 to 100 alike.
struct Promise {
  int four_points = 0;  // at least four distinct points
  int cluster = 0;      // a stationary point with more contacts than a simplex of its dimension has
  int kind12 = 0;       // a regular stationary point of kind (1,2), and so on
  int kind23 = 0;
  int kind13 = 0;
  int coplanar = 0;    // the points span a plane
  int collinear = 0;   // three distinct points and more, spanning a line
  int duplicates = 0;  // a row that repeats another
  int degenerate = 0;  // a cluster or a regular stationary point
};

struct Family {
  std::string name;  // kebab-case
  std::string description;
  std::function<rc::Gen<Input>()> generate;
  Promise promise;
};
// Prints the family's name, by which reports call a test that has a family as its parameter.
std::ostream& operator<<(std::ostream& out, const Family& family);

const std::vector<Family>& families();

// `size` is RapidCheck's, from 0 to 100. A larger size gives more points.
Input draw(const Family& family, std::uint64_t seed, int size);

}  // namespace flowcert::fuzz
