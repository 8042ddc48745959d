// Each function reads one level of the file: a number, a record, the header with the list of lines.
//
// All rationals go through parse_rational. Boost's own constructor from text accepts "1/0". It keeps "2/4" unreduced,
// which then compares unequal to 1/2.
#include "oracle/program/read_records.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "oracle/program/read_points.h"

namespace oracle {

namespace {

using nlohmann::json;

const Rational kOverflow = 2 * Rational(std::ldexp(1.0, 1023));  // the double that would follow the greatest one

bool is_integer(const std::string& text) {
  const std::size_t first_digit = text.starts_with('-') ? 1 : 0;
  return text.size() > first_digit && text.find_first_not_of("0123456789", first_digit) == std::string::npos;
}

// GMP takes a leading 0 for octal, so the text has to lose it first.
Integer to_integer(const std::string& text) {
  const bool negative = text.starts_with('-');
  const std::size_t first = text.find_first_not_of("-0");
  const Integer magnitude = first == std::string::npos ? Integer(0) : Integer(text.substr(first));
  return negative ? Integer(-magnitude) : magnitude;
}

std::size_t natural_number(const json& value) {
  if (!value.is_number_unsigned()) throw UnusableInput("a point id or an index is no natural number");
  return value.get<std::size_t>();
}

// Keeps only the first fault.
void note(Record& result, const std::string& clause, const std::string& explanation) {
  if (!result.fault) result.fault = Fault{clause, explanation};
}

// FC-CRIT-03: a number for a critical point, the pair of the kind for a regular stationary one.
void read_index(const json& record, Record& result) {
  const json& index = record.at("index");
  const bool is_pair = index.is_array() && index.size() == 2;
  const std::size_t face = natural_number(is_pair ? index[0] : index);
  const std::size_t hull = natural_number(is_pair ? index[1] : index);
  if (face > 3 || hull > 3) throw UnusableInput("an index is greater than 3");
  result.claim.face_dimension = static_cast<int>(face);
  result.claim.hull_dimension = static_cast<int>(hull);
  const std::string kind = record.at("kind").get<std::string>();
  if (kind != (is_pair ? "regular" : "critical")) note(result, "FC-CRIT-03", kind + " does not fit the index");
  if (is_pair && face == hull) note(result, "FC-CRIT-03", "the kind names one dimension twice");
}

// A sign may stand only at the front of a fraction.
Rational coordinate(const std::string& word, const std::string& where) {
  if (word.find('/') == std::string::npos) return Rational(number(word, where));
  const bool has_sign_inside = word.find_first_of("+-", 1) != std::string::npos;
  const auto fraction = parse_rational(word.starts_with('+') ? word.substr(1) : word);
  if (!fraction || has_sign_inside) throw UnusableInput(where + "'" + word + "' is not a fraction");
  return fraction->value;
}

Rational read_rational(const json& value, Record& result) {
  const std::string text = value.get<std::string>();
  const auto written = parse_rational(text);
  if (!written) throw UnusableInput("'" + text + "' is not a rational");
  if (!written->canonical) note(result, "FC-NUM-02", text + " is not canonical: " + written->value.str());
  return written->value;
}

// Checks the double beside a rational. null is right iff the nearest double would overflow. The midpoint between the
// greatest double and 2^1024 overflows, because the greatest double is odd.
void check_double(const json& value, const Rational& x, Record& result) {
  const bool overflow = 2 * abs(x) >= Rational(std::numeric_limits<double>::max()) + kOverflow;
  if (value.is_null() ? !overflow : !is_nearest_double(value.get<double>(), x)) {
    note(result, "FC-NUM-02", "the double claimed to be nearest to " + x.str() + " is not");
  }
}

RecordFile parse_header(const std::string& line, std::size_t& announced) {
  const json header = json::parse(line);
  const std::string format = header.at("format").get<std::string>();
  if (format != "flowcert-stationary-points" && format != "oracle-stationary-points") {
    throw UnusableInput("the format is '" + format + "', not a list of stationary points");
  }
  if (header.at("format_version") != 1) throw UnusableInput("unknown format_version");
  announced = 0;
  for (const json& count : header.at("critical")) announced += count.get<std::size_t>();
  for (const json& count : header.at("regular_stationary")) announced += count.get<std::size_t>();
  return {header.at("points").get<std::size_t>(), header.at("merged_duplicates").get<std::size_t>(), {}};
}

// Runs `parse`, and puts `where` before the message of any exception.
template <typename Parse>
auto located(const std::string& where, const Parse& parse) {
  try {
    return parse();
  } catch (const std::exception& error) {
    throw UnusableInput(where + error.what());
  }
}

}  // namespace

std::optional<WrittenRational> parse_rational(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string numerator = text.substr(0, slash);
  const std::string denominator = slash == std::string::npos ? "1" : text.substr(slash + 1);
  if (!is_integer(numerator) || !is_integer(denominator) || to_integer(denominator) == 0) return std::nullopt;
  const Rational value = Rational(to_integer(numerator)) / Rational(to_integer(denominator));
  return WrittenRational{value, value.str() == text};
}

Point parse_position(const std::string& text, const std::string& where) {
  const std::vector<std::string> words = fields(text);
  if (words.size() != 3) {
    throw UnusableInput(where + "three coordinates X,Y,Z expected, found " + std::to_string(words.size()));
  }
  Point x;
  for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = coordinate(words[axis], where);
  return x;
}

bool is_nearest_double(double value, const Rational& x) {
  if (!std::isfinite(value)) return false;
  const bool odd = std::bit_cast<std::uint64_t>(value) & 1;  // of two that are equally near, the even one wins
  for (const double end : {-1.0, 1.0}) {
    const double neighbour = std::nextafter(value, end * std::numeric_limits<double>::infinity());
    const Rational other = std::isfinite(neighbour) ? Rational(neighbour) : Rational(end) * kOverflow;
    const Rational advantage = abs(other - x) - abs(Rational(value) - x);
    if (advantage < 0 || (advantage == 0 && odd)) return false;
  }
  return true;
}

Record parse_record(const std::string& line, const std::string& where) {
  return located(where, [&] {
    const json record = json::parse(line);
    Record result;
    read_index(record, result);
    for (const json& name : record.at("contact")) result.claim.contact.push_back(natural_number(name));
    for (const char* key : {"center", "squared_distance"}) {
      if (!record.contains(key))
        throw UnusableInput(std::string("no exact '") + key + "', so there is nothing to certify");
    }
    if (record.at("center").size() != 3) throw UnusableInput("center is not three rationals");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.claim.center[axis] = read_rational(record.at("center").at(axis), result);
      if (record.contains("center_double")) {
        check_double(record["center_double"].at(axis), result.claim.center[axis], result);
      }
    }
    result.claim.squared_distance = read_rational(record.at("squared_distance"), result);
    if (record.contains("squared_distance_double")) {
      check_double(record["squared_distance_double"], result.claim.squared_distance, result);
    }
    return result;
  });
}

// The line of what flows to infinity is no record of a point.
bool is_of_infinity(const std::string& line) {
  if (line.find("\"infinity\"") == std::string::npos) return false;
  const json record = json::parse(line, nullptr, false);
  return record.is_object() && record.contains("kind") && record["kind"] == "infinity";
}

RecordFile read_record_file(std::istream& in, const std::string& name) {
  std::string line;
  if (!std::getline(in, line)) throw UnusableInput(name + ": empty or unreadable");
  std::size_t announced = 0;
  RecordFile file = located(name + ":1: ", [&] { return parse_header(line, announced); });
  while (std::getline(in, line)) {
    if (!is_of_infinity(line)) file.records.push_back(line);
  }
  if (file.records.size() != announced) {
    throw UnusableInput(name + ": the header announces " + std::to_string(announced) + " records, the file has " +
                        std::to_string(file.records.size()));
  }
  return file;
}

}  // namespace oracle
