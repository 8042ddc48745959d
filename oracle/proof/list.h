// Compares a list of stationary points, as flowcert compute -o writes it, with those that were found, in every field.
#pragma once

#include "json_reader.h"
#include "stationary_points.h"

struct Fraction {
  mpz_class numerator, denominator;
  int scale;  // of the quotient: times 2^scale

  std::string text() const {  // in lowest terms
    mpq_class quotient(numerator, denominator);
    quotient.canonicalize();
    (scale > 0 ? quotient <<= scale : quotient >>= -scale);
    return quotient.get_str();
  }
  // The nearest double, ties to even; infinite where that overflows.
  double nearest() const {
    mpz_class n = abs(numerator), d = abs(denominator), rest;
    const auto bits = [](const mpz_class& z) { return static_cast<int>(mpz_sizeinbase(z.get_mpz_t(), 2)); };
    // In units of 2^exponent, n / d has 55 or 56 bits, or fewer if the double is subnormal. The last bit is set if any
    // after it is. Two or three of them are rounded away.
    const int exponent = std::max(bits(n) - bits(d) + scale - 55, -1076);
    (scale > exponent ? n : d) <<= static_cast<mp_bitcnt_t>(std::abs(scale - exponent));
    mpz_tdiv_qr(n.get_mpz_t(), rest.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
    const std::uint64_t whole = n.get_ui() | (rest == 0 ? 0U : 1U);
    const int extra = whole >> 55 == 0 ? 2 : 3;
    const std::uint64_t rounded = (whole + (1U << extra >> 1) - 1 + (whole >> extra & 1)) >> extra;
    const double magnitude = std::ldexp(static_cast<double>(rounded), exponent + extra);
    return sgn(numerator) == sgn(denominator) ? magnitude : -magnitude;
  }
};

// Compares what a file has of stationary points, value by value, as they come.
class Comparison : public JsonReader {
 public:
  Comparison(std::string claim, const std::string& path, const Points& points, const StationaryPoints& stationary)
      : JsonReader(path), points_(points), stationary_(stationary), claim_(std::move(claim)) {}

  [[noreturn]] void refute_here(const std::string& what) const {
    refute(claim_ + " refuted: line " + std::to_string(line()) + ": " + what);
  }
  void compare(const std::string& key, const std::string& value) {
    need_key(key);
    compare_value(key, value);
  }
  void compare_value(const std::string& key, const std::string& value) {
    if (is_digit(value[0]) ? word() == value : take(value)) return;
    if (next() == EOF) fail("it is cut short");
    refute_here(key + " is not " + value);
  }
  static std::string text_of(const std::vector<std::size_t>& numbers) {
    std::string text = "[";
    for (const std::size_t number : numbers) text.append(text == "[" ? "" : ",").append(std::to_string(number));
    return text + "]";
  }

  void compare_header(const std::string& format) {
    need("{\"format\":\"" + format + "\",\"format_version\":1");
    const auto& n = stationary_.counts();
    need_key("points", {"version", "commit", "kernel", "compiler", "cgal", "input_sha256", "left_out"});
    compare_value("points", std::to_string(points_.row_count()));
    compare("merged_duplicates", std::to_string(points_.row_count() - points_.point_count()));
    compare("critical", text_of({n[0], n[1], n[2], n[3]}));
    compare("regular_stationary", "{\"1-2\":" + std::to_string(n[4]) + ",\"1-3\":" + std::to_string(n[5]) +
                                      ",\"2-3\":" + std::to_string(n[6]) + "}");
  }

  // Compares these fields of a stationary point, which come in this order.
  void compare_fields(const StationaryPoint& point, const std::vector<std::string>& fields) {
    const auto [from_first, denominator] = circumcenter<BigInteger>(points_, point.simplex);
    const mpz_class twice = 2 * denominator.value;
    const int exponent = points_.grid_exponent();
    const auto axis = [&](std::size_t k, const BigInteger& part) {
      return Fraction{points_.on_grid(point.simplex[0], k) * twice + part.value, twice, exponent};
    };
    const std::array<Fraction, 3> center{axis(0, from_first.x), axis(1, from_first.y), axis(2, from_first.z)};
    const Fraction squared{dot(from_first, from_first).value, twice * twice, 2 * exponent};
    for (const std::string& field : fields) {
      need_key(field);
      if (field == "contact") compare_value(field, text_of({point.contact.begin(), point.contact.end()}));
      if (field == "squared_distance") compare_value(field, "\"" + squared.text() + "\"");
      if (field == "squared_distance_double") compare_double(field, squared);
      if (field != "center" && field != "center_double") continue;
      for (std::size_t k = 0; k < 3; ++k) {
        need(k == 0 ? "[" : ",");
        if (field == "center") compare_value(field, "\"" + center[k].text() + "\"");
        if (field == "center_double") compare_double(field, center[k]);
      }
      need("]");
    }
  }

 private:
  void compare_double(const std::string& key, const Fraction& exact) {
    const double expected = exact.nearest();
    const std::string text = word();
    const std::size_t digits = text[0] == '-' ? 1 : 0, dot = text.find('.');
    const bool is_json = is_digit(text[digits]) && (text[digits] != '0' || !is_digit(text[digits + 1])) &&
                         (dot == std::string::npos || is_digit(text[dot + 1]));
    const char* at = text.c_str();
    double written = 0;
    if (!is_json && text != "null") fail("a number is due");
    if (read_decimal(at, written) && *at == '\0' && written == expected && std::isfinite(written)) return;
    if (text != "null" || std::isfinite(expected)) refute_here(key + " is not the nearest double");
  }
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  const Points& points_;
  const StationaryPoints& stationary_;
  const std::string claim_;
};

// Returns the fields of records that are proved, and the keys of the header that are not compared.
inline std::array<std::string, 2> compare_list(const std::string& path, const Points& points,
                                               const StationaryPoints& stationary) {
  Comparison list("list", path, points, stationary);
  list.compare_header("flowcert-stationary-points");
  std::vector<std::vector<std::size_t>> classes(points.row_count());  // by id
  for (Id row = 0; row < points.row_count(); ++row) classes[points.id_of_row(row)].push_back(row);
  std::string several;
  for (const auto& rows : classes) {
    if (rows.size() > 1) several.append(several.empty() ? "" : ",").append(Comparison::text_of(rows));
  }
  list.compare("classes", "[" + several + "]");
  std::vector<std::string> fields{"contact", "center", "squared_distance", "center_double", "squared_distance_double"};
  std::string key = list.key();
  if (key == "centers") {
    const std::string centers = list.string();
    if (centers != "double" && centers != "none") list.fail("centers is neither double nor none");
    fields.erase(fields.begin() + 1, centers == "none" ? fields.end() : fields.begin() + 3);
    key = list.key();
  }
  if (!key.empty()) list.fail("the key \"" + key + "\" is not proved");
  list.need("\n");

  static const std::array<std::string, 7> kIndices{"0", "1", "2", "3", "[1,2]", "[1,3]", "[2,3]"};
  for (const StationaryPoint& point : stationary.all()) {
    if (list.next() == EOF) list.refute_here("the list ends, and records are missing");
    list.need("{");
    list.compare("index", kIndices[point.kind]);
    list.compare("kind", point.kind <= kIndex3 ? "\"critical\"" : "\"regular\"");
    list.compare_fields(point, fields);
    list.need_key("");
    list.need("\n");
  }
  if (list.next() != EOF) list.refute_here("there are more records than stationary points");
  std::string proved = "index, kind";
  for (const std::string& field : fields) proved += ", " + field;
  return {proved, list.skipped()};
}
