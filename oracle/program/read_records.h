// Reads rationals, and a file of claimed stationary points: JSON Lines as in spec/formats/stationary_points.md.
//
// Text that cannot be understood throws UnusableInput: no JSON, a missing key, 1/0 for a number. Text that can be
// understood but is wrong gives a fault for the caller to report: a rational that is not written canonically, a
// kind that does not fit its index, a double that is not the nearest one.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// The parsed header line, and the text of the other lines. So only the records that are drawn have to be parsed.
struct RecordFile {
  std::size_t points = 0;
  std::size_t merged_duplicates = 0;
  std::vector<std::string> records;  // records[i] is line i + 2
};

// `name` is for messages only. A file is unusable if its header announces another number of records than it has.
RecordFile read_record_file(std::istream& in, const std::string& name);

struct Record {
  StationaryPoint claim;
  std::optional<Fault> fault;  // the first thing that is wrong with how the claim is written
};

// `where` opens the message of an UnusableInput.
Record parse_record(const std::string& line, const std::string& where);

// The value of a text like "-3/4", and whether it is written canonically (FC-NUM-02). Nothing if it is no rational.
struct WrittenRational {
  Rational value;
  bool canonical = false;
};
std::optional<WrittenRational> parse_rational(const std::string& text);

// A position X,Y,Z, separated by blanks or commas. Each coordinate is a number as in a point file, or a
// fraction p/q of integers. `where` opens the message of an UnusableInput.
Point parse_position(const std::string& text, const std::string& where);

// Whether `value` is the double nearest to x, ties to even. If x is beyond the midpoint between the greatest double
// and 2^1024, it has no nearest double.
bool is_nearest_double(double value, const Rational& x);

}  // namespace oracle
